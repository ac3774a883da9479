// Pairs of nodes that are coupled by something other than an element, for example by contact. Force terms
// list them before a step, so that ghost nodes and the sparsity pattern include them.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace hawser {

struct Couplings {
  // Mesh nodes. Sorted and unique after sort(); `pairs` have first < second.
  std::vector<int> nodes;
  std::vector<std::pair<int, int>> pairs;

  // Couples the nodes of one segment with those of another. This rank must own one of the four.
  void add(const std::array<int, 2>& a, const std::array<int, 2>& b) {
    nodes.insert(nodes.end(), {a[0], a[1], b[0], b[1]});
    for (int i : a)
      for (int j : b) pairs.emplace_back(std::min(i, j), std::max(i, j));
  }
  void sort() {
    const auto sort_unique = [](auto& v) {
      std::sort(v.begin(), v.end());
      v.erase(std::unique(v.begin(), v.end()), v.end());
    };
    sort_unique(nodes);
    sort_unique(pairs);
  }
  // True if all nodes and pairs are also in `o`. Both must be sorted.
  bool within(const Couplings& o) const {
    return std::includes(o.nodes.begin(), o.nodes.end(), nodes.begin(), nodes.end()) &&
           std::includes(o.pairs.begin(), o.pairs.end(), pairs.begin(), pairs.end());
  }
};

}  // namespace hawser
