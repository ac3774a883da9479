// The class FedLines: search for elements at a feed point or inside a feeder.
#include "hawser/system/fed_lines.hpp"

#include <algorithm>

namespace hawser {

// Feeders are sorted by line and end, so their elements ascend.
std::vector<FedLine>::const_iterator FedLines::first_from(int element) const {
  return std::lower_bound(fed_.begin(), fed_.end(), element,
                          [](const FedLine& f, int e) { return f.element < e; });
}

const FedLine* FedLines::find(int element) const {
  const auto at = first_from(element);
  return at != fed_.end() && at->element == element ? &*at : nullptr;
}

// An element inside a feeder at an end A is before the element of this feeder, at an end B behind it.
bool FedLines::idle(int element) const {
  const auto inside = [=](const FedLine& f) { return f.inside[0] <= element && element < f.inside[1]; };
  const auto at = first_from(element);
  return (at != fed_.end() && inside(*at)) || (at != fed_.begin() && inside(*(at - 1)));
}

}  // namespace hawser
