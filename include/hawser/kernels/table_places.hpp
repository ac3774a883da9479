// Position of a frequency or direction in a table of responses or wave forces.
#pragma once

#include <cstddef>
#include <vector>

namespace hawser {

// Two neighbouring entries, and the weight of the second in linear interpolation.
struct TablePlace {
  std::size_t low = 0, high = 0;
  double weight = 0;
};
// Place in ascending values; beyond the first or the last both indices are that entry.
TablePlace frequency_place(const std::vector<double>& omega, double x);
// Place in ascending directions in [0, 2 pi) [rad], periodic; the first may be x itself. Both indices are
// equal if the table has a single direction.
TablePlace direction_place(const std::vector<double>& directions, double x);

// Directions of the table on both sides of x, rad, the first not above and the second not below it; both
// equal if x is in the table (to 1e-9) or it has a single direction.
struct DirectionGap {
  double from = 0, to = 0;
};
DirectionGap direction_gap(const std::vector<double>& directions, double x);

// Direction reduced to [0, 2 pi).
double all_round(double direction);

}  // namespace hawser
