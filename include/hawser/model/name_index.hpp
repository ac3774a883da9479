// Where the thing of a name is among many: a farm has thousands of lines and bodies, which are looked up by
// name.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace hawser::model {

// What it remembers is checked at each use, so the things may change in any way.
class NameIndex {
 public:
  // The index of the first thing with this `name`, -1: there is none.
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
