// Periods and stability of the control loop of dynamic positioning.
#pragma once

#include <string>

#include "hawser/math/types.hpp"

namespace hawser::model {

struct Body;

// Mass in surge, sway and yaw about the body origin [kg, kg, kg m²], with the added mass of the lowest
// frequency if the body has one.
Vec3 positioned_mass(const Body& b);

// Largest growth rate [1/s] of the linear controlled motion in surge, sway and yaw, without force limits; 0:
// stable or not controlled. See docs/theory/positioning.md, "Stability".
Vec3 loop_growth(const Body& b);

// Line printed by `hawser check`: periods, damping and limits.
std::string positioning_text(const Body& b);

}  // namespace hawser::model
