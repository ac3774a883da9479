// Spatial hash: cubes of one size, each with the items whose boxes overlap it. Items near a point are found
// in the cubes around it, ring by ring outwards.
//
// The coordinates of a cube are hashed to an entry of a table (Teschner, Heidelberger, Müller, Pomeranets &
// Gross 2003, "Optimized spatial hashing for collision detection of deformable objects"). Cubes with the same
// hash share an entry, which costs time but does not change results, so that cubes need not be stored. Cubes
// are about as large as the items, and larger if a few large items would be in too many, so that memory is
// proportional to the number of items. Efficient up to distances of some cubes; beyond that BoxTree is
// faster.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/const_array.hpp"

namespace hawser {

class SpatialHash {
 public:
  SpatialHash() = default;
  // chosen: one flag per item, empty for all.
  explicit SpatialHash(std::span<const Box> boxes, const std::vector<bool>& chosen = {});

  bool empty() const { return items_.empty(); }
  double side() const { return side_; }                  // m, of a cube
  std::size_t entries() const { return items_.size(); }  // entries of items in cubes

  // As BoxTree::nearest(); an item may be visited several times.
  template <class Visit>
  void nearest(const Vec3& p, double& squared, Visit&& visit) const {
    if (empty()) return;
    const Cell at = cell_of(p);
    double cubes = 0;
    for (int ring = 0; distance_to(ring, at, p) <= std::sqrt(squared) * kMore; ++ring) {
      cubes += 24.0 * ring * ring + 2;
      if (cubes > static_cast<double>(items_.size())) {  // more cubes than items
        for (const int i : items_) visit(i);
        return;
      }
      each_of_ring(ring, at, [&](const Cell& c) {
        if (squared_distance(box_of(c), p) > squared * kMore) return;
        const std::size_t k = place(c);
        for (std::uint32_t i = first_[k]; i < first_[k + 1]; ++i) visit(items_[i]);
      });
    }
  }

  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.value(self.origin_);
    p.value(self.side_);
    p.value(self.last_);
    p.value(self.places_);
    p.array(self.first_);
    p.array(self.items_);
  }

 private:
  using Cell = Eigen::Vector3i;
  Cell cell_of(const Vec3& p) const {
    Cell c;
    for (int a = 0; a < 3; ++a)
      c[a] = static_cast<int>(std::clamp((p[a] - origin_[a]) / side_, 0.0, static_cast<double>(last_[a])));
    return c;
  }
  // Box of a cube, slightly enlarged for rounding.
  Box box_of(const Cell& c) const {
    const Vec3 lo = origin_ + side_ * c.cast<double>();
    return Box{lo, lo + Vec3::Constant(side_)}.grown(kRounding * side_);
  }
  std::size_t place(const Cell& c) const {
    const auto part = [&](int a, std::uint64_t prime) { return static_cast<std::uint64_t>(c[a]) * prime; };
    const std::uint64_t h = part(0, 73856093) ^ part(1, 19349663) ^ part(2, 83492791);
    return static_cast<std::size_t>(h ^ h >> 20) & (places_ - 1);
  }
  // Lower bound of the distance from p to the cubes of this and outer rings, m; infinite if there are none.
  double distance_to(int ring, const Cell& at, const Vec3& p) const {
    if (ring == 0) return 0;
    double distance = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
      const int below = at[a] - ring;
      const int above = at[a] + ring;
      if (below >= 0) distance = std::min(distance, p[a] - (origin_[a] + side_ * (below + 1)));
      if (above <= last_[a]) distance = std::min(distance, origin_[a] + side_ * above - p[a]);
    }
    return distance - kRounding * side_;
  }
  // Calls visit(cell) for the cubes whose largest coordinate difference from `at` is `ring`.
  template <class Visit>
  void each_of_ring(int ring, const Cell& at, Visit&& visit) const {
    const auto from = [&](int a) { return std::max(at[a] - ring, 0); };
    const auto to = [&](int a) { return std::min(at[a] + ring, last_[a]); };
    for (int i = from(0); i <= to(0); ++i)
      for (int j = from(1); j <= to(1); ++j) {
        const bool face = std::abs(i - at[0]) == ring || std::abs(j - at[1]) == ring;
        if (face)
          for (int k = from(2); k <= to(2); ++k) visit(Cell{i, j, k});
        else
          for (const int k : {at[2] - ring, at[2] + ring})
            if (k >= 0 && k <= last_[2]) visit(Cell{i, j, k});
      }
  }

  static constexpr double kRounding = 1e-6, kMore = 1 + 1e-12;
  Vec3 origin_ = Vec3::Zero();
  double side_ = 1;
  Cell last_ = Cell::Zero();         // largest coordinates of a cube
  std::uint64_t places_ = 1;         // a power of two
  ConstArray<std::uint32_t> first_;  // first entry in items_ by place
  ConstArray<int> items_;
};

}  // namespace hawser
