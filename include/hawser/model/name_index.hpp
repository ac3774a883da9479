// Look-up of objects by name; a farm has thousands of lines and bodies.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace hawser::model {

// Each hit is verified against the objects, which may therefore change between look-ups.
class NameIndex {
 public:
  // Index of the first object with this `name`, of those that are not forgotten (Entries); -1: none.
  template <class Objects>
  int find(const Objects& objects, const std::string& name) const {
    const auto known = [&](int i) {
      if constexpr (requires { objects.has(0); }) return objects.has(static_cast<std::size_t>(i));
      return true;
    };
    const auto name_of = [&](int i) -> const std::string& {
      return objects[static_cast<std::size_t>(i)].name;
    };
    if (size_ != objects.size()) {
      size_ = objects.size();
      by_name_.clear();
      for (int i = 0; i < std::ssize(objects); ++i)
        if (known(i)) by_name_.push_back(i);
      by_name_.shrink_to_fit();
      std::stable_sort(by_name_.begin(), by_name_.end(),
                       [&](int i, int j) { return name_of(i) < name_of(j); });
    }
    const auto found = std::lower_bound(by_name_.begin(), by_name_.end(), name,
                                        [&](int i, const std::string& value) { return name_of(i) < value; });
    if (found != by_name_.end() && name_of(*found) == name) return *found;
    for (int i = 0; i < std::ssize(objects); ++i)
      if (known(i) && name_of(i) == name) return i;
    return -1;
  }

 private:
  // Indices in the order of the names, of this number of objects: a cache, which does not change results.
  mutable std::vector<int> by_name_;
  mutable std::size_t size_ = 0;
};

}  // namespace hawser::model
