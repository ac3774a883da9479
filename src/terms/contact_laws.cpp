// From the settings of a volume to the normal and friction laws of contact with it, and the limits that a
// contact spring sets to the time step.
#include "hawser/terms/contact_laws.hpp"

#include <cmath>

namespace hawser {
namespace {

// s, period over 2 pi.
double slowness(const ContactSpring& s) { return std::sqrt(s.mass / s.law.stiffness); }
// m. The default ramp is as wide; a linear spring has none.
double width(const ContactSpring& s) { return std::max(s.law.smoothing, 0.002 * s.radius); }

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

ContactLaw contact_law(const model::Volume& v, double share, double diameter, double mass) {
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

std::optional<ImpactEvent> ContactSpring::impact(double share, const Approach& at) const {
  return impact_event(slowness(*this), width(*this), mass * share, at);
}

bool ContactSpring::may_impact(double speed, double acceleration) const {
  return hawser::may_impact(slowness(*this), width(*this), speed, acceleration);
}

bool ContactSpring::follows(double h) const { return hawser::follows(slowness(*this), h); }

double ContactSpring::crossing_error(double share, double force, double potential, double path,
                                     double speed) const {
  return share * hawser::crossing_error(slowness(*this), width(*this), force, potential, path, speed);
}

void limit_depth(double radius, const Approach& at, ImpactEvents& to) {
  if (at.closing > 0) to.limit((std::max(at.gap, 0.0) + 0.5 * radius) / at.closing);
}

}  // namespace hawser
