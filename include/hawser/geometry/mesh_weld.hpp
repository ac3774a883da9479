// Welding of cracks along open edges that rounding and noise in a file cause.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct CrackResult {
  int welded = 0;      // corners merged into another
  int removed = 0;     // triangles that collapsed
  double widest = 0;   // m, largest displacement of a corner
  int open_edges = 0;  // remaining open edges
};

// Merges corners of open edges that are nearer to each other than 1/100 of the shortest edge at either. This
// tilts a facet by at most 2/100 rad, which neither creates nor hides an edge. Corners whose edges all join
// two triangles are not changed, so a closed mesh remains as it is, however fine its features. Of merged
// corners the one with the most triangles keeps its position, which removes noise on a few corners. The mesh
// must be welded (equal corners are one). O(n log n).
CrackResult weld_cracks(TriangleMesh& mesh);

}  // namespace hawser
