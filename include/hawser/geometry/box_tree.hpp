// A tree of boxes over items that have a box each: facets of a mesh, flat or curved, boxes of elements.
//
// Halved at the median of the centres along the longest side of their box, until few items are left. Every
// item is in one leaf, and the items of a node lie side by side.
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
    int first = 0, count = 0;  // of items()
    int next = 0;  // node behind all that is below this one; the first below it is the one behind it
  };
  BoxTree() = default;
  // Of the items with their flag set, no flags: of all; `leaf`: so many in a leaf at most.
  explicit BoxTree(std::span<const Box> boxes, const std::vector<bool>& chosen = {}, int leaf = 4);

  bool empty() const { return nodes_.empty(); }
  Box box() const { return empty() ? Box{} : nodes_[0].box; }
  std::span<const Node> nodes() const { return nodes_; }  // each before those below it
  // Numbers of all items, leaf by leaf, and of those below a node.
  std::span<const int> items() const { return items_; }
  std::span<const int> below(const Node& n) const {
    return items().subspan(static_cast<std::size_t>(n.first), static_cast<std::size_t>(n.count));
  }

  // Calls visit(item) for all items that may be within the distance sqrt(squared) [m²] of p, and for some
  // that are not, nearer halves first; visit may lessen `squared`. None just at it is excluded.
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
        const int a = at + 1, b = node(a).next;
        const double to_a = squared_distance(node(a).box, p), to_b = squared_distance(node(b).box, p);
        if (std::max(to_a, to_b) <= limit) stack[depth++] = {std::max(to_a, to_b), to_a > to_b ? a : b};
        at = to_a > to_b ? b : a;
        if (std::min(to_a, to_b) <= limit) continue;
      }
      while (depth > 0 && stack[depth - 1].squared > limit) --depth;
      if (depth == 0) return;
      at = stack[--depth].node;
    }
  }

  // From the top down: what is below a node is looked at where enter(number of the node) is true, and
  // visit(item) is called for the items of leaves.
  template <class Enter, class Visit>
  void walk(Enter&& enter, Visit&& visit) const {
    for (int i = 0; i < static_cast<int>(nodes_.size());) {
      const Node& n = node(i);
      const bool in = enter(static_cast<std::size_t>(i));
      if (in && n.next == i + 1)
        for (const int k : below(n)) visit(k);
      i = in ? i + 1 : n.next;
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

  double size_ = 0;  // m, greatest coordinate
  ConstArray<Node> nodes_;
  ConstArray<int> items_;
};

}  // namespace hawser
