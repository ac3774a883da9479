// Visibility of the triangles of a patch: the outside in front, and an inside behind.
#pragma once

#include <span>
#include <vector>

#include "hawser/geometry/winding_tree.hpp"

namespace hawser::detail {

// True if the front of the patch faces the inside, by most of the rays from its largest triangles: a ray
// towards the outside meets an even number of triangles.
bool front_faces_inside(const MeshView& mesh, const WindingTree& tree, std::vector<int> patch);

// Fraction of such rays that meet nothing on one side, minus that on the other. 1: open space on one side
// only; 0: equal on both sides, such as a fin or a wall.
double one_sided_visibility(const MeshView& mesh, const WindingTree& tree, std::vector<int> patch);

// Fraction of the triangles' area with an inside behind and the outside in front: the winding number on a
// triangle, without its own angle, is between `margin` and 1 - margin. Of very many triangles only some are
// sampled.
double enclosing(const MeshView& mesh, const WindingTree& tree, std::span<const int> triangles,
                 double margin = 0.02);

}  // namespace hawser::detail
