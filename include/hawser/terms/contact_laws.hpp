// Contact laws of a volume, and step lengths that resolve their springs.
#pragma once

#include <algorithm>
#include <cmath>

#include "hawser/kernels/impact.hpp"
#include "hawser/kernels/surface_contact_law.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// factor: from the stiffness and force table of the volume to those of the contact (a node, a length).
// smoothing [m]: default if the volume has none. mass: effective mass for the damping, kg per unit of the
// law.
NormalLaw normal_law(const model::Volume& v, double factor, double smoothing, double mass);
// diameter: of the line, m; it determines the default mobilisation length of friction.
FrictionLaw friction_law(const model::Friction& f, double factor, double diameter);
// diameter: of the line, m; mass: per length of line, kg/m.
ContactLaw contact_law(const model::Volume& v, double factor, double diameter, double mass);

// Spring data of a point of a line on a volume, for kernels/impact.hpp.
struct ContactSpring {
  double inverse_frequency = 0;  // s, the period over 2 pi
  // m; an impact goes deeper by inertia: the ramp of the law, or 0.2 % of the radius.
  double significant_depth = 0;
  double damping = 0;  // damping ratio of the mass on the spring
};
// mass: kg per unit of the law; radius: of the line, m.
inline ContactSpring contact_spring(const NormalLaw& law, double mass, double radius) {
  return {.inverse_frequency = std::sqrt(mass / law.stiffness),
          .significant_depth = std::max(law.smoothing, 0.002 * radius),
          .damping = law.damping / (2 * std::sqrt(law.stiffness * mass))};
}

// Limits a step so that no point of a line penetrates a surface deeper than half its radius [m].
void limit_depth(double radius, const Approach& at, ImpactEvents& to);
// True if this limit can apply to a point with a gap of at least `gap` [m] at this speed [m/s].
inline bool may_limit_depth(double radius, double gap, double speed, const ImpactEvents& to) {
  return speed * to.max_step > (1 - 1e-9) * (std::max(gap, 0.0) + 0.5 * radius);
}

}  // namespace hawser
