// The edges of a mesh, each with the triangles that use it side by side.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

// Edge i of a triangle, which runs from its vertex i to the next.
struct EdgeUse {
  int low, high;  // vertices
  int triangle, i;
  bool forward;  // it runs from low to high
  bool same_edge(const EdgeUse& o) const { return low == o.low && high == o.high; }
};

// Of all triangles, in the order of low, high, triangle.
std::vector<EdgeUse> edge_uses(const MeshView& mesh);

}  // namespace hawser::detail
