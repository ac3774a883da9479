// The laws of a volume for what touches it, and what they mean for the length of a step.
#pragma once

#include <algorithm>
#include <optional>

#include "hawser/kernels/impact.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/contact_history.hpp"

namespace hawser {

// share: what turns the stiffness of the volume and its table into those of what touches (a node, a length);
// smoothing [m]: unless the volume says; mass [kg in the same sense]: effective, of the damping.
NormalLaw normal_law(const model::Volume& v, double share, double smoothing, double mass);
// Of a line of that diameter [m], which says over what length friction mobilises unless the settings do.
FrictionLaw friction_law(const model::Friction& f, double share, double diameter);
// Of a line of that diameter [m].
ContactLaw contact_law(const model::Volume& v, double share, double diameter, double mass);

// A place of a line on the spring of a volume, as the length of a step has to do with it
// (kernels/impact.hpp).
struct ContactSpring {
  const NormalLaw& law;
  double mass = 0, radius = 0;  // kg in the sense of the law; m, of the line

  // Whether it strikes: what inertia takes deeper than the ramp of the law and 0.2 % of the radius. share:
  // what turns mass into kg.
  std::optional<ImpactEvent> impact(double share, const Approach& at) const;
  // Whether it can, at that speed [m/s] and acceleration [m/s²].
  bool may_impact(double speed, double acceleration) const;
  // Whether a step of h [s] is too short to be asked for its crossings.
  bool follows(double h) const;
  // J, made or lost where it begins or ends in a step in which it moved along the normal by `path` [m], at
  // that speed [m/s]; force and potential in the sense of the law, where it touches.
  double crossing_error(double share, double force, double potential, double path, double speed) const;
};

// A step is not to get a place of a line deeper into a surface than half its radius [m].
void limit_depth(double radius, const Approach& at, ImpactEvents& to);
// Whether it could tell of what is `gap` [m] away or more, at that speed [m/s].
inline bool may_limit_depth(double radius, double gap, double speed, const ImpactEvents& to) {
  return speed * to.most > (1 - 1e-9) * (std::max(gap, 0.0) + 0.5 * radius);
}

}  // namespace hawser
