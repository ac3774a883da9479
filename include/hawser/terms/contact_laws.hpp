// The laws of a volume for what touches it, and what they mean for the length of a step.
#pragma once

#include <algorithm>
#include <cmath>

#include "hawser/kernels/impact.hpp"
#include "hawser/kernels/surface_contact_law.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// share: what turns the stiffness of the volume and its table into those of what touches (a node, a length);
// smoothing [m]: unless the volume says; mass [kg in the same sense]: effective, of the damping.
NormalLaw normal_law(const model::Volume& v, double share, double smoothing, double mass);
// Of a line of that diameter [m], which says over what length friction mobilises unless the settings do.
FrictionLaw friction_law(const model::Friction& f, double share, double diameter);
// Of a line of that diameter [m].
ContactLaw contact_law(const model::Volume& v, double share, double diameter, double mass);

// What the functions of kernels/impact.hpp ask of a place of a line on the spring of a volume.
struct ContactSpring {
  double inverse_frequency = 0;  // s, the period over 2 pi
  double significant_depth =
      0;  // m; an impact goes deeper by inertia: the ramp of the law, or 0.2 % of the radius
};
// mass: kg in the sense of the law; radius of the line, m.
inline ContactSpring contact_spring(const NormalLaw& law, double mass, double radius) {
  return {std::sqrt(mass / law.stiffness), std::max(law.smoothing, 0.002 * radius)};
}

// A step is not to get a place of a line deeper into a surface than half its radius [m].
void limit_depth(double radius, const Approach& at, ImpactEvents& to);
// Whether it could tell of what is `gap` [m] away or more, at that speed [m/s].
inline bool may_limit_depth(double radius, double gap, double speed, const ImpactEvents& to) {
  return speed * to.most > (1 - 1e-9) * (std::max(gap, 0.0) + 0.5 * radius);
}

}  // namespace hawser
