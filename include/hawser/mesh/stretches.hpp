// A row of weights cut into stretches of about equal sums.
#pragma once

#include <span>
#include <vector>

namespace hawser {

// What is lost by a cut between an item and the one before it.
enum class CutKind : char { nothing, little, much };

// Cuts a row of items with weights >= 0 into `parts` stretches, of which some may be empty: the first item of
// each, and the number of items at the end. `before`: of a cut before each item. No stretch weighs more than
// `most` times the mean, and the worst kind of cut is the least with which that can be; where no kind can do
// it, more than the heaviest stretch of the most even cut. Within that, each cut is of the least kind in
// reach, and of those where the rest is shared out most evenly. O(items + parts log items).
std::vector<int> cut_into_stretches(std::span<const double> weight, std::span<const CutKind> before,
                                    int parts, double most);

}  // namespace hawser
