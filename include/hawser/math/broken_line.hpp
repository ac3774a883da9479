// Linear interpolation of values along a line, at times or arc lengths.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace hawser {

// Linear between the rows (place, value; places ascending, at least one row), constant beyond them.
template <class Value>
Value on_broken_line(const std::vector<std::pair<double, Value>>& rows, double place) {
  if (place <= rows.front().first) return rows.front().second;
  if (place >= rows.back().first) return rows.back().second;
  const auto after = std::upper_bound(rows.begin(), rows.end(), place,
                                      [](double x, const auto& row) { return x < row.first; });
  const auto& b = *after;
  const auto& a = *(after - 1);
  return a.second + (place - a.first) / (b.first - a.first) * (b.second - a.second);
}

}  // namespace hawser
