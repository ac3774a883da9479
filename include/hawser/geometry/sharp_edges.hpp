// Sharp edges of a mesh.
#pragma once

#include <utility>
#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

// End vertices of the edges where two triangles meet at more than 10 deg, or where the number of triangles is
// not two; sorted. active: one flag per triangle, the others are ignored; empty: all.
std::vector<std::pair<int, int>> sharp_edges(const MeshView& mesh, const std::vector<bool>& active);

}  // namespace hawser
