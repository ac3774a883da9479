// Edges of a mesh, with all uses of an edge by triangles adjacent in the list.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

// Edge i of a triangle, from its vertex i to the next.
struct EdgeUse {
  int low, high;  // vertices
  int triangle, i;
  bool forward;  // from low to high
  bool same_edge(const EdgeUse& o) const { return low == o.low && high == o.high; }
};

// Edges of all triangles, sorted by low, high, triangle.
std::vector<EdgeUse> edge_uses(const MeshView& mesh);

}  // namespace hawser::detail
