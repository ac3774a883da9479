#include "facet_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spatial_hash_keys.hpp"

namespace hawser::detail {

FacetBoxes::Bounds FacetBoxes::bounds_of(const Box& box) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  Bounds b;
  for (int a = 0; a < 3; ++a) {
    b.lo[a] = std::nextafter(static_cast<float>(box.lo[a]), -inf);
    b.hi[a] = std::nextafter(static_cast<float>(box.hi[a]), inf);
  }
  return b;
}

bool FacetBoxes::Tube::meets(const Bounds& b) const {
  const Vec3 lo(b.lo[0], b.lo[1], b.lo[2]), hi(b.hi[0], b.hi[1], b.hi[2]);
  const Vec3 centre = 0.5 * (lo + hi);
  const double far = 0.5 * (hi - lo).norm() + reach;
  return any_chord(axis, [&](const Vec3& p, const Vec3& q) {
    return squared_distance_to_chord(centre, p, q) <= far * far;
  });
}

FacetBoxes::FacetBoxes(const Facets& facets, const std::vector<bool>& chosen) {
  const std::size_t all = facets.mesh().triangles.size();
  std::vector<int> ids;
  std::vector<Box> own(all);
  Box box;
  for (std::size_t t = 0; t < all; ++t) {
    if (!chosen.empty() && !chosen[t]) continue;
    const SmoothPatch q = facets.patch(static_cast<int>(t));
    // In the hull of its corners and of the middles of its edges bent by c / 2.
    for (std::size_t i = 0; i < 3; ++i) {
      own[t].add(q.p[i]);
      own[t].add(Vec3(0.5 * (q.p[i] + q.p[(i + 1) % 3] + q.c[i])));
    }
    ids.push_back(static_cast<int>(t));
    box.add(own[t]);
  }
  if (ids.empty()) return;
  constexpr double kCells = (1 << 21) - 1;
  const double side = std::max(box.extent().maxCoeff(), 1e-300) / kCells;
  std::vector<std::uint64_t> key(all, 0);
  for (const int id : ids) {
    const Vec3 at = (own[static_cast<std::size_t>(id)].centre() - box.lo) / side;
    std::uint64_t c[3];
    for (int a = 0; a < 3; ++a) c[a] = static_cast<std::uint64_t>(std::clamp(at[a], 0.0, kCells));
    key[static_cast<std::size_t>(id)] = morton(c[0], c[1], c[2]);
  }
  std::sort(ids.begin(), ids.end(), [&](int a, int b) {
    const auto ka = key[static_cast<std::size_t>(a)], kb = key[static_cast<std::size_t>(b)];
    return ka != kb ? ka < kb : a < b;
  });
  std::vector<Box> level;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i % kWide == 0) level.emplace_back();
    level.back().add(own[static_cast<std::size_t>(ids[i])]);
  }
  std::vector<Bounds> boxes;
  while (true) {
    first_[static_cast<std::size_t>(levels_++)] = static_cast<std::uint32_t>(boxes.size());
    for (const Box& b : level) boxes.push_back(bounds_of(b));
    if (level.size() <= kWide || levels_ == kMostLevels) break;
    std::vector<Box> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      if (i % kWide == 0) next.emplace_back();
      next.back().add(level[i]);
    }
    level.swap(next);
  }
  first_[static_cast<std::size_t>(levels_)] = static_cast<std::uint32_t>(boxes.size());
  ids_ = large_copy(ids);
  boxes_ = large_copy(boxes);
}

}  // namespace hawser::detail
