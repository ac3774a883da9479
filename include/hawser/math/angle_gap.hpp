// Widest gap between neighbouring directions of a full circle.
#pragma once

#include <cstddef>
#include <vector>

namespace hawser {

struct AngleGap {
  double from = 0, to = 0;
  double width() const { return to - from; }
};

// directions: in [a, a + turn), increasing, at least one; of equal gaps the first is returned. turn: 360 or 2
// pi, in the unit of the directions. The gap after the last direction ends at the first one + turn.
inline AngleGap widest_gap(const std::vector<double>& directions, double turn) {
  AngleGap widest;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool last = i + 1 == directions.size();
    const AngleGap gap{directions[i], last ? directions.front() + turn : directions[i + 1]};
    if (gap.width() > widest.width()) widest = gap;
  }
  return widest;
}

}  // namespace hawser
