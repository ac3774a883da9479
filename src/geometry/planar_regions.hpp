// Width of the planar region around each triangle.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

// Smallest extent [m], of its two principal directions, of the region of connected triangles in the plane of
// each triangle. 0 for triangles without area (`normals`: unit face normals, zero for these).
std::vector<double> planar_widths(const TriangleMesh& mesh, const Topology& topo,
                                  const std::vector<Vec3>& normals);

}  // namespace hawser::detail
