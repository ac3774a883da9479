// Start shapes of what is slack on the bed or on the water: where a catenary would go through the bed, or a
// floating line's arch above the surface, the line lies in an arc instead.
#pragma once

#include <vector>

#include "hawser/model/case.hpp"

namespace hawser {

// Lays the points [m] of a line, at the arc lengths `arc` [m], that are below the bed, or above the water
// while `floats`, along a level arc of the same length between where that begins and ends. It bulges to where
// the current goes, else to the left of its chord. Returns whether it did; tangents are to be made anew then.
bool lay_slack(const model::Environment& sea, bool floats, const std::vector<double>& arc,
               std::vector<Vec3>& points);

}  // namespace hawser
