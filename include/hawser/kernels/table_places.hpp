// Where a frequency and a direction stand in a table of responses or wave forces.
#pragma once

#include <cstddef>
#include <vector>

namespace hawser {

// Two neighbours in a list, and the share of the second on the straight line between them.
struct TablePlace {
  std::size_t low = 0, high = 0;
  double share = 0;
};
// Of ascending values; beyond the first and the last twice that one.
TablePlace frequency_place(const std::vector<double>& omega, double x);
// Of ascending directions in [0, 2 pi), all round [rad]; the first may be x itself. Twice the same where the
// table has one.
TablePlace direction_place(const std::vector<double>& directions, double x);

// The directions on either side of x, rad, the first not above it and the second not below; twice the same
// where x is in the table (to 1e-9) or the table has no other.
struct DirectionGap {
  double from = 0, to = 0;
};
DirectionGap direction_gap(const std::vector<double>& directions, double x);

// In [0, 2 pi).
double all_round(double direction);

}  // namespace hawser
