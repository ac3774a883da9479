// All facets of a mesh near a place: a tree of boxes over runs of eight facets along a space-filling curve,
// eight boxes to a box. About 8 bytes a facet.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "facets.hpp"

namespace hawser::detail {

inline double squared_distance_to_chord(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a, r = p - a;
  const double length2 = e.squaredNorm();
  return length2 > 0 ? (r - std::clamp(r.dot(e) / length2, 0.0, 1.0) * e).squaredNorm() : r.squaredNorm();
}

// Whether it is so for any chord of a polyline; of a single place there is one, of no length.
template <class Is>
bool any_chord(std::span<const Vec3> axis, Is&& is) {
  for (std::size_t i = 0; i + 1 < axis.size() || i == 0; ++i)
    if (is(axis[i], axis[std::min(i + 1, axis.size() - 1)])) return true;
  return false;
}

class FacetBoxes {
 public:
  FacetBoxes() = default;
  // Of the facets with their flag set; empty: all.
  FacetBoxes(const Facets& facets, const std::vector<bool>& chosen);

  bool empty() const { return ids_.empty(); }
  // Calls visit(triangle) for every facet within `reach` of a polyline, and for some farther away.
  template <class Visit>
  void near(std::span<const Vec3> axis, double reach, Visit&& visit) const {
    if (empty()) return;
    Box box;
    for (const Vec3& p : axis) box.add(p);
    descend({bounds_of(box.grown(reach)), axis, reach}, levels_ - 1, 0, visit);
  }
  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.value(self.levels_), p.value(self.first_);
    p.array(self.ids_), p.array(self.boxes_);
  }

 private:
  static constexpr std::size_t kWide = 8;
  static constexpr int kMostLevels = 12;
  struct Bounds {
    float lo[3], hi[3];
    bool overlaps(const Bounds& o) const {
      bool out = false;
      for (int a = 0; a < 3; ++a) out |= lo[a] > o.hi[a] || o.lo[a] > hi[a];
      return !out;
    }
  };
  struct Tube {
    Bounds box;
    std::span<const Vec3> axis;
    double reach;
    // Whether the ball around a box comes into it.
    bool meets(const Bounds& b) const;
  };
  static Bounds bounds_of(const Box& box);
  // The boxes of a level, finest first.
  std::size_t count(int level) const {
    return first_[static_cast<std::size_t>(level) + 1] - first_[static_cast<std::size_t>(level)];
  }
  template <class Visit>
  void descend(const Tube& tube, int level, std::size_t parent, Visit& visit) const {
    const std::size_t last = std::min(kWide * (parent + 1), count(level));
    for (std::size_t i = kWide * parent; i < last; ++i) {
      if (!boxes_[first_[static_cast<std::size_t>(level)] + i].overlaps(tube.box) ||
          !tube.meets(boxes_[first_[static_cast<std::size_t>(level)] + i]))
        continue;
      if (level > 0) {
        descend(tube, level - 1, i, visit);
        continue;
      }
      const std::size_t end = std::min(kWide * (i + 1), ids_.size());
      for (std::size_t k = kWide * i; k < end; ++k) visit(ids_[k]);
    }
  }

  int levels_ = 0;
  std::array<std::uint32_t, kMostLevels + 1> first_{};
  LargeVector<int> ids_;
  LargeVector<Bounds> boxes_;
};

}  // namespace hawser::detail
