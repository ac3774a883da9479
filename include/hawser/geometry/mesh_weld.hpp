// Corners that should be one and are not: cracks along open edges, as rounding and noise of a file leave
// them.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct CrackResult {
  int welded = 0;      // corners that went into another
  int removed = 0;     // triangles that collapsed
  double widest = 0;   // m, the farthest that one went
  int open_edges = 0;  // that are left
};

// Merges corners of open edges that are nearer to each other than 1/100 of the shortest edge at either: a
// facet that this moves tilts by no more than 2/100 rad, which neither makes an edge nor hides one. Corners
// all of whose edges join two triangles stay as they are, so a closed mesh does, however fine its features.
// Of those that merge the corner of the most triangles keeps its place: noise on a few goes. The mesh must be
// welded (equal corners are one). O(n log n).
CrackResult weld_cracks(TriangleMesh& mesh);

}  // namespace hawser
