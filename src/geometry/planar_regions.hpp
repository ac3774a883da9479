// How wide the planar region around each triangle is.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

// Least extent [m] of the region of connected triangles in the plane of each triangle, in its two principal
// directions. 0 for triangles of no area (`normals`: unit face normals, zero where there is none).
std::vector<double> planar_widths(const TriangleMesh& mesh, const Topology& topo,
                                  const std::vector<Vec3>& normals);

}  // namespace hawser::detail
