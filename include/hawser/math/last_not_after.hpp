// Search in a sorted range, for example in runs by their first items.
#pragma once

#include <algorithm>
#include <functional>
#include <ranges>

namespace hawser {

// The last item whose projection is at most `value`, in a range that ascends by the projection. The first
// item must be one.
template <std::ranges::forward_range Range, class Value, class Projection = std::identity>
auto last_not_after(const Range& range, const Value& value, Projection projection = {}) {
  return std::ranges::prev(std::ranges::upper_bound(range, value, {}, projection));
}

}  // namespace hawser
