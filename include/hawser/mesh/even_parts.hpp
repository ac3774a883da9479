// Division of a row of weights into parts of about equal sums. In the partition an item is a vertex of the
// graph's sequence, its weight the work of the vertex, and a part the vertices of a rank.
#pragma once

#include <span>
#include <vector>

namespace hawser {

// Where a cut between an item and the one before it is, in order of cost: a cut between components costs
// nothing, within a line most.
enum class CutKind : char { between_components, between_lines, within_line };

// Consecutive items of equal weight in a row. Cuts between two of them are within a line.
struct EqualItems {
  int items = 1;
  double weight = 0;                             // of each, >= 0
  CutKind before = CutKind::between_components;  // the cut before the first one
};

// Cuts a row of items into consecutive parts, some of which may be empty. Returns the first item of each, and
// the number of items at the end. No part weighs more than `max_ratio` times the mean, with the lowest cost
// of the most expensive cut for which this is possible; if it is impossible, no more than the heaviest part
// of the most even division. Within these limits each cut has the lowest cost in reach, and among these the
// most even division of the rest. Memory O(runs + parts).
std::vector<int> cut_into_even_parts(std::span<const EqualItems> row, int parts, double max_ratio);

}  // namespace hawser
