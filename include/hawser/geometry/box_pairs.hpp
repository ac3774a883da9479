// Pairs of boxes that overlap, by a hierarchical grid: each box in a cell of the level of its own size.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/geometry/box.hpp"

namespace hawser {

// All pairs (i, j), i < j, of overlapping boxes [m], in no particular order. Work and memory grow with the
// number of boxes and of pairs. Boxes that are empty or not finite overlap nothing.
std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes);

}  // namespace hawser
