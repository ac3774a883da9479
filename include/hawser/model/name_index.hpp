// Hashed look-up of objects by name; a farm has thousands of lines and bodies.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace hawser::model {

// Each hit is verified against the objects, which may therefore change between look-ups.
class NameIndex {
 public:
  // Index of the first object with this `name`; -1: none.
  template <class Thing>
  int find(const std::vector<Thing>& things, const std::string& name) const {
    if (at_.size() != things.size()) {
      at_.clear();
      for (std::size_t i = 0; i < things.size(); ++i) at_.emplace(things[i].name, i);
    }
    if (const auto found = at_.find(name); found != at_.end())
      if (const std::size_t i = found->second; i < things.size() && things[i].name == name)
        return static_cast<int>(i);
    for (std::size_t i = 0; i < things.size(); ++i)
      if (things[i].name == name) return static_cast<int>(i);
    return -1;
  }

 private:
  mutable std::unordered_map<std::string, std::size_t> at_;  // a cache, which does not change results
};

}  // namespace hawser::model
