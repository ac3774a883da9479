// Facet groups of a mesh near a place (facet_groups.hpp).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "facets.hpp"
#include "hawser/geometry/facet_groups.hpp"
#include "hawser/math/disjoint_sets.hpp"
#include "pseudonormals.hpp"

namespace hawser::detail {

class MeshFacetGroups {
 public:
  // tree: boxes of the active facets.
  MeshFacetGroups(const Facets& facets, const Pseudonormals& normals, const BoxTree& tree)
      : facets_(facets), normals_(normals), tree_(tree) {}

  // True if the facets form a convex body, which has a single facet group everywhere.
  static bool convex(const Facets& facets, const Pseudonormals& normals, int components);
  // True if the part within reach of a polyline is one facet group: its facets have similar normals, or are
  // connected and convex.
  bool one(std::span<const Vec3> axis, double reach) const;
  // See Surface::facet_groups().
  void find(std::span<const Vec3> axis, double reach, FacetGroups& out) const;

  // True if a facet group contains a triangle.
  static bool holds(const FacetGroup& group, int triangle);

  struct Foot {
    FacetSearch::Foot foot;
    Vec3 pseudonormal = Vec3::Zero();  // of the facet group alone, continued beyond its border
    bool front = false;
  };
  // Nearest point of a facet group within a distance [m] of y.
  std::optional<Foot> nearest(const FacetGroup& group, const Vec3& y, double within) const;
  // True if the facet group continues, at the border point `foot`, into facets that face away from y: then
  // the path to it leads through a body.
  bool through(const FacetGroup& group, const FacetSearch::Foot& foot, const Vec3& y) const;

 private:
  struct Part;
  struct Near : FacetGroup::Facet {
    Vec3 normal;
  };
  static bool within_reach(std::span<const Vec3> axis, double reach, const Vec3& p, const Vec3& q);
  bool parallel(std::span<const Vec3> axis, double reach, std::vector<Near>& out) const;
  bool bulging(std::vector<Near>& near) const;
  struct Approach;
  const std::array<int, 3>& triangle(int t) const {
    return facets_.mesh().triangles[static_cast<std::size_t>(t)];
  }
  FacetGroup::Facet ball(int t) const;
  double bulge(int t) const { return facets_.bulge(t); }
  bool cut(int t, int edge, int other) const;
  Approach approach(int t, const Vec3& a, const Vec3& b) const;
  Vec3 pseudonormal(const FacetGroup& group, const FacetSearch::Foot& foot) const;
  std::vector<FacetGroup::Facet> around(std::span<const Vec3> axis, double reach) const;
  void join(std::span<const Vec3> axis, double reach, const std::vector<FacetGroup::Facet>& facets,
            DisjointSets& sets) const;
  struct Connected;
  void find_nearest(std::span<const Vec3> axis, Connected& c) const;
  std::vector<Connected> connected(std::span<const Vec3> axis, double reach) const;
  Part describe(FacetGroup group, int nearest, const Vec3& from, std::span<const Vec3> axis) const;
  static void merge_parallel(std::vector<Part> parts, FacetGroups& out);

  const Facets& facets_;
  const Pseudonormals& normals_;
  const BoxTree& tree_;
};

}  // namespace hawser::detail
