// The walls of a surface near a place: parts of it that something thick can touch at the same time.
//
// A surface answers a point with its nearest point. In a corner or a slit that is one wall only, and as the
// point moves the answer jumps from one to the other. Walls are what each has a nearest point of its own:
// facets that come near are one wall where they hang together, over edges as near, and not across an edge
// that is reentrant and sharp (26 degrees). Parts that look the same way (within 26 degrees) are one wall as
// well: of those the nearest is enough. What shows its back, as a thin sheet's other side does, is no wall.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct SurfaceWall {
  struct Facet {
    int triangle = -1;
    Vec3 centre = Vec3::Zero();  // m, of a ball that holds it
    double radius = 0;           // m
  };
  std::vector<Facet> facets;  // by triangle
};

// Nearest first; none where the surface answers for itself.
struct SurfaceWalls {
  static constexpr int kMost = 4;  // farther ones are put to the one that looks most alike
  std::vector<SurfaceWall> of;
  bool several() const { return of.size() > 1; }
};

}  // namespace hawser
