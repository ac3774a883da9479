// The facet groups of a surface near a place: parts of it that something thick can touch at the same time.
//
// A surface answers a point with its nearest point. In a corner or a slit that is one facet group only, and
// as the point moves the answer jumps from one to the other. Facet groups are what each has a nearest point
// of its own: facets that come near are one facet group where they hang together, over edges as near, and not
// across an edge that is reentrant and sharp (26 degrees). Parts that look the same way (within 26 degrees)
// are one facet group as well: of those the nearest is enough. What shows its back, as a thin sheet's other
// side does, is no facet group.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct FacetGroup {
  struct Facet {
    int triangle = -1;
    Vec3 centre = Vec3::Zero();  // m, of a ball that holds it
    double radius = 0;           // m
  };
  std::vector<Facet> facets;  // by triangle
};

// Nearest first; none where the surface answers for itself.
struct FacetGroups {
  static constexpr int kMost = 4;  // farther ones are put to the one that looks most alike
  std::vector<FacetGroup> of;
  bool several() const { return of.size() > 1; }
};

}  // namespace hawser
