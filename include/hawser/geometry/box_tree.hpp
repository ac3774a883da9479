// Tree of bounding boxes over items: flat or curved facets of a mesh, elements.
//
// Nodes are split at the median of the centres along the longest side of their box, until few items are left.
// Every item is in one leaf, and the items of a node are contiguous.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/const_array.hpp"

namespace hawser {

class BoxTree {
 public:
  struct Node {
    Box box;
    int first = 0, count = 0;  // range in items()
    int next = 0;  // index of the node after this one's subtree; its first child is the next index
  };
  BoxTree() = default;
  // chosen: one flag per item, empty for all; leaf: largest number of items in a leaf.
  explicit BoxTree(std::span<const Box> boxes, const std::vector<bool>& chosen = {}, int leaf = 4);

  bool empty() const { return nodes_.empty(); }
  Box box() const { return empty() ? Box{} : nodes_[0].box; }
  std::span<const Node> nodes() const { return nodes_; }  // parents before their children
  // Indices of all items, leaf by leaf, and of those below a node.
  std::span<const int> items() const { return items_; }
  std::span<const int> below(const Node& n) const {
    return items().subspan(static_cast<std::size_t>(n.first), static_cast<std::size_t>(n.count));
  }

  // Calls visit(item) for all items that may be within the distance sqrt(squared) [m²] of p, and for some
  // farther ones, nearer halves first; visit may reduce `squared`. Exact ties are included.
  template <class Visit>
  void nearest(const Vec3& p, double& squared, Visit&& visit) const {
    if (empty()) return;
    struct Waiting {
      double squared;
      int node;
    } stack[kDeepest];
    const double rounding = 1e-14 * (p.cwiseAbs().maxCoeff() + size_);
    int depth = 0, at = 0;
    double limit = padded(squared, rounding);
    for (;;) {
      const Node& n = node(at);
      if (n.next == at + 1) {
        for (const int i : below(n)) visit(i);
        limit = padded(squared, rounding);
      } else {
        const int a = at + 1;
        const int b = node(a).next;
        const double to_a = squared_distance(node(a).box, p);
        const double to_b = squared_distance(node(b).box, p);
        if (std::max(to_a, to_b) <= limit) stack[depth++] = {std::max(to_a, to_b), to_a > to_b ? a : b};
        at = to_a > to_b ? b : a;
        if (std::min(to_a, to_b) <= limit) continue;
      }
      while (depth > 0 && stack[depth - 1].squared > limit) --depth;
      if (depth == 0) return;
      at = stack[--depth].node;
    }
  }

  // Descends from the root into nodes for which enter(index of the node) is true, and calls visit(item) for
  // the items of their leaves.
  template <class Enter, class Visit>
  void walk(Enter&& enter, Visit&& visit) const {
    for (int i = 0; i < static_cast<int>(nodes_.size());) {
      const Node& n = node(i);
      const bool entered = enter(static_cast<std::size_t>(i));
      if (entered && n.next == i + 1)
        for (const int k : below(n)) visit(k);
      i = entered ? i + 1 : n.next;
    }
  }

  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.value(self.size_);
    p.array(self.nodes_);
    p.array(self.items_);
  }

 private:
  static constexpr int kDeepest = 64;
  static double padded(double squared, double rounding) {
    const double far = std::sqrt(squared) * (1 + 1e-12) + rounding;
    return far * far;
  }
  const Node& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }

  double size_ = 0;  // m, largest magnitude of a coordinate
  ConstArray<Node> nodes_;
  ConstArray<int> items_;
};

}  // namespace hawser
