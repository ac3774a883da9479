#include "hawser/terms/contact.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace hawser {

Contact::Contact(std::shared_ptr<const Bodies> bodies, std::vector<ContactVolume> volumes)
    : bodies_(std::move(bodies)), volumes_(std::move(volumes)) {
  if (!bodies_) bodies_ = std::make_shared<const Bodies>();
  for (const ContactVolume& v : volumes_) {
    if (!v.surface) throw std::invalid_argument("volume " + v.settings.name + " has no surface");
    if (v.body >= bodies_->size())
      throw std::invalid_argument("volume " + v.settings.name + " has no such body");
    if (v.settings.basis == model::StiffnessBasis::automatic || !(v.settings.normal_stiffness > 0))
      throw std::invalid_argument("volume " + v.settings.name + " has no contact stiffness");
    boxes_.push_back(v.surface->bounds());
  }
  pose_bodies(0, poses_);
  start_poses_ = poses_;
}

ContactLaw Contact::law(const model::Volume& v, double share, double diameter, double mass) {
  ContactLaw law;
  law.normal.stiffness = v.normal_stiffness * share;
  // A fifth of the penetration the automatic stiffness allows: the ramp stays small beside it.
  law.normal.smoothing = v.smoothing > 0 ? v.smoothing : 0.001 * diameter;
  law.normal.damping = contact_damping(v.relative_damping, law.normal.stiffness, mass);
  law.friction.axial = v.friction.axial;
  law.friction.lateral = v.friction.lateral;
  law.friction.stiffness = v.friction.shear_stiffness * share;
  const double length = v.friction.mobilisation_length > 0 ? v.friction.mobilisation_length : 0.01 * diameter;
  law.friction.axial_length = law.friction.lateral_length = length;
  return law;
}

void Contact::pose_bodies(double time, std::vector<RigidPose>& poses) const {
  const int n = bodies_->size();
  poses.resize(static_cast<size_t>(n) + 1);
  for (int b = 0; b < n; ++b) poses[static_cast<size_t>(b) + 1] = bodies_->pose(b, time);
}

Contact::StepOfBody::StepOfBody(const RigidPose& before, const RigidPose& after)
    : R0(before.rotation.toRotationMatrix()),
      R1(after.rotation.toRotationMatrix()),
      shift(after.position - before.position) {}

void Contact::add_work(Account& sum, const StepOfBody& b, const ContactHistory& p, const Mat3& R,
                       const Vec3& y0, const Vec3& y1, double share) {
  const Vec3 relative = 0.5 * (b.R0 + b.R1) * (y1 - y0);
  const Vec3 carried = b.shift + 0.5 * (b.R1 - b.R0) * (y0 + y1);
  const double w = 0.5 * share;
  sum.friction -= w * (R * p.friction).dot(relative);
  sum.damping -= w * p.damping_force * (R * p.normal).dot(relative);
  sum.work += w * (R * p.force).dot(carried);
}

AutomaticStiffness automatic_contact_stiffness(double radius, double weight, double length, double EA) {
  const double tension = std::max(weight * length, 1e-4 * EA), bend = std::max(radius, 1.0);
  const double pressure = tension / bend, allowed = 0.005 * radius;
  const auto number = [](double v) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", v);
    return std::string(text);
  };
  return {pressure / allowed,
          "contact stiffness " + number(pressure / allowed) + " N/m per metre of line: a tension of " +
              number(tension) + " N (" +
              (weight * length >= 1e-4 * EA ? "the line's weight" : "1e-4 of its EA, more than its weight") +
              ") bent to a radius of " + number(bend) + " m presses in by 0.5 % of the line's radius, " +
              number(allowed) + " m"};
}

}  // namespace hawser
