// The flat or curved facets of a mesh, and search for the nearest of a subset of them.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "hawser/geometry/box_tree.hpp"
#include "hawser/geometry/mesh_bends.hpp"
#include "hawser/geometry/near_facets.hpp"
#include "hawser/geometry/smooth_patch.hpp"
#include "hawser/geometry/spatial_hash.hpp"
#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

struct DistanceBounds {
  double lower, upper;  // m
};

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
  // Of the facet's distance from y, except for rounding; much faster than closest(). They are sharp unless
  // the facet is farther than `reach` [m].
  DistanceBounds bounds(int t, const Vec3& y, double reach) const;
  // False if the facet is certainly farther than `reach` [m] from y.
  bool may_reach(int t, const Vec3& y, double reach) const { return !(bounds(t, y, reach).lower > reach); }
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

// Nearest of the facets that are offered, within max_distance [m]. Facets wait with the bounds of their
// distance until all have been offered, so that the nearest point of few of them is computed. tree: of all
// facets.
class NearestFacet {
 public:
  struct Foot : PatchPoint {
    int triangle = 0;
  };
  NearestFacet(const Facets& facets, const BoxTree& tree, const Vec3& y, double max_distance);
  // Offers facets, each once; visit() one that is probably the nearest, first of all.
  void visit(int t);
  void offer(int t);
  // Of facets at equal distance the one with the lowest index, whatever the order.
  std::optional<Foot> foot();
  // m, m²: farther facets do not matter; with a margin for rounding.
  double reach = std::numeric_limits<double>::infinity();
  double squared_reach = std::numeric_limits<double>::infinity();

 private:
  struct Waiting {
    int triangle;
    DistanceBounds bounds;
  };
  void limit(double distance);
  void settle();

  const Facets& facets_;
  const Vec3& y_;
  double rounding_;
  double squared_;  // m², of foot_, initially max_distance²
  std::optional<Foot> foot_;
  std::array<Waiting, 16> waiting_;
  std::size_t count_ = 0;  // of them
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
