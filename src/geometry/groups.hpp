// Disjoint sets (union-find): each member refers to another member of its group, the first one to itself.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hawser::detail {

// Makes n groups of one member.
inline void separate(std::vector<int>& group, std::size_t n) {
  group.resize(n);
  std::iota(group.begin(), group.end(), 0);
}

// First member of the group of i. Shortens the path to it.
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

// Numbers of the groups from 0, in the order of their first members for which chosen(i) is true; -1 for other
// members.
template <class Chosen>
std::vector<int> numbered(std::vector<int>& group, const Chosen& chosen, int& count) {
  std::vector<int> of_root(group.size(), -1), out(group.size(), -1);
  count = 0;
  for (int i = 0; i < static_cast<int>(group.size()); ++i) {
    if (!chosen(i)) continue;
    int& n = of_root[static_cast<std::size_t>(root_of(group, i))];
    if (n < 0) n = count++;
    out[static_cast<std::size_t>(i)] = n;
  }
  return out;
}
inline std::vector<int> numbered(std::vector<int>& group, int& count) {
  return numbered(
      group, [](int) { return true; }, count);
}

}  // namespace hawser::detail
