// Division of a row of weights into parts of about equal sums.
#pragma once

#include <span>
#include <vector>

namespace hawser {

// Cost of a cut between an item and the one before it.
enum class CutKind : char { nothing, little, much };

// Consecutive items of equal weight in a row. Between two of them a cut costs much.
struct EqualItems {
  int items = 1;
  double weight = 0;                  // of each, >= 0
  CutKind before = CutKind::nothing;  // cost of a cut before the first one
};

// Cuts a row of items into consecutive parts, some of which may be empty. Returns the first item of each, and
// the number of items at the end. No part weighs more than `most` times the mean, with the lowest cost of the
// most expensive cut for which this is possible; if it is impossible, no more than the heaviest part of the
// most even division. Within these limits each cut has the lowest cost in reach, and among these the most
// even division of the rest. Memory O(runs + parts).
std::vector<int> cut_into_even_parts(std::span<const EqualItems> row, int parts, double most);

}  // namespace hawser
