// Triangle meshes: welding, topology and inspection.
//
// Corners are listed anticlockwise as viewed from outside, so that face normals point outwards. Lengths in m.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct TriangleMesh {
  std::vector<Vec3> vertices;                 // m
  std::vector<std::array<int, 3>> triangles;  // vertex indices
  std::vector<int> part;                      // per triangle, index into parts; empty: one unnamed part
  std::vector<std::string> parts;             // names

  // Index of the part of this name, which is added if missing.
  int part_named(const std::string& name);
  // Removes the triangles for which keep(triangle, its index) is false; keep may change the triangle.
  template <class Keep>
  void keep_triangles(const Keep& keep) {
    std::size_t to = 0;
    const bool named = part.size() == triangles.size();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      std::array<int, 3> triangle = triangles[t];
      if (!keep(triangle, t)) continue;
      if (named) part[to] = part[t];
      triangles[to++] = triangle;
    }
    triangles.resize(to);
    if (named) part.resize(to);
  }
};

// View of a mesh without names and parts; the mesh must outlive it.
struct MeshView {
  std::span<const Vec3> vertices;  // m
  std::span<const std::array<int, 3>> triangles;
  MeshView() = default;
  MeshView(std::span<const Vec3> v, std::span<const std::array<int, 3>> t) : vertices(v), triangles(t) {}
  MeshView(const TriangleMesh& m) : vertices(m.vertices), triangles(m.triangles) {}
  // Corner i of triangle t.
  const Vec3& corner(auto t, auto i) const {
    return vertices[static_cast<std::size_t>(
        triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)])];
  }
  // Half the cross product of two edges, m²: normal to the triangle with its area as length.
  Vec3 area_vector(auto t) const {
    return 0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
  }
  Vec3 centroid(auto t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3; }
  TriangleMesh copy() const {
    return {{vertices.begin(), vertices.end()}, {triangles.begin(), triangles.end()}, {}, {}};
  }
};

// Neighbour across edge i (v_i to v_(i+1)) of each triangle: index of the triangle, or
inline constexpr int kOpenEdge = -1;         // none
inline constexpr int kNonManifoldEdge = -2;  // more than one
struct Topology {
  std::vector<std::array<int, 3>> neighbours;
  std::vector<int> component;  // by triangle; connected across edges of any kind
  int components = 0;
  int open_edges = 0;          // edges with one triangle
  int non_manifold_edges = 0;  // edges with more than two
  int odd_edges = 0;           // edges with an odd number of triangles, including open ones
  int flipped_edges = 0;       // edges of an even number of triangles that do not run half each way:
                               // somewhere beside them a triangle is turned over
};
Topology topology(const TriangleMesh& mesh);

struct MeshReport {
  int triangles = 0, vertices = 0;
  int welded = 0;      // vertices merged by weld(), if known
  int removed = 0;     // triangles removed by weld() because two corners were merged
  int degenerate = 0;  // triangles without area: triangle_normal() is zero
  int open_edges = 0, non_manifold_edges = 0, flipped_edges = 0;
  int components = 0;
  bool closed = false;                 // every edge belongs to an even number of triangles
  bool consistently_oriented = false;  // every edge of 2, 4, ... triangles has half of them in each direction
  bool outward = false;  // components not inside another have volume > 0, those inside (cavities) < 0
  double volume = 0;     // m³, signed, of a closed mesh
  double area = 0;       // m²
  double shortest_edge = 0, longest_edge = 0;  // m
  Box box;
  // True if the mesh can be used for signed distances.
  bool valid() const { return closed && consistently_oriented && outward; }
};
MeshReport inspect(const TriangleMesh& mesh);

struct WeldResult {
  int welded = 0;   // vertices merged into another
  int removed = 0;  // triangles that collapsed
};
// Merges vertices closer than `tolerance` [m] (0: equal coordinates only), and removes unused vertices and
// triangles with two merged corners. The lowest vertex keeps its position; the order is kept.
WeldResult weld(TriangleMesh& mesh, double tolerance = 0);

}  // namespace hawser
