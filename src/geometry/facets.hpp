// The flat or curved facets of a mesh, and search for the nearest of a subset of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "hawser/geometry/box_tree.hpp"
#include "hawser/geometry/mesh_bends.hpp"
#include "hawser/geometry/near_facets.hpp"
#include "hawser/geometry/smooth_patch.hpp"
#include "hawser/geometry/spatial_hash.hpp"
#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

class Facets {
 public:
  Facets() = default;
  Facets(const TriangleMesh& mesh, std::vector<std::array<Eigen::Vector3f, 3>> bends);

  MeshView mesh() const { return {vertices_, triangles_}; }
  bool curved(int t) const { return !bends_.empty() && !patch(t).flat(); }
  // Upper bound of the distance of the facet from the flat triangle, m.
  double bulge(int t) const {
    return bulges_.empty() ? 0 : static_cast<double>(bulges_[static_cast<std::size_t>(t)]);
  }
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
  // Bounding box of the facet with its bulge.
  Box box(int t) const;
  PatchPoint closest(int t, const Vec3& y) const;
  // Squared distance of the flat facet from y, m²; equal to that of closest() except for rounding, and
  // faster.
  double squared_distance(int t, const Vec3& y) const;
  // False if the facet is certainly farther than `reach` [m] from y, from the distance of the flat facet and
  // the bulge. Much faster than closest().
  bool may_reach(int t, const Vec3& y, double reach) const {
    const double far = reach + bulge(t);
    return !(squared_distance(t, y) > far * far);
  }
  // Lower bound of the facet's distance from y by the distance of the flat facet and the bulge, m.
  double distance_less_bulge(int t, const Vec3& y) const {
    return std::max(0.0, std::sqrt(squared_distance(t, y)) - bulge(t));
  }
  // Lower bound of the facet's distance from y, m; the distance itself where that is certain.
  double least_distance(int t, const Vec3& y) const;
  bool has(int t) const { return t >= 0 && static_cast<std::size_t>(t) < triangles_.size(); }
  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.array(self.vertices_);
    p.array(self.triangles_);
    p.array(self.bends_);
    p.array(self.bulges_);
    p.flags(self.thin_);
  }

 private:
  ConstArray<Vec3> vertices_;
  ConstArray<std::array<int, 3>> triangles_;
  ConstArray<std::array<Eigen::Vector3f, 3>> bends_;  // empty: all flat
  ConstArray<float> bulges_;                          // m
  std::vector<bool> thin_;                            // facets so thin that their distances need care
};

// Nearest of the visited facets within max_distance [m]. tree: of all facets.
class NearestFacet {
  const Facets& facets_;
  const Vec3& y_;
  double rounding_;

 public:
  struct Foot : PatchPoint {
    int triangle = 0;
  };
  NearestFacet(const Facets& facets, const BoxTree& tree, const Vec3& y, double max_distance);
  // Of facets at equal distance the one with the lowest index remains, whatever the order.
  void visit(int t);
  double squared, reach;  // m², m: search limit, with a margin for rounding
  std::optional<Foot> foot;

 private:
  double padded() const;
};

// Search among the facets with their flag set (empty: all): by the spatial hash for near facets if all are
// flat, else by the tree of boxes.
class FacetSearch {
 public:
  using Foot = NearestFacet::Foot;
  FacetSearch() = default;
  FacetSearch(const Facets& facets, const std::vector<bool>& chosen);

  // Nearest facet within max_distance [m], else nullopt. `hint`: a facet that is probably near. The result
  // does not depend on the hint and the limit.
  std::optional<Foot> nearest(const Facets& facets, const Vec3& y, double max_distance, int hint) const;
  // Nearest of all facets from those near a place close to y; nullopt if these do not suffice.
  std::optional<Foot> nearest(const Facets& facets, const Vec3& y, const NearFacets& near) const;
  NearFacets about(const Facets& facets, const Vec3& place) const;
  const BoxTree& tree() const { return tree_; }
  template <class Self, class P>
  static void pack(Self& self, P& p) {
    SpatialHash::pack(self.hash_, p);
    BoxTree::pack(self.tree_, p);
    p.flags(self.chosen_);
  }

 private:
  SpatialHash hash_;  // empty if facets are curved
  BoxTree tree_;
  std::vector<bool> chosen_;
};

}  // namespace hawser::detail
