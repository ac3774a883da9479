#include <algorithm>

#include "hawser/geometry/surface.hpp"

namespace hawser {

void Surface::walls(std::span<const Vec3>, double, SurfaceWalls& out) const { out.of.clear(); }

bool Surface::one_wall(std::span<const Vec3>, double) const { return true; }

std::optional<SurfacePoint> Surface::query_wall(const SurfaceWall&, const Vec3& y, double max_distance,
                                                bool) const {
  return query(y, max_distance);
}

std::vector<SurfacePoint> nearest_on_walls(const Surface& surface, const Vec3& y, double max_distance) {
  SurfaceWalls walls;
  if (!surface.one_wall({&y, 1}, max_distance)) surface.walls({&y, 1}, max_distance, walls);
  std::vector<SurfacePoint> out;
  if (!walls.several()) {
    if (const auto p = surface.query(y, max_distance)) out.push_back(*p);
    return out;
  }
  for (const SurfaceWall& w : walls.of)
    if (const auto p = surface.query_wall(w, y, max_distance)) out.push_back(*p);
  std::stable_sort(out.begin(), out.end(),
                   [](const SurfacePoint& a, const SurfacePoint& b) { return a.distance < b.distance; });
  return out;
}

}  // namespace hawser
