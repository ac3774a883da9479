// Overlapping pairs of boxes, by a walk through the tree of all boxes for each box.
#include "hawser/geometry/box_pairs.hpp"

#include "hawser/geometry/box_tree.hpp"

namespace hawser {

std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes) {
  std::vector<bool> usable(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    usable[i] = boxes[i].lo.allFinite() && boxes[i].hi.allFinite() && !boxes[i].empty();
  const BoxTree tree(boxes, usable);
  std::vector<std::pair<int, int>> out;
  for (const int i : tree.items()) {
    const Box& box = boxes[static_cast<std::size_t>(i)];
    tree.walk([&](std::size_t n) { return tree.nodes()[n].box.overlaps(box); },
              [&](int j) {
                if (i < j && box.overlaps(boxes[static_cast<std::size_t>(j)])) out.emplace_back(i, j);
              });
  }
  return out;
}

}  // namespace hawser
