// Several walls of one volume at a node: which of its pairs is about which.
#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/terms/volume_contact.hpp"

namespace hawser {
namespace {

constexpr double kSame = 0.5;  // cosine: a wall whose normal is no more like that of before is another one

}  // namespace

bool VolumeContact::one_wall(const Pair& pair, const Vec3& y, double motion) const {
  return volumes_[static_cast<size_t>(pair.volume)].surface->one_wall({&y, 1},
                                                                      kTogether * pair.touch + motion);
}

int VolumeContact::see_wall(const Pair& pair, const Vec3& y) const {
  Walls& w = *pair.walls;
  if (!w.known || w.at != y) {
    w.known = true, w.at = y;
    w.near.of.clear();
    if (!still_clear(w.clear, w.centre, y, 0)) {
      const size_t k = static_cast<size_t>(pair.volume);
      const double reach = 0.5 * element_[static_cast<size_t>(pair.node)];
      const auto p = volumes_[k].surface->query(y, pair.touch + reach, w.hint);
      w.centre = y;
      w.clear = clear_about(pair, y, p ? p->distance : pair.touch + reach);
      if (p) w.hint = p->triangle;
      if (p && p->distance < pair.touch) volumes_[k].surface->walls({&y, 1}, kTogether * pair.touch, w.near);
    }
    assign(pair, y, w);
  }
  return w.wall[static_cast<size_t>(pair.slot)];
}

void VolumeContact::assign(const Pair& pair, const Vec3& y, Walls& w) const {
  const Surface& surface = *volumes_[static_cast<size_t>(pair.volume)].surface;
  constexpr double kFar = std::numeric_limits<double>::max();
  std::array<std::optional<SurfacePoint>, SurfaceWalls::kMost> at;
  const size_t walls = w.near.several() ? w.near.of.size() : 1;
  w.wall.fill(Walls::kNone);
  if (walls == 1) {
    const bool more =
        std::any_of(w.committed.begin() + 1, w.committed.end(), [](const History& h) { return h.touches; });
    if (more && w.clear < 0) at[0] = surface.query(y, pair.touch, w.hint);
  }
  for (size_t i = 0; i < walls && walls > 1; ++i) at[i] = surface.query_wall(w.near.of[i], y, kFar, true);
  const auto name = [&](size_t wall) { return walls == 1 ? Walls::kAll : static_cast<int>(wall); };
  std::array<bool, SurfaceWalls::kMost> given{};
  for (size_t round = 0; round < walls; ++round) {
    double like = kSame;
    size_t slot = walls, wall = walls;
    for (size_t i = 0; i < walls; ++i)
      for (size_t s = 0; s < w.committed.size(); ++s) {
        if (given[i] || !at[i] || !w.committed[s].touches || w.wall[s] != Walls::kNone) continue;
        if (const double dot = at[i]->normal.dot(w.committed[s].normal); dot > like)
          like = dot, wall = i, slot = s;
      }
    if (wall == walls) break;
    given[wall] = true, w.wall[slot] = name(wall);
  }
  // The others to pairs that touched nothing.
  for (const bool free : {true, false})
    for (size_t i = 0; i < walls; ++i)
      for (size_t s = 0; s < w.committed.size() && !given[i]; ++s)
        if (w.wall[s] == Walls::kNone && w.committed[s].touches != free) given[i] = true, w.wall[s] = name(i);
}

ContactStart VolumeContact::start(const Pair& pair, const Vec3& y) const {
  ContactStart s = pair.start;
  const int wall = see_wall(pair, y);
  if (wall == Walls::kNone) return s;
  const Surface& surface = *volumes_[static_cast<size_t>(pair.volume)].surface;
  const auto p =
      wall == Walls::kAll
          ? surface.query(s.point, pair.touch + element_[static_cast<size_t>(pair.node)], pair.hint)
          : surface.query_wall(pair.walls->near.of[static_cast<size_t>(wall)], s.point,
                               std::numeric_limits<double>::max(), true);
  if (p) s.gap = p->distance - nodes_[static_cast<size_t>(pair.node)].radius;
  return s;
}

int VolumeContact::candidates() const {
  return static_cast<int>(
      std::count_if(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.slot == 0; }));
}

int VolumeContact::touching() const {
  int count = 0;
  const Pair* last = nullptr;  // walls of one volume count once
  for (const Pair& p : pairs_) {
    if (!p.history.touches) continue;
    count += !(last && last->node == p.node && last->volume == p.volume);
    last = &p;
  }
  return count;
}

}  // namespace hawser
