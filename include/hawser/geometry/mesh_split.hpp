// Splitting of long edges, so that what is linear on each triangle is close to a field that varies.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

// Halves edges longer than `longest` [m] until there are none, on both sides of an edge alike, so that no
// gaps open; stops before the mesh has more than `most` triangles. Parts are lost.
void split_edges(TriangleMesh& mesh, double longest, std::size_t most);

}  // namespace hawser
