// Repair of meshes as they come: inside out, turned inconsistently, open, joined along edges of more than two
// triangles.
//
// Nothing is moved and no hole is filled. What is listed more than once must have been dropped
// (mesh_duplicates.hpp). The patches of triangles joined two by two are turned: each patch alike (by its
// majority), then so that its front sees the outside, which rays from its triangles vote on: an even number
// of crossings on the way out says outside (Takayama, Jacobson, Kavan & Sorkine-Hornung 2014, "A simple
// method for correcting facet orientations in polygon meshes based on ray casting", J. Comput. Graph. Tech.
// 3(4), the vote by parity). What is inside afterwards is for the winding number to say (winding_tree.hpp).
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct RepairResult {
  int turned = 0;        // triangles turned over
  int one_sided = 0;     // pieces that are one-sided like a Möbius band: left as they were
  bool closed = false;   // now closed, consistent: MeshReport::closed and consistently_oriented
  double enclosing = 0;  // share of the area that has an inside behind it and an outside before it
};
RepairResult repair(TriangleMesh& mesh);

}  // namespace hawser
