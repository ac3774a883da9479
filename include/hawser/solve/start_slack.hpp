// Start shapes of slack lines on the bed or on the water: if a catenary would go through the bed, or the arch
// of a floating line above the surface, the line lies in an arc instead.
#pragma once

#include <optional>
#include <vector>

#include "hawser/kernels/catenary.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

enum class LiesOn { bed, water_surface };

// Where a slack line of these sections comes to lie: all of them sink, or all float. None: neither.
std::optional<LiesOn> comes_to_lie(const model::Case& c, const std::vector<CatenarySection>& sections);

// Moves the points [m] of a line, at the arc lengths `arc` [m], that are below the bed, or above the water if
// the line floats, onto a horizontal arc of the same length between the first and the last of them. The arc
// bulges in the direction of the current, or else to the left of its chord. Returns whether it moved any
// points; tangents must then be computed again.
bool lay_slack(const model::Environment& sea, LiesOn ground, const std::vector<double>& arc,
               std::vector<Vec3>& points);

}  // namespace hawser
