// What the triangles of a patch see: the outside, and an inside behind them.
#pragma once

#include <span>
#include <vector>

#include "hawser/geometry/winding_tree.hpp"

namespace hawser::detail {

// Rays from the largest triangles of the patch vote. Above 0: its front sees the outside, as they meet an
// even number of triangles on the way out.
int front_sees_outside(const MeshView& mesh, const WindingTree& tree, std::vector<int> patch);

// Of such rays the share that meets nothing: that of one side less that of the other. 1: the patch has the
// open before it and none of it behind; 0: the same on both sides, as a fin or a wall.
double one_sided_visibility(const MeshView& mesh, const WindingTree& tree, std::vector<int> patch);

// Share of the area of the triangles that has an inside behind it and an outside before it: the winding
// number on a triangle, its own angle excluded, is above `margin` and below 1 - margin. Of very many some are
// asked.
double enclosing(const MeshView& mesh, const WindingTree& tree, std::span<const int> triangles,
                 double margin = 0.02);

}  // namespace hawser::detail
