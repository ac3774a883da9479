// Triangle meshes: welding, topology, and what is wrong with one.
//
// Corners are listed anticlockwise seen from outside, so that face normals point out. Lengths in m.
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

  // Index of a part, which is made if there is none of that name.
  int part_named(const std::string& name);
  // Leaves the triangles away of which keep(triangle, its index) is false; keep may change the triangle.
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

// The same without names and parts, where it lies; it must live longer.
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
  // m², half the cross product of two edges: along the normal, as long as the area.
  Vec3 area_vector(auto t) const {
    return 0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
  }
  Vec3 centroid(auto t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3; }
  TriangleMesh copy() const {
    return {{vertices.begin(), vertices.end()}, {triangles.begin(), triangles.end()}, {}, {}};
  }
};

// Across edge i (v_i to v_(i+1)) of each triangle: the triangle on the other side, or
inline constexpr int kOpenEdge = -1;         // none
inline constexpr int kNonManifoldEdge = -2;  // more than one
struct Topology {
  std::vector<std::array<int, 3>> neighbours;
  std::vector<int> component;  // per triangle; joined across edges of any kind
  int components = 0;
  int open_edges = 0;          // edges with one triangle
  int non_manifold_edges = 0;  // edges with more than two
  int odd_edges = 0;           // edges with an odd number of triangles, the open ones among them
  int flipped_edges = 0;       // edges of an even number of triangles that do not run half each way:
                               // somewhere beside them a triangle is turned over
};
Topology topology(const TriangleMesh& mesh);

struct MeshReport {
  int triangles = 0, vertices = 0;
  int welded = 0;      // vertices merged by weld(), if that is known
  int removed = 0;     // triangles removed by weld() as two of their corners were one vertex
  int degenerate = 0;  // triangles of no area: triangle_normal() is zero
  int open_edges = 0, non_manifold_edges = 0, flipped_edges = 0;
  int components = 0;
  bool closed = false;                 // every edge belongs to an even number of triangles
  bool consistently_oriented = false;  // every edge of 2, 4, ... triangles runs half of them each way
  bool outward = false;  // components not inside another have volume > 0, those inside (cavities) < 0
  double volume = 0;     // m³, signed; of a closed mesh
  double area = 0;       // m²
  double shortest_edge = 0, longest_edge = 0;  // m
  Box box;
  // Fit for signed distance as it is.
  bool valid() const { return closed && consistently_oriented && outward; }
};
MeshReport inspect(const TriangleMesh& mesh);

struct WeldResult {
  int welded = 0;   // vertices that went into another
  int removed = 0;  // triangles that collapsed
};
// Merge vertices closer than `tolerance` [m] (0: equal coordinates only); drop unused vertices and
// triangles with two corners merged. The lowest vertex keeps its place; order stays.
WeldResult weld(TriangleMesh& mesh, double tolerance = 0);

}  // namespace hawser
