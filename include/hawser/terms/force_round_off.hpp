// Rounding errors of inertia forces and of springs, as squares for ScalesResiduals::round_off.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser {

// Factor on the machine epsilon: operations in a force.
inline constexpr double kForceEpsilon = 4 * std::numeric_limits<double>::epsilon();

// Square of the rounding error of the inertia force [N²] of a mass [kg] with a velocity [m/s] in a step h
// [s]. The scheme computes accelerations from differences of positions divided by h², so the error is that of
// v h. Likewise of the moment [(N m)²] of an inertia [kg m²] with an angular velocity [rad/s].
inline double inertia_round_off(double mass, double velocity, double h) {
  return std::pow(kForceEpsilon * mass * velocity / h, 2);
}
// Of an element with `mass` [kg].
inline double inertia_round_off(const Kinematics& state, const LocalElement& e, double mass, double h) {
  return inertia_round_off(mass, std::max(state.v[e.first].norm(), state.v[e.second].norm()), h);
}

// Square of the rounding error of the force [N²] of a spring [N/m] between positions of this magnitude [m].
// Likewise of the moment [(N m)²] of a spring [N m/rad] with rotations of the magnitude 1.
inline double spring_round_off(double stiffness, double position) {
  return std::pow(kForceEpsilon * stiffness * position, 2);
}

}  // namespace hawser
