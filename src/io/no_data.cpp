// Bed heights that represent missing data: outliers, usually marked by a number such as -9999.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hawser/io/case_reader_parts.hpp"

namespace hawser::io {
namespace {

// Numbers of nines, limits of two-byte integers, and huge floats (ESRI grids, GMT, GDAL).
bool is_mark(double z) {
  const double size = std::abs(z);
  if (size >= 1e10) return true;
  constexpr std::array kMarks = {999.0, 999.25, 9999.0, 99999.0, 999999.0, 32767.0, 32768.0};
  return std::any_of(kMarks.begin(), kMarks.end(), [&](double m) { return std::abs(size - m) < 1e-6 * m; });
}

}  // namespace

OddHeights odd_heights(const std::vector<double>& z, double spacing) {
  std::vector<double> sorted = z;
  std::sort(sorted.begin(), sorted.end());
  // The outliers are on the smaller side of the widest gap between heights.
  std::size_t at = 0;
  double gap = 0;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i)
    if (sorted[i + 1] - sorted[i] > gap) {
      gap = sorted[i + 1] - sorted[i];
      at = i;
    }
  const bool low = at + 1 <= sorted.size() / 2;
  const std::size_t count = low ? at + 1 : sorted.size() - at - 1;
  const double spread = low ? sorted.back() - sorted[at + 1] : sorted[at] - sorted.front();
  const double limit = low ? sorted[at] : sorted[at + 1];
  const auto odd = [&](double h) { return low ? h <= limit : h >= limit; };
  const bool mark = is_mark(low ? sorted.front() : sorted.back());
  // A mark is certain if it is farther from the others than half their range. Other outliers are noted only
  // if they are far outside the range and steeper than any pit wall: ten times the spacing.
  constexpr double kBeyond = 5, kSteep = 10;
  OddHeights out;
  if (!(gap > (mark ? 0.5 : kBeyond) * spread) || !(gap > (mark ? 1 : kSteep) * spacing)) return out;
  out.mark = mark;
  out.count = count;
  out.gap = gap;
  out.first = static_cast<std::size_t>(std::find_if(z.begin(), z.end(), odd) - z.begin());
  return out;
}

}  // namespace hawser::io
