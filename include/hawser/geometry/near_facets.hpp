// The facets of a mesh about a place, by distance: near that place a query needs no search among all facets.
//
// No distance changes by more than its point moves. A facet at least `least` away from the place is at least
// least - |y - place| away from y, and is not looked at where a nearer one is known.
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
    double least = 0;  // m, no point of the facet is nearer to the place
  };
  static constexpr std::size_t kMost = 8;

  Vec3 place = Vec3::Zero();        // m
  std::array<Facet, kMost> facets;  // nearest first
  std::size_t count = 0;            // of them
  // m, no point of any other facet is nearer to the place. None is known at first.
  double others = 0;

  explicit NearFacets(const Vec3& about) : place(about), others(std::numeric_limits<double>::infinity()) {}
  NearFacets() = default;

  // Called once for each facet; those for which it is not called are no nearer than `others` in the end.
  void add(Facet f) {
    for (std::size_t i = 0; i < count; ++i)
      if (f.least < facets[i].least) std::swap(f, facets[i]);
    if (count < kMost)
      facets[count++] = f;
    else
      others = std::min(others, f.least);
  }
};

}  // namespace hawser
