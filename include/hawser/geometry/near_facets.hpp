// Facets of a mesh near a place, sorted by distance, so that queries near this place need no search among all
// facets.
//
// A distance changes by no more than its point moves: a facet at least `lower_bound` away from the place is
// at least lower_bound - |y - place| away from y, and is skipped if a nearer one is known.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "hawser/math/types.hpp"

namespace hawser {

struct NearFacets {
  struct Facet {
    int triangle = -1;
    double lower_bound = 0;  // m, lower bound of the facet's distance from the place
  };
  static constexpr std::size_t kMaxFacets = 8;

  Vec3 place = Vec3::Zero();             // m
  std::array<Facet, kMaxFacets> facets;  // nearest first
  std::size_t count = 0;                 // of them
  // m, lower bound of the distance of all other facets from the place. Initially none is known.
  double others = 0;

  explicit NearFacets(const Vec3& about) : place(about), others(std::numeric_limits<double>::infinity()) {}
  NearFacets() = default;

  // Called once for each facet; facets that are not added must be at least `others` away in the end.
  void add(Facet f) {
    for (std::size_t i = 0; i < count; ++i)
      if (f.lower_bound < facets[i].lower_bound) std::swap(f, facets[i]);
    if (count < kMaxFacets)
      facets[count++] = f;
    else
      others = std::min(others, f.lower_bound);
  }
};

}  // namespace hawser
