// The contact laws of a volume, and the step lengths that resolve their springs.
#pragma once

#include <algorithm>
#include <cmath>

#include "hawser/kernels/impact.hpp"
#include "hawser/kernels/surface_contact_law.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// share: factor from the stiffness and table of the volume to those in contact (a node, a length);
// smoothing [m]: the default of the volume's; mass [kg in the same sense]: effective, for the damping.
NormalLaw normal_law(const model::Volume& v, double share, double smoothing, double mass);
// For a line of this diameter [m], from which the default mobilisation length of friction follows.
FrictionLaw friction_law(const model::Friction& f, double share, double diameter);
// For a line of this diameter [m].
ContactLaw contact_law(const model::Volume& v, double share, double diameter, double mass);

// The data of a point of a line on the spring of a volume that kernels/impact.hpp needs.
struct ContactSpring {
  double inverse_frequency = 0;  // s, the period over 2 pi
  double significant_depth =
      0;  // m; an impact goes deeper by inertia: the ramp of the law, or 0.2 % of the radius
};
// mass: kg in the sense of the law; radius of the line, m.
inline ContactSpring contact_spring(const NormalLaw& law, double mass, double radius) {
  return {std::sqrt(mass / law.stiffness), std::max(law.smoothing, 0.002 * radius)};
}

// Limits a step so that no point of a line gets deeper into a surface than half its radius [m].
void limit_depth(double radius, const Approach& at, ImpactEvents& to);
// Whether such a limit can apply to a point at a distance of `gap` [m] or more, at this speed [m/s].
inline bool may_limit_depth(double radius, double gap, double speed, const ImpactEvents& to) {
  return speed * to.most > (1 - 1e-9) * (std::max(gap, 0.0) + 0.5 * radius);
}

}  // namespace hawser
