// Merging of corners along open edges whose distance is small compared with the edges there.
#include "hawser/geometry/mesh_weld.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hawser/math/disjoint_sets.hpp"
#include "near_points.hpp"

namespace hawser {
namespace {

constexpr double kCrack = 1.0 / 100;  // fraction of the shortest edge

}  // namespace

CrackResult weld_cracks(TriangleMesh& mesh) {
  CrackResult result;
  const Topology topo = topology(mesh);
  result.open_edges = topo.open_edges;
  if (topo.open_edges == 0) return result;
  const std::size_t n = mesh.vertices.size();
  const auto x = [&mesh](int v) -> const Vec3& { return mesh.vertices[static_cast<std::size_t>(v)]; };
  std::vector<char> open(n, 0);
  std::vector<int> uses(n, 0);
  std::vector<double> tolerance(n, std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = mesh.triangles[t][i];
      const int b = mesh.triangles[t][(i + 1) % 3];
      ++uses[static_cast<std::size_t>(a)];
      const double limit = kCrack * (x(a) - x(b)).norm();
      for (const int v : {a, b}) {
        auto& vertex_tolerance = tolerance[static_cast<std::size_t>(v)];
        vertex_tolerance = std::min(vertex_tolerance, limit);
        if (topo.neighbours[t][i] == kOpenEdge) open[static_cast<std::size_t>(v)] = 1;
      }
    }
  const detail::NearPoints near(mesh.vertices);
  DisjointSets group(n);
  for (std::size_t v = 0; v < n; ++v) {
    if (!open[v]) continue;
    near.each(static_cast<int>(v), tolerance[v], [&](int w) {
      if (open[static_cast<std::size_t>(w)] &&
          (x(w) - mesh.vertices[v]).norm() <= tolerance[static_cast<std::size_t>(w)])
        group.unite(static_cast<int>(v), w);
    });
  }
  // In each group the corner with the most triangles, the lowest of equal ones.
  std::vector<int> keeps(n, -1);
  for (std::size_t v = 0; v < n; ++v) {
    int& best = keeps[static_cast<std::size_t>(group.smallest(static_cast<int>(v)))];
    if (best < 0 || uses[v] > uses[static_cast<std::size_t>(best)]) best = static_cast<int>(v);
  }
  std::vector<Vec3> moved = mesh.vertices;
  for (std::size_t v = 0; v < n; ++v) {
    const int to = keeps[static_cast<std::size_t>(group.smallest(static_cast<int>(v)))];
    if (to == static_cast<int>(v)) continue;
    moved[v] = x(to);
    result.widest = std::max(result.widest, (moved[v] - mesh.vertices[v]).norm());
    ++result.welded;
  }
  if (result.welded == 0) return result;
  mesh.vertices = std::move(moved);
  result.removed = weld(mesh).removed;
  result.open_edges = topology(mesh).open_edges;
  return result;
}

}  // namespace hawser
