// The facets of a mesh, flat or curved, and the nearest of a chosen part of them to a point.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hawser/geometry/mesh_bends.hpp"
#include "hawser/geometry/smooth_patch.hpp"
#include "hawser/geometry/spatial_hash.hpp"
#include "hawser/geometry/triangle_mesh.hpp"
#include "patch_tree.hpp"

namespace hawser::detail {

class Facets {
 public:
  Facets() = default;
  Facets(const TriangleMesh& mesh, const std::vector<std::array<Eigen::Vector3f, 3>>& bends);

  MeshView mesh() const { return {vertices_, triangles_}; }
  bool curved(int t) const { return !bends_.empty() && !patch(t).flat(); }
  bool any_curved() const { return !bends_.empty(); }
  const Vec3& corner(int t, int i) const {
    return vertices_[static_cast<std::size_t>(
        triangles_[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)])];
  }
  SmoothPatch patch(int t) const {
    SmoothPatch q;
    for (std::size_t i = 0; i < 3; ++i) {
      q.p[i] = corner(t, static_cast<int>(i));
      q.c[i] =
          bends_.empty() ? Vec3(Vec3::Zero()) : Vec3(bends_[static_cast<std::size_t>(t)][i].cast<double>());
    }
    return q;
  }
  PatchPoint closest(int t, const Vec3& y) const;
  // While others are looked at: what a distance to the facet reads, first its indices.
  [[gnu::always_inline]] void fetch(int t) const {
    asm volatile("");  // or gcc leaves the calls out, as they have no effect
    __builtin_prefetch(&triangles_[static_cast<std::size_t>(t)]);
    if (!bends_.empty()) __builtin_prefetch(&bends_[static_cast<std::size_t>(t)]);
  }
  [[gnu::always_inline]] void fetch_corners(int t) const {
    asm volatile("");
    for (int i = 0; i < 3; ++i) __builtin_prefetch(&corner(t, i));
  }
  bool has(int t) const { return t >= 0 && static_cast<std::size_t>(t) < triangles_.size(); }
  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.array(self.vertices_), p.array(self.triangles_), p.array(self.bends_);
  }

 private:
  LargeVector<Vec3> vertices_;
  LargeVector<std::array<int, 3>> triangles_;
  LargeVector<std::array<Eigen::Vector3f, 3>> bends_;  // empty: all flat
};

// Search among the facets with their flag set (empty: all). Flat facets are found by the spatial hash, curved
// ones by a tree of boxes, which know how far each bulges.
class FacetSearch {
 public:
  struct Foot : PatchPoint {
    int triangle = 0;
  };
  FacetSearch() = default;
  FacetSearch(const Facets& facets, const std::vector<bool>& chosen);

  // Nothing when none is within max_distance [m]. Of facets at equal distance always the same.
  std::optional<Foot> nearest(const Facets& facets, const Vec3& y, double max_distance, int hint) const;
  // The same for many: questions[i] to feet[i].
  void nearest(const Facets& facets, std::span<const SpatialHash::Question> questions,
               std::span<std::optional<Foot>> feet) const;
  const Box& box() const { return tree_.empty() ? hash_.box() : tree_.box(); }
  template <class Self, class P>
  static void pack(Self& self, P& p) {
    SpatialHash::pack(self.hash_, p);
    PatchTree::pack(self.tree_, p);
    p.flags(self.chosen_);
  }

 private:
  std::vector<std::uint32_t> order_of(std::span<const SpatialHash::Question> questions) const;

  SpatialHash hash_;
  PatchTree tree_;
  std::vector<bool> chosen_;
};

}  // namespace hawser::detail
