// Edges of a mesh where it turns.
#pragma once

#include <utility>
#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

// Ends of the edges where two triangles meet at more than 10 deg, or where there are not two; in the order of
// the ends. active: one flag a triangle, those of the others are excluded; empty: all.
std::vector<std::pair<int, int>> sharp_edges(const MeshView& mesh, const std::vector<bool>& active);

}  // namespace hawser
