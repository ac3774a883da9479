// Topology of a mesh from its sorted edges, its inspection, and merging of equal corners.
#include "hawser/geometry/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "edge_uses.hpp"
#include "hawser/geometry/closest_point.hpp"
#include "hawser/math/disjoint_sets.hpp"
#include "hawser/math/ordered.hpp"
#include "near_points.hpp"
#include "nesting.hpp"

namespace hawser {
namespace {

// Lowest vertex with which each vertex merges.
std::vector<int> representatives(const std::vector<Vec3>& vertices, double tolerance) {
  const detail::NearPoints near(vertices);
  std::vector<int> same(vertices.size());
  for (int v = 0; v < static_cast<int>(same.size()); ++v) {
    int best = v;
    near.each(v, tolerance, [&](int w) {
      if (w < best && same[static_cast<std::size_t>(w)] == w) best = w;
    });
    same[static_cast<std::size_t>(v)] = best;
  }
  return same;
}

}  // namespace

std::vector<detail::EdgeUse> detail::edge_uses(const MeshView& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = mesh.triangles[t][i];
      const int to = mesh.triangles[t][(i + 1) % 3];
      const auto [low, high] = ordered(from, to);
      uses.push_back({low, high, static_cast<int>(t), static_cast<int>(i), from < to});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle, a.i) < std::tie(b.low, b.high, b.triangle, b.i);
  });
  return uses;
}

Topology topology(const TriangleMesh& mesh) {
  Topology out;
  const std::size_t n = mesh.triangles.size();
  out.neighbours.assign(n, {kOpenEdge, kOpenEdge, kOpenEdge});
  DisjointSets group(n);
  const auto uses = detail::edge_uses(mesh);
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    int balance = 0;
    for (j = i; j < uses.size() && uses[j].same_edge(uses[i]); ++j) {
      balance += uses[j].forward ? 1 : -1;
      group.unite(uses[i].triangle, uses[j].triangle);
    }
    const std::size_t count = j - i;
    if (count == 1) ++out.open_edges;
    if (count > 2) ++out.non_manifold_edges;
    if (count % 2 == 1)
      ++out.odd_edges;
    else if (balance != 0)
      ++out.flipped_edges;
    for (std::size_t k = i; k < j; ++k) {
      int& neighbour =
          out.neighbours[static_cast<std::size_t>(uses[k].triangle)][static_cast<std::size_t>(uses[k].i)];
      if (count == 2) neighbour = uses[k == i ? j - 1 : i].triangle;
      if (count > 2) neighbour = kNonManifoldEdge;
    }
  }
  out.component = group.numbered(out.components);
  return out;
}

MeshReport inspect(const TriangleMesh& mesh) {
  MeshReport r;
  const Topology topo = topology(mesh);
  r.triangles = static_cast<int>(mesh.triangles.size());
  r.vertices = static_cast<int>(mesh.vertices.size());
  r.open_edges = topo.open_edges;
  r.non_manifold_edges = topo.non_manifold_edges;
  r.flipped_edges = topo.flipped_edges;
  r.components = topo.components;
  r.closed = r.triangles > 0 && topo.odd_edges == 0;
  r.consistently_oriented = topo.flipped_edges == 0;
  double shortest2 = std::numeric_limits<double>::infinity();
  double longest2 = 0;
  const MeshView view(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      r.box.add(view.corner(t, i));
      const double l2 = (view.corner(t, (i + 1) % 3) - view.corner(t, i)).squaredNorm();
      shortest2 = std::min(shortest2, l2);
      longest2 = std::max(longest2, l2);
    }
    if (triangle_normal(view.corner(t, 0), view.corner(t, 1), view.corner(t, 2)).isZero(0)) ++r.degenerate;
    r.area += view.area_vector(t).norm();
  }
  if (r.triangles > 0) {
    r.shortest_edge = std::sqrt(shortest2);
    r.longest_edge = std::sqrt(longest2);
  }
  const std::vector<double> volumes = detail::component_volumes(mesh, topo);
  r.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  if (r.closed && r.consistently_oriented) {
    const std::vector<int> depth = detail::nesting_depth(mesh, topo);
    r.outward = true;
    for (std::size_t c = 0; c < volumes.size(); ++c)
      if (volumes[c] != 0 && (volumes[c] > 0) != (depth[c] % 2 == 0)) r.outward = false;
  }
  return r;
}

int TriangleMesh::part_named(const std::string& name) {
  const auto it = std::find(parts.begin(), parts.end(), name);
  if (it != parts.end()) return static_cast<int>(it - parts.begin());
  parts.push_back(name);
  return static_cast<int>(parts.size()) - 1;
}

WeldResult weld(TriangleMesh& mesh, double tolerance) {
  WeldResult result;
  const std::vector<int> same = representatives(mesh.vertices, tolerance);
  std::vector<int> renumbered(mesh.vertices.size(), -1);
  std::vector<char> used(mesh.vertices.size(), 0);
  mesh.keep_triangles([&](std::array<int, 3>& tri, std::size_t) {
    for (int& v : tri) v = same[static_cast<std::size_t>(v)];
    if (tri[0] == tri[1] || tri[1] == tri[2] || tri[2] == tri[0]) {
      ++result.removed;
      return false;
    }
    for (const int v : tri) used[static_cast<std::size_t>(v)] = 1;
    return true;
  });
  std::size_t n = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (same[v] != static_cast<int>(v)) ++result.welded;
    if (!used[v]) continue;
    renumbered[v] = static_cast<int>(n);
    mesh.vertices[n++] = mesh.vertices[v];
  }
  mesh.vertices.resize(n);
  for (auto& tri : mesh.triangles)
    for (int& v : tri) v = renumbered[static_cast<std::size_t>(v)];
  return result;
}

}  // namespace hawser
