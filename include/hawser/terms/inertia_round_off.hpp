// Rounding error of inertia forces.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser {

// Square of the rounding error [N²] in the inertia force of an element with `mass` [kg] in a step h [s]. The
// scheme computes accelerations from differences of positions divided by h², so the error is that of v h.
inline double inertia_round_off(const Kinematics& state, const LocalElement& e, double mass, double h) {
  const double v = std::max(state.v[e.first].norm(), state.v[e.second].norm());
  return std::pow(4 * std::numeric_limits<double>::epsilon() * mass * v / h, 2);
}

}  // namespace hawser
