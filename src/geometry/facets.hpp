// The facets of a mesh, flat or curved, and the nearest of a chosen part of them to a point.
#pragma once

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
  // m, no point of the facet is farther from the flat triangle.
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
  // Holds the facet, bulge and all.
  Box box(int t) const;
  PatchPoint closest(int t, const Vec3& y) const;
  // m², from y to the flat facet; what closest() says of it but for rounding, and quicker.
  double squared_distance(int t, const Vec3& y) const;
  // False where the facet is certainly farther than `reach` [m] from y: no point of it is farther from the
  // flat one than it bulges. It takes a fraction of the time of closest().
  bool may_reach(int t, const Vec3& y, double reach) const {
    const double far = reach + bulge(t);
    return !(squared_distance(t, y) > far * far);
  }
  // m, no point of the facet is nearer to y: the distance itself where it is certain.
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
  std::vector<bool> thin_;                            // so much that their distances need care
};

// The nearest of the facets that it is shown, no farther than max_distance [m]. tree: of all facets.
class NearestFacet {
  const Facets& facets_;
  const Vec3& y_;
  double rounding_;

 public:
  struct Foot : PatchPoint {
    int triangle = 0;
  };
  NearestFacet(const Facets& facets, const BoxTree& tree, const Vec3& y, double max_distance);
  // Of facets at equal distance the one of the lowest number stays, in whatever order they are shown.
  void visit(int t);
  double squared, reach;  // m², m: what is farther does not count; with room for rounding
  std::optional<Foot> foot;

 private:
  double padded() const;
};

// Search among the facets with their flag set (empty: all): those near by are found by the spatial hash where
// all are flat, others by the tree of their boxes.
class FacetSearch {
 public:
  using Foot = NearestFacet::Foot;
  FacetSearch() = default;
  FacetSearch(const Facets& facets, const std::vector<bool>& chosen);

  // Nothing when none is within max_distance [m]. `hint`: a facet that is likely to be near. Of facets at
  // equal distance always the same, whatever the hint and the limit.
  std::optional<Foot> nearest(const Facets& facets, const Vec3& y, double max_distance, int hint) const;
  // The same of all facets by those about a place near y, or nothing where they do not suffice.
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
  SpatialHash hash_;  // empty where facets are curved
  BoxTree tree_;
  std::vector<bool> chosen_;
};

}  // namespace hawser::detail
