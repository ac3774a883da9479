// A list in which consecutive equal values take the memory of one: a farm has
// thousands of equal lines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

namespace hawser {

template <class T>
class Runs {
 public:
  Runs() = default;
  Runs(std::initializer_list<T> values) {
    for (const T& x : values) push_back(x);
  }
  void push_back(const T& value) {
    if (runs_.empty() || !(runs_.back().second == value)) runs_.emplace_back(size_, value);
    ++size_;
  }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const {
    return std::prev(std::ranges::upper_bound(runs_, i, {}, &std::pair<std::size_t, T>::first))->second;
  }

 private:
  std::vector<std::pair<std::size_t, T>> runs_;  // first index and value
  std::size_t size_ = 0;
};

}  // namespace hawser
