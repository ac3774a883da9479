// Pairs of boxes that overlap.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/geometry/box.hpp"

namespace hawser {

// All pairs i < j of overlapping boxes [m], in no particular order. Boxes that are empty or not finite
// overlap nothing. A box more costs the logarithm of their number, and the pairs it is in.
std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes);

}  // namespace hawser
