// Periods and stability of the control loop of dynamic positioning.
#pragma once

#include <string>

#include "hawser/math/types.hpp"

namespace hawser::model {

struct Body;

// kg, kg, kg m²: with the added mass of the longest waves where the body has one, of yaw about its origin.
Vec3 positioned_mass(const Body& b);

// 1/s, by surge, sway and yaw: the largest rate of growth of the linear motion of that mass with the
// controller alone, without limits; 0: it decays, or nothing is controlled. See docs/theory/positioning.md,
// "Stability".
Vec3 loop_growth(const Body& b);

// A line of `hawser check`: periods, damping and limits.
std::string positioning_text(const Body& b);

}  // namespace hawser::model
