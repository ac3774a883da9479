// Division of a row of weights: smallest weight of the heaviest part, reach of each cut, and its choice.
#include "hawser/mesh/even_parts.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr double kRounding = 1e-12;  // of the sum

// Sums of the items before each one, and of all.
std::vector<double> sums_before(std::span<const double> weight) {
  std::vector<double> sums{0};
  for (const double w : weight) sums.push_back(sums.back() + w);
  return sums;
}

// The furthest end of a part from `first` that weighs at most `limit`.
int furthest(const std::vector<double>& sums, int first, double limit) {
  const double end = sums[first] + limit + kRounding * sums.back();
  return static_cast<int>(std::upper_bound(sums.begin() + first, sums.end(), end) - sums.begin()) - 1;
}

// The earliest beginning of a part before `end` that weighs at most `limit`.
int earliest(const std::vector<double>& sums, int end, double limit) {
  const double begin = sums[end] - limit - kRounding * sums.back();
  return static_cast<int>(std::lower_bound(sums.begin(), sums.begin() + end, begin) - sums.begin());
}

bool fits(const std::vector<double>& sums, int parts, double limit) {
  int at = 0;
  for (int p = 0; p < parts; ++p) at = furthest(sums, at, limit);
  return at + 1 == std::ssize(sums);
}

// Smallest possible weight of the heaviest part, by bisection between the mean and the total.
double least_limit(const std::vector<double>& sums, int parts) {
  double low = sums.back() / parts, high = sums.back();
  while (high - low > kRounding * sums.back()) {
    const double middle = 0.5 * (low + high);
    (fits(sums, parts, middle) ? high : low) = middle;
  }
  return high;
}

// The places where the row may be cut: its ends, and the places before items whose cut is of the kind `worst`
// or a better one.
struct Places {
  std::vector<int> at;
  std::vector<double> sums;  // of the items before each
};

Places places(const std::vector<double>& sums, std::span<const CutKind> before, CutKind worst) {
  Places out;
  const int items = static_cast<int>(before.size());
  for (int i = 0; i <= items; ++i)
    if (i == 0 || i == items || before[i] <= worst) {
      out.at.push_back(i);
      out.sums.push_back(sums[i]);
    }
  return out;
}

}  // namespace

std::vector<int> cut_into_even_parts(std::span<const double> weight, std::span<const CutKind> before,
                                     int parts, double most) {
  const int items = static_cast<int>(weight.size());
  if (items == 0) return std::vector<int>(static_cast<size_t>(parts) + 1, 0);
  const std::vector<double> sums = sums_before(weight);
  double limit = most * sums.back() / parts;
  Places p;
  for (const CutKind worst : {CutKind::nothing, CutKind::little, CutKind::much}) {
    p = places(sums, before, worst);
    if (fits(p.sums, parts, limit)) break;
  }
  if (!fits(p.sums, parts, limit)) limit = least_limit(p.sums, parts);
  const int last = static_cast<int>(p.at.size()) - 1;
  std::vector<int> cuts(static_cast<size_t>(parts) + 1, last), least(cuts);
  cuts[0] = 0;
  // least[k]: first place at which part k may begin, so that the rest fits into part k and those after it.
  for (int k = parts - 1; k > 0; --k) least[k] = earliest(p.sums, least[k + 1], limit);
  for (int k = 1; k < parts; ++k) {
    const int before_it = cuts[k - 1], low = std::max(least[k], before_it);
    const int high = std::max(low, furthest(p.sums, before_it, limit));
    const double even = p.sums[before_it] + (p.sums.back() - p.sums[before_it]) / (parts - k + 1);
    const auto kind = [&](int c) { return c == last ? CutKind::nothing : before[p.at[c]]; };
    const auto better = [&](int a, int b) {
      return kind(a) != kind(b) ? kind(a) < kind(b) : std::abs(p.sums[a] - even) < std::abs(p.sums[b] - even);
    };
    cuts[k] = low;
    for (int c = low + 1; c <= high; ++c)
      if (better(c, cuts[k])) cuts[k] = c;
  }
  std::vector<int> first;
  for (const int c : cuts) first.push_back(p.at[c]);
  return first;
}

}  // namespace hawser
