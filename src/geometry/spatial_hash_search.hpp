// What a search of the spatial hash carries along.
#pragma once

#include <algorithm>
#include <cfloat>
#include <limits>

#include "hawser/geometry/spatial_hash.hpp"
#include "spatial_hash_keys.hpp"
#include "spatial_hash_lanes.hpp"

namespace hawser {
namespace detail {

// gcc takes a function that only fetches for one without effect and leaves out calls of it; not so with asm.
[[gnu::always_inline]] inline void prefetch(const void* at, std::size_t bytes = 1) {
  asm volatile("");
  for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(static_cast<const char*>(at) + i);
}

}  // namespace detail

struct SpatialHash::Ball {
  Vec3 p;
  detail::Axes from_centre;  // p from centre_
  detail::AxesFloats x;      // the same
  float limit;               // m², what is farther than this in float is farther than reach
  double rounding;           // m, of x and of what is computed with it in float
  double rounding_double;    // m, of p from centre_ in double
  double best;               // m², of slot, at first the square of the distance asked for
  double reach;              // m, the nearest is not farther than this
  std::uint32_t slot;

  // To the boxes of a block.
  detail::BoxLanes squared_distances(const Children& c) const;
  // Those of them within reach.
  detail::Order order(const Children& c) const;
  void bring_in(double r) {
    if (!(r < reach)) return;
    set_reach(r);
  }
  void set_reach(double r) {
    reach = r;
    const double far = r * (1 + 1e-6) + rounding;
    limit = static_cast<float>(std::min(far * far, static_cast<double>(FLT_MAX) / 2));
  }
  void offer(std::uint32_t s, double squared) {
    if (squared > best || (squared == best && s >= slot)) return;
    best = squared;
    slot = s;
    bring_in(std::sqrt(best) * (1 + 1e-12));
  }
};

// Up to two cells each way, of a level whose cells are large for the ball.
struct SpatialHash::Start {
  // Side of the cells over the radius and over how far triangles reach out of their cell, at least.
  static constexpr double kRoom = 6;
  bool root = false;  // there is no such level: start from the root
  int level = 0;
  unsigned ways = 0;        // bit a: there is a second cell along axis a
  bool none = false;        // too far from the box of all
  std::uint64_t own = 0;    // key of the cell the point is in
  std::uint64_t change[4];  // bits of the key that differ in the second cell along a
  float squared[4];         // m², distance to the second cell along a, at most

  // The cell of which bit a of `which` tells that it is the second along a.
  std::uint64_t key(unsigned which) const {
    std::uint64_t k = own;
    for (unsigned a = 0; a < 3; ++a) k ^= which >> a & 1 ? change[a] : 0;
    return k;
  }
  // Those of the eight there are and within the limit, as bits, and the squared distances of all.
  unsigned within(float limit, detail::BoxLanes& d) const {
    constexpr std::uint8_t kThere[8] = {0x01, 0x03, 0x05, 0x0f, 0x11, 0x33, 0x55, 0xff};
    constexpr detail::BoxLanes kSecond[3] = {
        {0, 1, 0, 1, 0, 1, 0, 1}, {0, 0, 1, 1, 0, 0, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}};
    d = kSecond[0] * squared[0] + kSecond[1] * squared[1] + kSecond[2] * squared[2];
    return detail::bits(d <= limit) & kThere[ways];
  }
};

// One by one, the nearest cells first.
struct SpatialHash::Search : Ball {
  explicit Search(Counters& c) : count(c) {}
  static constexpr unsigned kMostCandidates = 32;
  float at_least[kMostCandidates];  // m
  std::uint32_t candidates[kMostCandidates];
  unsigned waiting = 0;
  bool hinted = false;  // the only candidate is the hint, being fetched
  Counters& count;
};

[[gnu::always_inline]] inline void SpatialHash::fetch_corners(std::uint32_t slot) const {
  for (const std::uint32_t v : corners_[slot].v) detail::prefetch(&vertices_[v]);
}

// While others are looked at: a block or a run.
[[gnu::always_inline]] inline void SpatialHash::fetch(const Entry& e) const {
  const void* const block = &children_[e.children == kNone ? 0 : e.children];
  const void* const run = &rounded_[3 * std::size_t{e.first()}];
  detail::prefetch(e.children == kNone ? run : block, 192);
}

}  // namespace hawser
