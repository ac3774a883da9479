// Members of groups that come together: each names another of its group, the first of a group itself.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hawser::detail {

// n groups of one member.
inline void separate(std::vector<int>& group, std::size_t n) {
  group.resize(n);
  std::iota(group.begin(), group.end(), 0);
}

// The first member of the group of i. Shortens the way to it.
inline int root_of(std::vector<int>& group, int i) {
  while (group[static_cast<std::size_t>(i)] != i) {
    int& next = group[static_cast<std::size_t>(i)];
    next = group[static_cast<std::size_t>(next)];
    i = next;
  }
  return i;
}

inline void unite(std::vector<int>& group, int i, int j) {
  const int a = root_of(group, i), b = root_of(group, j);
  group[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

}  // namespace hawser::detail
