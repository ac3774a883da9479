// The ground under an open sheet of triangles, as a closed mesh.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

// Turns every triangle of the welded sheet upward, and closes it by walls under its edges and a floor far
// below. The first triangles are those of the sheet, in their order; the rest is not to be met.
// std::invalid_argument with a sentence for a sheet with a vertical triangle, with an edge of more than two
// triangles, or folded over itself at an edge.
TriangleMesh ground_under(TriangleMesh sheet);

}  // namespace hawser
