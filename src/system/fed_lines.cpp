// The class FedLines: which elements are at a feed point or inside a feeder.
#include "hawser/system/fed_lines.hpp"

#include <algorithm>

namespace hawser {

const FedLine* FedLines::find(int element) const {
  const auto at =
      std::find_if(fed_.begin(), fed_.end(), [=](const FedLine& f) { return f.element == element; });
  return at == fed_.end() ? nullptr : &*at;
}

bool FedLines::idle(int element) const {
  return std::any_of(fed_.begin(), fed_.end(),
                     [=](const FedLine& f) { return f.inside[0] <= element && element < f.inside[1]; });
}

}  // namespace hawser
