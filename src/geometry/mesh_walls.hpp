// The walls of a mesh near a place (surface_walls.hpp).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "facets.hpp"
#include "hawser/geometry/surface_walls.hpp"
#include "pseudonormals.hpp"

namespace hawser::detail {

class MeshWalls {
 public:
  // `tree`: of the boxes of those facets that can be met.
  MeshWalls(const Facets& facets, const Pseudonormals& normals, const BoxTree& tree)
      : facets_(facets), normals_(normals), tree_(tree) {}

  // Whether the facets form a convex body, which has no two walls anywhere.
  static bool convex(const Facets& facets, const Pseudonormals& normals, int components);
  // Whether what is within reach of a polyline is one wall: its facets all look alike, or hang together and
  // are convex.
  bool one(std::span<const Vec3> axis, double reach) const;
  // As of Surface::walls().
  void find(std::span<const Vec3> axis, double reach, SurfaceWalls& out) const;

  // Whether a triangle is of a wall.
  static bool holds(const SurfaceWall& wall, int triangle);

  struct Foot {
    FacetSearch::Foot foot;
    Vec3 pseudonormal = Vec3::Zero();  // of the wall alone: beyond its border it goes on as it ends
    bool front = false;
  };
  // Nearest point of a wall within a distance [m] of y.
  std::optional<Foot> nearest(const SurfaceWall& wall, const Vec3& y, double within) const;
  // Whether the wall goes on, where its nearest point is on its border, in what turns its back on y: then the
  // way to it leads through a body.
  bool through(const SurfaceWall& wall, const FacetSearch::Foot& foot, const Vec3& y) const;

 private:
  struct Part;
  struct Near {
    SurfaceWall::Facet facet;
    Vec3 normal;
  };
  static bool comes_near(std::span<const Vec3> axis, double reach, const Vec3& p, const Vec3& q);
  bool alike(std::span<const Vec3> axis, double reach, std::vector<Near>& out) const;
  bool bulging(std::vector<Near>& near) const;
  struct Approach;
  const std::array<int, 3>& triangle(int t) const {
    return facets_.mesh().triangles[static_cast<std::size_t>(t)];
  }
  SurfaceWall::Facet ball(int t) const;
  double bulge(int t) const { return facets_.bulge(t); }
  bool cut(int t, int edge, int other) const;
  Approach approach(int t, const Vec3& a, const Vec3& b) const;
  Vec3 pseudonormal(const SurfaceWall& wall, const FacetSearch::Foot& foot) const;
  std::vector<SurfaceWall::Facet> around(std::span<const Vec3> axis, double reach) const;
  void join(std::span<const Vec3> axis, double reach, const std::vector<SurfaceWall::Facet>& facets,
            std::vector<int>& group) const;
  Part look(SurfaceWall wall, int nearest, const Vec3& from, std::span<const Vec3> axis) const;

  const Facets& facets_;
  const Pseudonormals& normals_;
  const BoxTree& tree_;
};

}  // namespace hawser::detail
