// What a search of the spatial hash carries along.
#pragma once

#include <algorithm>
#include <cfloat>
#include <limits>

#include "hawser/geometry/spatial_hash.hpp"
#include "spatial_hash_keys.hpp"

namespace hawser {
namespace detail {

// gcc takes a function that only fetches for one without effect and leaves out calls of it; not so with asm.
[[gnu::always_inline]] inline void prefetch(const void* at, std::size_t bytes = 1) {
  asm volatile("");
  for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(static_cast<const char*>(at) + i);
}

}  // namespace detail

struct SpatialHash::Ball {
  Vec3 p, from_centre;
  float x[3];              // p from centre_
  float limit;             // m², what is farther than this in float is farther than reach
  double rounding;         // m, of x and of what is computed with it in float
  double rounding_double;  // m, of p from centre_ in double
  double best;             // m², of slot, at first the square of the distance asked for
  double reach;            // m, the nearest is not farther than this
  std::uint32_t slot;

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

struct SpatialHash::Item {
  float squared;                // m², distance to its box
  std::uint32_t own, children;  // of its entry, which would set itself to nothing all over the stack
  std::uint32_t frame;          // the block it is in
  Entry entry() const { return {own, children}; }
};

// Up to two cells each way, of a level whose cells are large for the ball.
struct SpatialHash::Start {
  // Side of the cells over the radius and over how far triangles reach out of their cell, at least.
  static constexpr double kRoom = 6;
  bool root = false;  // there is no such level: start from the root
  int level = 0;
  unsigned ways = 0;  // bit a: there is a second cell along axis a
  bool none = false;  // too far from the box of all
  std::uint64_t code[2][3];
  double squared[3];  // m², distance to the second cell along a

  // The cell of which bit a of `which` tells that it is the second along a.
  std::uint64_t key(unsigned which) const {
    return code[which & 1][0] | code[which >> 1 & 1][1] << 1 | code[which >> 2][2] << 2;
  }
  float squared_distance(unsigned which) const {
    double d = 0;
    for (unsigned a = 0; a < 3; ++a) d += which >> a & 1 ? squared[a] : 0.0;
    return static_cast<float>((1 - 1e-6) * d);
  }
};

// One by one, the nearest cells first.
struct SpatialHash::Search : Ball {
  Item stack[8 * (detail::kMaxLevels + 12) + 32];
  int depth = 0;
  static constexpr unsigned kMostCandidates = 32;
  float at_least[kMostCandidates];  // m
  std::uint32_t candidates[kMostCandidates];
  unsigned waiting = 0;
  bool hinted = false;  // the only candidate is the hint, being fetched
  Counters count;

  // Onto the stack above `base`, farthest first.
  void push(int base, float squared, const Entry& entry, std::uint32_t frame) {
    int i = depth++;
    while (i > base && stack[i - 1].squared < squared) {
      stack[i] = stack[i - 1];
      --i;
    }
    stack[i] = {squared, entry.own, entry.children, frame};
  }
};

[[gnu::always_inline]] inline void SpatialHash::fetch_corners(std::uint32_t slot) const {
  for (const std::uint32_t v : corners_[slot].v) detail::prefetch(&vertices_[v]);
}

// While others are looked at.
[[gnu::always_inline]] inline void SpatialHash::fetch(const Entry& e) const {
  if (e.children != kNone) detail::prefetch(&children_[e.children], sizeof(Children));
  if (e.count() > 0) detail::prefetch(&rounded_[3 * std::size_t{e.first()}], 12 * e.count());
}

}  // namespace hawser
