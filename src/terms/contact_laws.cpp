// Normal and friction laws of contact from the settings of a volume, and the penetration limit of a step.
#include "hawser/terms/contact_laws.hpp"

namespace hawser {
NormalLaw normal_law(const model::Volume& v, double factor, double smoothing, double mass) {
  NormalLaw law;
  law.stiffness = v.normal_stiffness * factor;
  law.smoothing = v.force_table ? 0 : v.smoothing.value_or(smoothing);
  law.table = v.force_table.get();
  law.table_factor = factor;
  law.damping = contact_damping(v.relative_damping, law.stiffness, mass);
  return law;
}

FrictionLaw friction_law(const model::Friction& f, double factor, double diameter) {
  FrictionLaw law;
  law.axial = f.axial;
  law.lateral = f.lateral;
  law.stiffness = f.shear_stiffness * factor;
  law.axial_length = f.mobilisation_length > 0 ? f.mobilisation_length : 0.01 * diameter;
  law.lateral_length = f.lateral_mobilisation_length > 0 ? f.lateral_mobilisation_length : law.axial_length;
  law.return_rule = f.return_rule;
  law.spring = f.spring;
  law.axial_kinetic = f.axial_kinetic;
  law.lateral_kinetic = f.lateral_kinetic;
  law.blend_speed = f.blend_speed;
  return law;
}

ContactLaw contact_law(const model::Volume& v, double factor, double diameter, double mass) {
  ContactLaw law;
  // Default half width d of the ramp of the normal force, 0.2 % of the line's radius r. Automatic stiffness
  // lets its load penetrate by a = kAllowedPenetration r = 0.5 % of r, thus d = 2/5 a: the ramp ends at the
  // force k d, two fifths of that load k a, and at the load the law is its linear branch k p.
  law.normal = normal_law(v, factor, 0.001 * diameter, mass);
  law.friction = friction_law(v.friction, factor, diameter);
  return law;
}

void limit_depth(double radius, const Approach& at, ImpactEvents& to) {
  if (at.closing > 0) to.limit((std::max(at.gap, 0.0) + 0.5 * radius) / at.closing);
}

}  // namespace hawser
