// Splitting of long edges, so that quantities that are linear on each triangle approximate a varying field.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

// Halves edges longer than `longest` [m] until there are none, equally on both sides of an edge, so that no
// gaps open. Stops before the mesh exceeds `max_triangles` triangles. Part names are not kept.
void split_edges(TriangleMesh& mesh, double longest, std::size_t max_triangles);

}  // namespace hawser
