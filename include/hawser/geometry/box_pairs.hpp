// Pairs of boxes that overlap.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/geometry/box.hpp"

namespace hawser {

// All pairs i < j of overlapping boxes [m], in no particular order. Boxes that are empty or not finite
// overlap nothing. Cost: O(n log n) plus the number of pairs.
std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes);

}  // namespace hawser
