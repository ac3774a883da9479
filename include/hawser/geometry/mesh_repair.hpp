// Repair of meshes that are inside out, inconsistently oriented, open, or have edges of more than two
// triangles.
//
// No vertex is moved and no hole is filled. Duplicates must have been removed (mesh_duplicates.hpp). Patches
// of triangles joined two by two are first made consistent (by the majority), then oriented so that their
// front faces the outside. Most of the rays from its triangles determine this: an even number of crossings
// indicates the outside (Takayama, Jacobson, Kavan & Sorkine-Hornung 2014, "A simple method for correcting
// facet orientations in polygon meshes based on ray casting", J. Comput. Graph. Tech. 3(4), by parity).
// Afterwards the winding number determines the inside (winding_tree.hpp).
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct RepairResult {
  int turned = 0;        // reversed triangles
  int one_sided = 0;     // pieces that are one-sided like a Möbius band, left unchanged
  bool closed = false;   // closed and consistent after repair: MeshReport::closed and consistently_oriented
  double enclosing = 0;  // fraction of the area with the inside behind and the outside in front of it
};
RepairResult repair(TriangleMesh& mesh);

}  // namespace hawser
