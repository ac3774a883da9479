// Construction of a tree of boxes: split at the median of the centres along the longest side.
#include "hawser/geometry/box_tree.hpp"

#include <algorithm>
#include <utility>

namespace hawser {
namespace {

struct Builder {
  std::span<const Box> boxes;
  int leaf;
  std::vector<int> items;
  std::vector<BoxTree::Node> nodes;

  const Box& box(int item) const { return boxes[static_cast<std::size_t>(item)]; }
  void build(int first, int count) {
    const std::size_t me = nodes.size();
    nodes.push_back({{}, first, count, 0});
    const auto begin = items.begin() + first;
    const auto end = begin + count;
    Box centres;
    for (auto i = begin; i != end; ++i) {
      nodes[me].box.add(box(*i));
      centres.add(box(*i).centre());
    }
    if (count > leaf) {
      int axis = 0;
      centres.extent().maxCoeff(&axis);
      const int half = count / 2;
      std::nth_element(begin, begin + half, end, [&](int a, int b) {
        const double x = box(a).lo[axis] + box(a).hi[axis];
        const double y = box(b).lo[axis] + box(b).hi[axis];
        return x != y ? x < y : a < b;
      });
      build(first, half);
      build(first + half, count - half);
    }
    nodes[me].next = static_cast<int>(nodes.size());
  }
};

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes, const std::vector<bool>& chosen, int leaf) {
  Builder b{boxes, leaf, {}, {}};
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    if (chosen.empty() || chosen[static_cast<std::size_t>(i)]) b.items.push_back(i);
  if (b.items.empty()) return;
  b.build(0, static_cast<int>(b.items.size()));
  size_ = b.nodes[0].box.lo.cwiseAbs().cwiseMax(b.nodes[0].box.hi.cwiseAbs()).maxCoeff();
  nodes_ = std::move(b.nodes);
  items_ = std::move(b.items);
}

}  // namespace hawser
