#include "hawser/terms/contact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hawser {
namespace {

// The default ramp is as wide; a linear spring has none.
double width(const NormalLaw& law, double radius) { return std::max(law.smoothing, 0.002 * radius); }

}  // namespace

NormalLaw normal_law(const model::Volume& v, double share, double smoothing, double mass) {
  NormalLaw law;
  law.stiffness = v.normal_stiffness * share;
  law.smoothing = v.force_table ? 0 : v.smoothing >= 0 ? v.smoothing : smoothing;
  law.table = v.force_table.get();
  law.table_factor = share;
  law.damping = contact_damping(v.relative_damping, law.stiffness, mass);
  return law;
}

Contact::Contact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                 std::vector<ContactVolume> volumes, MPI_Comm comm)
    : bodies_(std::move(bodies)), volumes_(std::move(volumes)), local_(mesh), comm_(comm) {
  if (!bodies_) bodies_ = std::make_shared<const Bodies>();
  for (const ContactVolume& v : volumes_) {
    if (!v.surface) throw std::invalid_argument("volume " + v.settings.name + " has no surface");
    if (v.body >= bodies_->size())
      throw std::invalid_argument("volume " + v.settings.name + " has no such body");
    if (v.settings.basis == model::StiffnessBasis::automatic || !(v.settings.normal_stiffness > 0))
      throw std::invalid_argument("volume " + v.settings.name + " has no contact stiffness");
    boxes_.push_back(v.surface->bounds());
    committed_stiffness_.push_back(v.settings.normal_stiffness);
  }
  poses_.resize(static_cast<size_t>(bodies_->size()) + 1);
  for (int b = 0; b < bodies_->size(); ++b) poses_[static_cast<size_t>(b) + 1] = bodies_->pose(b, 0.0);
  start_poses_ = poses_;
}

void Contact::leave_out(std::vector<LeftOut> ends) {
  left_out_ = std::move(ends);
  std::sort(left_out_.begin(), left_out_.end(), [](const LeftOut& a, const LeftOut& b) {
    return std::pair(a.line, a.volume) < std::pair(b.line, b.volume);
  });
}

Contact::Share Contact::takes_part(const Mesh& mesh, int line, int volume, double from, double to) const {
  const std::pair key(line, volume);
  const auto found = std::lower_bound(left_out_.begin(), left_out_.end(), key, [](const LeftOut& l, auto k) {
    return std::pair(l.line, l.volume) < k;
  });
  if (found == left_out_.end() || std::pair(found->line, found->volume) != key) return {};
  const double end = mesh.lines[static_cast<size_t>(line)].length - found->end_b, span = to - from;
  // A single place, or a stretch.
  if (!(span > 0)) return from >= found->end_a && from <= end ? Share{} : Share{1, 0};
  return {std::max(0.0, (found->end_a - from) / span), std::min(1.0, (end - from) / span)};
}

ContactLaw Contact::law(const model::Volume& v, double share, double diameter, double mass) {
  ContactLaw law;
  // A fifth of the penetration the automatic stiffness allows: the ramp stays small beside it.
  law.normal = normal_law(v, share, 0.001 * diameter, mass);
  law.friction.axial = v.friction.axial;
  law.friction.lateral = v.friction.lateral;
  law.friction.stiffness = v.friction.shear_stiffness * share;
  const double length = v.friction.mobilisation_length > 0 ? v.friction.mobilisation_length : 0.01 * diameter;
  const double lateral = v.friction.lateral_mobilisation_length;
  law.friction.axial_length = length;
  law.friction.lateral_length = lateral > 0 ? lateral : length;
  law.friction.back = v.friction.back;
  law.friction.spring = v.friction.spring;
  law.friction.axial_kinetic = v.friction.axial_kinetic;
  law.friction.lateral_kinetic = v.friction.lateral_kinetic;
  law.friction.blend_speed = v.friction.blend_speed;
  return law;
}

void Contact::limit_depth(double radius, const Approach& at, Strikes& to) {
  if (at.closing > 0) to.limit((std::max(at.gap, 0.0) + 0.5 * radius) / at.closing);
}

bool Contact::may_strike(const NormalLaw& law, double mass, double radius, double speed,
                         double acceleration) {
  return hawser::may_strike(std::sqrt(mass / law.stiffness), width(law, radius), speed, acceleration);
}

std::optional<Strike> Contact::strikes(const NormalLaw& law, double mass, double share, double radius,
                                       const Approach& at) {
  return strike(std::sqrt(mass / law.stiffness), width(law, radius), mass * share, at);
}

double Contact::made(const NormalLaw& law, double mass, double share, double radius,
                     const ContactHistory& was, double away, double speed) {
  return share * made_by_parting(std::sqrt(mass / law.stiffness), width(law, radius),
                                 was.normal_force - was.damping_force, was.potential, away, speed);
}

bool Contact::follows(const NormalLaw& law, double mass, double h) {
  return hawser::follows(std::sqrt(mass / law.stiffness), h);
}

Contact::StepOfBody::StepOfBody(const RigidPose& before, const RigidPose& after, bool prescribes)
    : R0(before.rotation.toRotationMatrix()),
      R1(after.rotation.toRotationMatrix()),
      shift(after.position - before.position),
      prescribed(prescribes) {}

void Contact::add_work(Account& sum, const StepOfBody& b, const ContactHistory& p, const Mat3& R,
                       const Vec3& y0, const Vec3& y1, double share) {
  const Vec3 relative = 0.5 * (b.R0 + b.R1) * (y1 - y0);
  const Vec3 carried = b.shift + 0.5 * (b.R1 - b.R0) * (y0 + y1);
  const double w = 0.5 * share;
  sum.friction -= w * (R * p.friction).dot(relative);
  sum.damping -= w * p.damping_force * (R * p.normal).dot(relative);
  if (b.prescribed) sum.work += w * (R * p.force).dot(carried);
}

void Contact::Questions::add(int volume, size_t who, const SurfaceQuestion& question) {
  const size_t k = static_cast<size_t>(volume);
  if (of_.size() <= k) of_.resize(k + 1), who_.resize(k + 1);
  of_[k].push_back(question);
  who_[k].push_back(who);
}

}  // namespace hawser
