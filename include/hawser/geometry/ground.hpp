// The ground below an open sheet of triangles, as a closed mesh.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

// Turns every triangle of the welded sheet upward, and closes it by walls under its edges and a floor far
// below. The first triangles are those of the sheet, in their order; the rest take no part in contact. Throws
// std::invalid_argument with a message for a sheet with a vertical triangle, an edge of more than two
// triangles, or a fold at an edge.
TriangleMesh ground_under(TriangleMesh sheet);

}  // namespace hawser
