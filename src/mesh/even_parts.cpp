// Division of a row of weights: smallest weight of the heaviest part, reach of each cut, and its choice.
#include "hawser/mesh/even_parts.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "hawser/math/last_not_after.hpp"

namespace hawser {
namespace {

constexpr double kRounding = 1e-12;  // of the sum

// The places where the row may be cut: its ends, and those before items with a cut of at most a given cost.
class Places {
 public:
  Places(std::span<const EqualItems> row, CutKind worst) {
    int item = 0;
    double sum = 0;
    for (const EqualItems& r : row) {
      const int places = worst == CutKind::within_line ? r.items : item == 0 || r.before <= worst ? 1 : 0;
      if (places > 0) add({places_, item, sum, r.weight, r.before}, places);
      item += r.items;
      sum += r.items * r.weight;
    }
    add({places_, item, sum, 0, CutKind::between_components}, 1);
  }
  // The last place is the end of the row.
  int last() const { return places_ - 1; }
  int item(int place) const {
    const Run& r = run_of(place);
    return r.item + place - r.place;
  }
  // Of the items before a place.
  double sum(int place) const {
    const Run& r = run_of(place);
    return r.sum + (place - r.place) * r.weight;
  }
  CutKind kind(int place) const {
    const Run& r = run_of(place);
    return place == r.place ? r.before : CutKind::within_line;
  }
  double whole() const { return runs_.back().sum; }
  // The furthest end of a part from `first` that weighs at most `limit`.
  int furthest(int first, double limit) const {
    const double end = sum(first) + limit + kRounding * whole();
    const auto all = std::views::iota(first, places_);
    return *last_not_after(all, end, [&](int p) { return sum(p); });
  }
  // The earliest beginning of a part before `end` that weighs at most `limit`.
  int earliest(int end, double limit) const {
    const double begin = sum(end) - limit - kRounding * whole();
    const auto all = std::views::iota(0, end);
    const auto found = std::ranges::lower_bound(all, begin, {}, [&](int p) { return sum(p); });
    return static_cast<int>(found - all.begin());
  }
  bool fits(int parts, double limit) const {
    int at = 0;
    for (int p = 0; p < parts; ++p) at = furthest(at, limit);
    return at == last();
  }
  // Smallest possible weight of the heaviest part, by bisection between the mean and the total.
  double smallest_limit(int parts) const {
    double low = whole() / parts;
    double high = whole();
    while (high - low > kRounding * whole()) {
      const double middle = 0.5 * (low + high);
      (fits(parts, middle) ? high : low) = middle;
    }
    return high;
  }

 private:
  // Places one item apart from each other.
  struct Run {
    int place = 0, item = 0;
    double sum = 0, weight = 0;
    CutKind before = CutKind::between_components;
  };
  std::vector<Run> runs_;
  int places_ = 0;

  void add(const Run& run, int places) {
    runs_.push_back(run);
    places_ += places;
  }
  const Run& run_of(int place) const { return *last_not_after(runs_, place, &Run::place); }
};

}  // namespace

std::vector<int> cut_into_even_parts(std::span<const EqualItems> row, int parts, double max_ratio) {
  if (row.empty()) return std::vector<int>(static_cast<size_t>(parts) + 1, 0);
  Places p(row, CutKind::between_components);
  double limit = max_ratio * p.whole() / parts;
  for (const CutKind worst : {CutKind::between_lines, CutKind::within_line})
    if (!p.fits(parts, limit)) p = Places(row, worst);
  if (!p.fits(parts, limit)) limit = p.smallest_limit(parts);
  const int last = p.last();
  std::vector<int> cuts(static_cast<size_t>(parts) + 1, last);
  std::vector<int> earliest(cuts);
  cuts[0] = 0;
  // earliest[k]: first place at which part k may begin, so that the rest fits into part k and those after it.
  for (int k = parts - 1; k > 0; --k) earliest[k] = p.earliest(earliest[k + 1], limit);
  for (int k = 1; k < parts; ++k) {
    const int before_it = cuts[k - 1];
    const int low = std::max(earliest[k], before_it);
    const int high = std::max(low, p.furthest(before_it, limit));
    const double even = p.sum(before_it) + (p.whole() - p.sum(before_it)) / (parts - k + 1);
    const auto better = [&](int a, int b) {
      return p.kind(a) != p.kind(b) ? p.kind(a) < p.kind(b)
                                    : std::abs(p.sum(a) - even) < std::abs(p.sum(b) - even);
    };
    cuts[k] = low;
    for (int c = low + 1; c <= high; ++c)
      if (better(c, cuts[k])) cuts[k] = c;
  }
  std::vector<int> first;
  for (const int c : cuts) first.push_back(p.item(c));
  return first;
}

}  // namespace hawser
