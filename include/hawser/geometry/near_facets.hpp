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
#include <vector>

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
  // True if the nearest facet of y is probably in the list. If the first lower bound is the distance d of its
  // facet, that facet is at most d + |y - place| from y, and facets outside the list are at least
  // others - |y - place| from y.
  bool suffices_for(const Vec3& y) const {
    return count > 0 && 2 * (y - place).norm() < others - facets[0].lower_bound;
  }
};

// Lists about several places, for queries along an axis.
class NearFacetLists {
 public:
  // A list that suffices for y, the last one used if possible; if none does, one that can be replaced by a
  // list about y: an empty one, or the oldest.
  NearFacets& about(const Vec3& y) {
    if (last_ < lists_.size() && lists_[last_].suffices_for(y)) return lists_[last_];
    for (last_ = 0; last_ < lists_.size(); ++last_)
      if (lists_[last_].suffices_for(y)) return lists_[last_];
    if (!lists_.empty() && lists_.back().count == 0) return lists_.back();
    if (lists_.size() < kMaxLists) return lists_.emplace_back();
    oldest_ = (oldest_ + 1) % kMaxLists;
    last_ = oldest_;
    return lists_[last_];
  }
  void clear() { lists_.clear(); }

 private:
  static constexpr std::size_t kMaxLists = 32;
  std::vector<NearFacets> lists_;
  std::size_t last_ = 0, oldest_ = 0;
};

}  // namespace hawser
