// The stiffness of contact with volumes against what the run meets: an automatic one is raised until lines
// are no deeper than they may be, and one that is too soft for that, and not the program's, is refused.
// docs/theory/contact.md, "Stiffness that follows the run".
#include <algorithm>
#include <cmath>

#include "hawser/geometry/surface.hpp"
#include "hawser/terms/contact_stiffness.hpp"
#include "hawser/terms/line_contact.hpp"
#include "hawser/terms/volume_contact.hpp"

namespace hawser {
namespace {

// Of the radius, deeper than which an automatic stiffness is raised; how often that in motion; to what of it.
constexpr double kAllowed = 0.004, kMoving = 2, kRaisedTo = 0.25;
// Of the radius: what a blow may take it in by, with all of its mass at all of its speed.
constexpr double kBlow = 0.5;
// Of the period of the mass on its spring: shorter steps follow a blow, and what is deep in them is the
// blow's.
constexpr double kFollowing = 2;
// Most that what presses raises a stiffness in a step: what grows faster is a blow.
constexpr double kMostInAStep = 4;

// A raise is solved again with, and what it is for moves with it: less than this is left.
constexpr double kWorthIt = 1.05;

// The part of a force that is left when inertia has taken `mass` times the acceleration [m/s²] away from the
// surface.
double left_by_inertia(double force, double mass, double acceleration) {
  return force > 0 ? std::clamp(1 - mass * acceleration / force, 0.0, 1.0) : 1;
}

// Whether what is pressed in moves so slowly that its speed is worth no more than a sixteenth of the spring's
// energy: it is pressed, and does not strike or leap.
bool resting(double stiffness, double depth, double mass, double speed) {
  return stiffness * std::pow(0.25 * depth, 2) >= mass * speed * speed;
}

}  // namespace

std::vector<double> Contact::stiffnesses() const {
  std::vector<double> all;
  for (const ContactVolume& v : volumes_) all.push_back(v.settings.normal_stiffness);
  return all;
}

void Contact::raise_to(int volume, double stiffness) {
  const size_t k = static_cast<size_t>(volume);
  if (!automatic(volume)) return;
  volumes_[k].settings.normal_stiffness = committed_stiffness_[k] =
      std::max(stiffness, committed_stiffness_[k]);
}

void Contact::ask(int volume, const NormalLaw& law, const Pressed& p, double step,
                  std::vector<double>& wanted) const {
  const size_t k = static_cast<size_t>(volume);
  const double now = volumes_[k].settings.normal_stiffness, given = volumes_[k].settings.allowed_penetration;
  const double allowed = given > 0 ? given : kAllowed * p.radius, blow = kBlow * p.radius;
  double& want = wanted[k];
  if (p.held) return;
  const bool follows_a_blow =
      step > 0 && p.mass > 0 && step < kFollowing * contact_period(law.stiffness, p.mass);
  if (!follows_a_blow && p.still * p.depth > (step > 0 ? kMoving : 1) * allowed) {
    const double pressed = now * p.still * p.depth / (kRaisedTo * allowed);
    want = std::max(want, step > 0 ? std::min(pressed, kMostInAStep * committed_stiffness_[k]) : pressed);
  }
  // u sqrt(m/k) is how deep a blow goes.
  if (step > 0) want = std::max(want, now * p.mass * std::pow(p.speed / blow, 2) / law.stiffness);
  if (p.depth > (follows_a_blow ? blow : p.radius))
    want = std::max(want, now * std::pow(2 * p.depth / p.radius, 2));
}

bool Contact::raise(std::vector<double>& wanted) {
  if (std::none_of(volumes_.begin(), volumes_.end(), [](const ContactVolume& v) { return v.automatic; }))
    return false;
  MPI_Allreduce(MPI_IN_PLACE, wanted.data(), static_cast<int>(wanted.size()), MPI_DOUBLE, MPI_MAX, comm_);
  bool more = false;
  for (size_t k = 0; k < wanted.size(); ++k) {
    ContactVolume& v = volumes_[k];
    const double to = std::min(wanted[k], v.most);
    if (!v.automatic || !(to > kWorthIt * v.settings.normal_stiffness)) continue;
    v.settings.normal_stiffness = to;
    more = true;
  }
  return more;
}

bool Contact::forget_raise() {
  bool changed = false;
  for (size_t k = 0; k < volumes_.size(); ++k) {
    changed = changed || raised(static_cast<int>(k));
    volumes_[k].settings.normal_stiffness = committed_stiffness_[k];
  }
  return changed;
}

void Contact::keep_raise() { committed_stiffness_ = stiffnesses(); }

double Contact::deepest(int volume, double radius) const {
  const ContactVolume& c = volumes_[static_cast<size_t>(volume)];
  const model::Volume& v = c.settings;
  // A plane has no other side that a line could come to: a soft floor is a floor.
  if (!c.automatic && dynamic_cast<const PlaneSurface*>(c.surface.get())) return HUGE_VAL;
  return v.force_table ? std::max(radius, v.force_table->rows().back().first) : radius;
}

std::string Contact::deeper_than_allowed(const Kinematics& trial) const {
  const TooDeep at = too_deep(trial);
  if (at.node < 0) return {};
  const ContactVolume& v = volumes_[static_cast<size_t>(at.volume)];
  return too_soft_for_line(lines().place(at.node), v.settings, v.automatic, at.depth, at.radius, trial.time);
}

bool LineContact::stiffen(const Kinematics& equilibrium) {
  pose_bodies(equilibrium, poses_);
  std::vector<double> wanted = stiffnesses();
  for (Pair& pair : pairs_) {
    const bool touches = !pair.found.panels.empty() || pair.walls;
    if (!automatic(pair.volume) || (!touches && !(equilibrium.step > 0))) continue;
    const LineContactElement& element = elements_[static_cast<size_t>(pair.element)];
    const LocalElement& e = mesh_.elements[static_cast<size_t>(pair.element)];
    const AxisShape shape(ends(equilibrium, pair.element));
    const RigidPose& pose = poses_[body(pair.volume)];
    Pressed at;
    at.radius = element.radius, at.mass = element.mass_per_length, at.held = element.held;
    for (const double xi : {0.0, 1.0})
      at.speed = std::max(at.speed, (shape.velocity(xi) - pose.velocity_at(shape.point(xi))).norm());
    if (touches) {
      const Found& found = find(pair, shape, pose);
      double force = 0;  // N, of all of it
      Vec3 normal = Vec3::Zero();
      for (size_t i = 0; i < found.points.size(); ++i) {
        const SurfacePoint& p = found.points[i];
        if (!seen(pair, p)) continue;
        const ContactStretch& s = found.panels[i / ContactRule::kPoints];
        const double gap = p.distance - element.radius;
        force += length(pair.element) * (s.to - s.from) * ContactRule::weight()[i % ContactRule::kPoints] *
                 normal_force(pair.law.normal, gap, 0).elastic;
        if (-gap > at.depth) at.depth = -gap, normal = pose.rotation * p.normal;
      }
      const size_t first = static_cast<size_t>(e.first), second = static_cast<size_t>(e.second);
      const Vec3 place = 0.5 * (equilibrium.x[first] + equilibrium.x[second]);
      const double speed =
          normal.dot(0.5 * (equilibrium.v[first] + equilibrium.v[second]) - pose.velocity_at(place));
      if (equilibrium.step > 0 && resting(pair.law.normal.stiffness, at.depth, at.mass, speed))
        at.still = left_by_inertia(force, element.mass_per_length * length(pair.element),
                                   0.5 * normal.dot(equilibrium.a[first] + equilibrium.a[second]));
      else if (equilibrium.step > 0)
        at.still = 0;
    }
    ask(pair.volume, pair.law.normal, at, equilibrium.step, wanted);
  }
  if (!raise(wanted)) return false;
  renew_laws();
  return true;
}

void LineContact::renew_laws() {
  for (Pair& pair : pairs_)
    pair.law =
        element_law(static_cast<size_t>(pair.element), volumes_[static_cast<size_t>(pair.volume)].settings);
}

void LineContact::forget_stiffening() {
  if (forget_raise()) renew_laws();
}

Contact::TooDeep LineContact::too_deep(const Kinematics& trial) const {
  TooDeep at;
  for (const Pair& pair : pairs_) {
    const LineContactElement& element = elements_[static_cast<size_t>(pair.element)];
    if (element.held) continue;
    const double most = deepest(pair.volume, element.radius);
    for (size_t i = 0; i < pair.found.points.size(); ++i) {
      const double depth = element.radius - pair.found.points[i].distance;
      // What did not move since it was clear is not looked at in a trial, and keeps what it was before.
      if (!(depth > std::max(most, at.depth)) ||
          !pair.found.shape.same_axis(AxisShape(ends(trial, pair.element))))
        continue;
      const ContactStretch& s = pair.found.panels[i / ContactRule::kPoints];
      const LocalElement& e = mesh_.elements[static_cast<size_t>(pair.element)];
      const double xi = s.from + (s.to - s.from) * ContactRule::place()[i % ContactRule::kPoints];
      at = {mesh_.global[static_cast<size_t>(xi < 0.5 ? e.first : e.second)], pair.volume, depth,
            element.radius};
    }
  }
  return at;
}

bool VolumeContact::stiffen(const Kinematics& equilibrium) {
  pose_bodies(equilibrium, poses_);
  std::vector<double> wanted = stiffnesses();
  for (Pair& pair : pairs_) {
    if (!automatic(pair.volume)) continue;
    const size_t n = static_cast<size_t>(pair.node);
    const RigidPose& pose = poses_[body(pair.volume)];
    const Vec3& x = equilibrium.x[n];
    Pressed at;
    at.radius = nodes_[n].radius, at.mass = nodes_[n].mass;
    if (equilibrium.step > 0) at.speed = (equilibrium.v[n] - pose.velocity_at(x)).norm();
    ContactTrial trial;
    if (locate(pair, pose.to_body(x), 0.5 * element_[n], trial)) {
      at.depth = std::max(0.0, -trial.gap);
      if (equilibrium.step > 0)
        at.still = left_by_inertia(normal_force(pair.law.normal, trial.gap, 0).elastic, at.mass,
                                   (pose.rotation * trial.normal).dot(equilibrium.a[n]));
    }
    ask(pair.volume, pair.law.normal, at, equilibrium.step, wanted);
  }
  if (!raise(wanted)) return false;
  for (Pair& pair : pairs_) pair.law = node_law(pair.node, pair.volume);
  return true;
}

void VolumeContact::forget_stiffening() {
  if (!forget_raise()) return;
  for (Pair& pair : pairs_) pair.law = node_law(pair.node, pair.volume);
}

Contact::TooDeep VolumeContact::too_deep(const Kinematics&) const {
  TooDeep at;
  if (model_ == NodeContact::gap) return at;  // a spring through the air may be as long as it likes
  for (const Pair& pair : pairs_) {
    const size_t n = static_cast<size_t>(pair.node);
    if (!pair.seen) continue;
    const double radius = nodes_[n].radius, depth = radius - pair.seen->distance;
    if (depth > std::max(deepest(pair.volume, radius), at.depth))
      at = {global_[n], pair.volume, depth, radius};
  }
  return at;
}

}  // namespace hawser
