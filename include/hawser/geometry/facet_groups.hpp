// Facet groups of a surface near a place: parts of it that a thick line can touch at the same time.
//
// A surface query returns the nearest point only. In a corner or a slit this point jumps from one side to the
// other as the query point moves. Each facet group has its own nearest point. Nearby facets form one group if
// they are connected over nearby edges, except across an edge that is reentrant and sharp (26 degrees). Parts
// with similar normals (within 26 degrees) also form one group, because the nearest of them suffices. Parts
// viewed from behind, such as the far side of a thin sheet, form no group.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct FacetGroup {
  struct Facet {
    int triangle = -1;
    Vec3 centre = Vec3::Zero();  // m, centre of a ball that contains the facet
    double radius = 0;           // m
  };
  std::vector<Facet> facets;  // sorted by triangle
};

// Nearest first; empty if the surface's own query suffices.
struct FacetGroups {
  static constexpr int kMaxGroups = 4;  // farther groups are merged with the one most similar in normal
  std::vector<FacetGroup> list;
  bool several() const { return list.size() > 1; }
};

}  // namespace hawser
