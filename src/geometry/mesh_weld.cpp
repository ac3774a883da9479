// The merging of corners along open edges whose distance is small beside the edges there.
#include "hawser/geometry/mesh_weld.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "groups.hpp"

namespace hawser {
namespace {

constexpr double kCrack = 1.0 / 100;  // of the shortest edge

using Cell = std::array<std::int64_t, 3>;

// Corners by the size of their tolerance: on level l those with one in (2^(l-1), 2^l], in cubes of 2^(l+1).
// As their edges are 100 times as long, a cube holds few, whatever the grading of the mesh.
class Levels {
 public:
  void add(int vertex, const Vec3& x, double tolerance) {
    const int level = level_of(tolerance);
    levels_[level][cell(x, level, 0)].push_back(vertex);
  }
  // what(vertex) for all within `tolerance` of x whose own is no less, and some more.
  template <class What>
  void near(const Vec3& x, double tolerance, const What& what) const {
    for (auto level = levels_.lower_bound(level_of(tolerance)); level != levels_.end(); ++level) {
      // Cubes of twice the tolerance or more: what is within it lies in the 8 around the nearest corner.
      std::array<Cell, 8> cells;
      for (int corner = 0; corner < 8; ++corner)
        cells[static_cast<std::size_t>(corner)] = cell(x, level->first, corner, true);
      for (const Cell& c : cells)
        if (const auto found = level->second.find(c); found != level->second.end())
          for (const int v : found->second) what(v);
    }
  }

 private:
  static int level_of(double tolerance) { return static_cast<int>(std::ceil(std::log2(tolerance))); }
  static Cell cell(const Vec3& x, int level, int corner, bool around = false) {
    Cell c;
    for (int a = 0; a < 3; ++a) {
      const double shift = around ? (corner >> a & 1 ? 0.5 : -0.5) : 0;
      c[static_cast<std::size_t>(a)] =
          static_cast<std::int64_t>(std::floor(std::ldexp(x[a], -level - 1) + shift));
    }
    return c;
  }
  std::map<int, std::map<Cell, std::vector<int>>> levels_;
};

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
      const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      ++uses[static_cast<std::size_t>(a)];
      const double most = kCrack * (x(a) - x(b)).norm();
      for (const int v : {a, b}) {
        auto& own = tolerance[static_cast<std::size_t>(v)];
        own = std::min(own, most);
        if (topo.neighbours[t][i] == kOpenEdge) open[static_cast<std::size_t>(v)] = 1;
      }
    }
  Levels levels;
  std::vector<int> group;
  detail::separate(group, n);
  for (std::size_t v = 0; v < n; ++v)
    if (open[v] && tolerance[v] > 0) levels.add(static_cast<int>(v), mesh.vertices[v], tolerance[v]);
  for (std::size_t v = 0; v < n; ++v) {
    if (!open[v] || !(tolerance[v] > 0)) continue;
    levels.near(mesh.vertices[v], tolerance[v], [&](int w) {
      const double most = std::min(tolerance[v], tolerance[static_cast<std::size_t>(w)]);
      if ((x(w) - mesh.vertices[v]).norm() <= most) detail::unite(group, static_cast<int>(v), w);
    });
  }
  // Of each group the corner of the most triangles, the lowest of those.
  std::vector<int> keeps(n, -1);
  for (std::size_t v = 0; v < n; ++v) {
    int& best = keeps[static_cast<std::size_t>(detail::root_of(group, static_cast<int>(v)))];
    if (best < 0 || uses[v] > uses[static_cast<std::size_t>(best)]) best = static_cast<int>(v);
  }
  std::vector<Vec3> moved = mesh.vertices;
  for (std::size_t v = 0; v < n; ++v) {
    const int to = keeps[static_cast<std::size_t>(detail::root_of(group, static_cast<int>(v)))];
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
