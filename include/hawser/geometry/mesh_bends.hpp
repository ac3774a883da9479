// Bends of the edges of a mesh: how the facets of a curved surface are curved again (smooth_patch.hpp).
//
// An edge whose facets meet at more than the crease angle is sharp, the others are smooth. At each vertex
// the facets joined by smooth edges share a normal (Max 1999, "Weights for computing vertex normals from
// facet normals", J. Graphics Tools 4(2); exact where the vertices lie on a sphere or around a cylinder). The
// bend of a smooth edge makes its curve meet the tangent planes of its ends:
//
//   c = -1/2 [(p_j - p_i).n_i / (m.n_i) + (p_i - p_j).n_j / (m.n_j)] m,  m = (n_i + n_j) / |n_i + n_j|
//
// which is Phong tessellation with the tangent planes met along the edge's own normal m instead of at right
// angles: on a cylinder of any number of facets patches then meet without a kink. A sharp edge that goes on
// smoothly from the next (a rim) is bent in the same way from the tangents at its ends. Edges of open sheets
// and where more than two triangles meet stay straight.
//
// A wide flat facet next to narrow ones (the side of a box with rounded edges) is taken for flat: where the
// planar regions at a vertex differ in width by more than 4, the wide ones alone set the normal.
// No edge bends by more than half its length (bulge: an eighth); patches that would fold or lean more than 60
// degrees from their facet are bent less, if need be not at all.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct MeshBends {
  // m, of each triangle's edges v_i to v_(i+1); the same from both sides to the last bit. Empty: all flat.
  std::vector<std::array<Eigen::Vector3f, 3>> of;
  int curved = 0;    // triangles with a bend
  int sharp = 0;     // edges sharper than the crease angle
  double bulge = 0;  // m, the farthest a patch lies from its facet, at most
};

// `crease_angle` [rad] in (0, pi). `straight`: one flag a triangle, whose edges are not to be bent; or empty.
MeshBends mesh_bends(const TriangleMesh& mesh, const Topology& topo, double crease_angle,
                     const std::vector<bool>& straight = {});

}  // namespace hawser
