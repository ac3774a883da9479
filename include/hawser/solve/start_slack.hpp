// Start shapes of slack lines on the bed or on the water: if a catenary would go through the bed, or the arch
// of a floating line above the surface, the line lies in an arc instead.
#pragma once

#include <vector>

#include "hawser/model/case.hpp"

namespace hawser {

// Moves the points [m] of a line, at the arc lengths `arc` [m], that are below the bed, or above the water if
// `floats`, onto a horizontal arc of the same length between the first and the last of them. The arc bulges
// in the direction of the current, or else to the left of its chord. Returns whether it moved any points;
// tangents must then be computed again.
bool lay_slack(const model::Environment& sea, bool floats, const std::vector<double>& arc,
               std::vector<Vec3>& points);

}  // namespace hawser
