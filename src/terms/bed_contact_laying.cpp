// The class BedContact: friction in statics, with slip counted from where the lines were laid
// (docs/theory/seabed.md).
#include <cmath>

#include "hawser/terms/bed_contact.hpp"

namespace hawser {

PressedFriction BedContact::pressed_friction_at(const Point& p, const Vec3& x) const {
  const LaidReference& from = laid_[index_of(p)];
  if (!from.known()) return {};
  FrictionLaw law = this->law(p).law.friction;
  if (full_friction_ && friction_ == FrictionMode::pressed) law.stiffness = this->law(p).axial_stiffness;
  return pressed_friction(law, from.normal_force, from.slip + (x - from.place), from.normal,
                          starts_[index_of(p)].direction, full_slip_);
}

void BedContact::lay(const std::vector<Vec3>& places, const Kinematics& start, bool full_friction) {
  laid_.assign(points_.size(), {});
  friction_ = FrictionMode::pressed;
  full_friction_ = full_friction;
  for (const Point& p : points_) {
    LaidReference& laid = laid_[index_of(p)];
    laid.place = of_nodes(p, places);
    if (!laid.known()) continue;
    ContactTrial at;
    // In a start shape lines lie on the bed only to within its deformation, so a gap of up to one radius
    // counts as contact.
    const double near = law(p).radius;
    locate(p, of_nodes(p, start.x), std::max(near, 0.0), at);
    laid.normal = at.normal;
    if (at.gap < std::max(near, law(p).law.normal.smoothing))
      laid.normal_force = std::max(0.0, law(p).weight * laid.normal.z());
  }
}

void BedContact::press_by_contact(const Kinematics& state) {
  for (const Point& p : points_) {
    ContactTrial trial;
    LaidReference& laid = laid_[index_of(p)];
    if (laid.known()) laid.normal_force = contact(p, state, false, trial).along_normal.force;
  }
}

void BedContact::use_contact_friction(const Kinematics& state) {
  for (const Point& p : points_) {
    LaidReference& laid = laid_[index_of(p)];
    if (!full_friction_ || !(laid.normal_force > 0)) continue;
    const Vec3 x = of_nodes(p, state.x);
    const Vec3 moved = x - laid.place;
    laid.slip = moved - laid.normal * laid.normal.dot(moved) +
                slip_of_force(law(p).law.friction, laid.normal_force, pressed_friction_at(p, x).force,
                              laid.normal, starts_[index_of(p)].direction);
    laid.place = x;
  }
  friction_ = FrictionMode::contact;
  full_slip_ = 0;
}

std::vector<BedContact::OnBed> BedContact::on_bed(const Kinematics& state) const {
  constexpr double kMobilised = 0.99;
  std::vector<OnBed> out(mesh_.mesh->lines.size());
  for (const Point& p : points_) {
    const PointHistory& h = history(p);
    if (!p.counted || !h.active) continue;
    OnBed& line = out[mesh_.node(p.node).line];
    const FrictionLaw& f = law(p).law.friction;
    if (!f.active() || !(laid() && laid_[index_of(p)].known())) continue;
    line.friction_length += law(p).length;
    const Vec3 t = line_direction(p, state);
    const double along = h.friction.dot(t);
    const double across = (h.friction - along * t).norm();
    const double a = f.axial > 0 ? along / (f.axial * h.normal_force) : 0;
    const double l = f.lateral > 0 ? across / (f.lateral * h.normal_force) : 0;
    if (std::hypot(a, l) < kMobilised) line.sticking += law(p).length;
    line.friction_tension += along;
  }
  return out;
}

}  // namespace hawser
