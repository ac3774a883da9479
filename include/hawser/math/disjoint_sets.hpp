// Sets of the numbers 0 .. n - 1 that are united (union-find with path halving, Tarjan and van Leeuwen 1984).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hawser {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n = 0) { reset(n); }
  // n sets of one member.
  void reset(std::size_t n) {
    next_.resize(n);
    std::iota(next_.begin(), next_.end(), 0);
  }
  std::size_t size() const { return next_.size(); }

  // The smallest member of the set of i. Shortens the path to it.
  int smallest(int i) {
    while (next_[static_cast<std::size_t>(i)] != i) {
      int& next = next_[static_cast<std::size_t>(i)];
      next = next_[static_cast<std::size_t>(next)];
      i = next;
    }
    return i;
  }

  void unite(int i, int j) {
    const int a = smallest(i);
    const int b = smallest(j);
    next_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }

  // The smallest member of the set of each number.
  std::vector<int> smallest_of_all() {
    std::vector<int> out(next_.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = smallest(static_cast<int>(i));
    return out;
  }

  // The number of the set of each chosen member, -1 of the others. Sets are numbered from 0 on, by their
  // first chosen members. count: how many of them there are.
  template <class Chosen>
  std::vector<int> numbered(const Chosen& chosen, int& count) {
    std::vector<int> of_smallest(next_.size(), -1);
    std::vector<int> out(next_.size(), -1);
    count = 0;
    for (int i = 0; i < static_cast<int>(next_.size()); ++i) {
      if (!chosen(i)) continue;
      int& n = of_smallest[static_cast<std::size_t>(smallest(i))];
      if (n < 0) n = count++;
      out[static_cast<std::size_t>(i)] = n;
    }
    return out;
  }
  std::vector<int> numbered(int& count) {
    const auto all = [](int) { return true; };
    return numbered(all, count);
  }

 private:
  std::vector<int> next_;
};

}  // namespace hawser
