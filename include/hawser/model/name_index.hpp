// Look-up of objects by name; a farm has thousands of lines and bodies.
#pragma once

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace hawser::model {

// Each hit is verified against the objects, which may therefore change between look-ups.
class NameIndex {
 public:
  // Index of the first object with this `name`; -1: none.
  template <class Thing>
  int find(const std::vector<Thing>& things, const std::string& name) const {
    const auto name_of = [&](int i) -> const std::string& {
      return things[static_cast<std::size_t>(i)].name;
    };
    if (by_name_.size() != things.size()) {
      by_name_.resize(things.size());
      by_name_.shrink_to_fit();
      std::iota(by_name_.begin(), by_name_.end(), 0);
      std::stable_sort(by_name_.begin(), by_name_.end(),
                       [&](int i, int j) { return name_of(i) < name_of(j); });
    }
    const auto found =
        std::lower_bound(by_name_.begin(), by_name_.end(), name,
                         [&](int i, const std::string& wanted) { return name_of(i) < wanted; });
    if (found != by_name_.end() && name_of(*found) == name) return *found;
    for (std::size_t i = 0; i < things.size(); ++i)
      if (things[i].name == name) return static_cast<int>(i);
    return -1;
  }

 private:
  mutable std::vector<int>
      by_name_;  // indices in the order of the names; a cache, which does not change results
};

}  // namespace hawser::model
