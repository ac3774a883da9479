// Bends of the edges of a mesh, which restore the curvature of faceted surfaces (smooth_patch.hpp).
//
// An edge whose facets meet at more than the crease angle is sharp, the others are smooth. At each vertex the
// facets joined by smooth edges share a normal (Max 1999, "Weights for computing vertex normals from facet
// normals", J. Graphics Tools 4(2); exact if the vertices lie on a sphere or around a cylinder). The bend of
// a smooth edge makes its curve tangential to the tangent planes at its ends:
//
//   c = -1/2 [(p_j - p_i).n_i / (m.n_i) + (p_i - p_j).n_j / (m.n_j)] m,  m = (n_i + n_j) / |n_i + n_j|
//
// This is Phong tessellation with the tangent planes intersected along the edge's own normal m instead of at
// right angles: on a cylinder of any number of facets the patches meet without a kink. A sharp edge that
// continues smoothly from the next one (a rim) is bent in the same way from the tangents at its ends. Edges
// of open sheets and edges of more than two triangles stay straight.
//
// A wide flat facet next to narrow ones (the side of a box with rounded edges) is assumed to be flat: where
// the planar regions at a vertex differ in width by more than 4, the wide ones alone determine the normal. No
// edge bends by more than half its length (bulge: an eighth). Patches that would fold or incline more than 60
// degrees from their facet are bent less or not at all.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct MeshBends {
  // m, for the edges v_i to v_(i+1) of each triangle; identical on both sides of an edge. Empty: all flat.
  std::vector<std::array<Eigen::Vector3f, 3>> edge_bends;
  int curved = 0;    // triangles with a bend
  int sharp = 0;     // edges sharper than the crease angle
  double bulge = 0;  // m, upper bound of the distance of a patch from its facet
};

// `crease_angle` [rad] in (0, pi). `straight`: one flag per triangle whose edges are not bent, or empty.
MeshBends mesh_bends(const TriangleMesh& mesh, const Topology& topo, double crease_angle,
                     const std::vector<bool>& straight = {});

}  // namespace hawser
