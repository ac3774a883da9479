// Splitting of long edges of a triangle mesh at their middles.
#include "hawser/geometry/mesh_split.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "edge_uses.hpp"

namespace hawser {
namespace {

// New vertices at the midpoints of edges that are too long, by triangle and edge; -1: none.
std::vector<std::array<int, 3>> middles(TriangleMesh& mesh, double longest, bool& any) {
  const std::vector<detail::EdgeUse> uses = detail::edge_uses(mesh);
  std::vector<std::array<int, 3>> out(mesh.triangles.size(), {-1, -1, -1});
  any = false;
  int middle = -1;
  for (std::size_t u = 0; u < uses.size(); ++u) {
    const detail::EdgeUse& use = uses[u];
    if (u == 0 || !use.same_edge(uses[u - 1])) {
      const Vec3 from = mesh.vertices[static_cast<std::size_t>(use.low)];
      const Vec3 to = mesh.vertices[static_cast<std::size_t>(use.high)];
      middle = -1;
      if ((to - from).norm() > longest) {
        middle = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(0.5 * (from + to));
        any = true;
      }
    }
    out[static_cast<std::size_t>(use.triangle)][static_cast<std::size_t>(use.i)] = middle;
  }
  return out;
}

// Splits the triangle t at the midpoints m of its edges (-1: none).
void split(const std::array<int, 3>& t, const std::array<int, 3>& m, std::vector<std::array<int, 3>>& out) {
  const auto count = std::count_if(m.begin(), m.end(), [](int v) { return v >= 0; });
  int first = 0;  // with one or two midpoints: the edge from corner `first` has one, the edge before it none
  while (count > 0 && count < 3 && !(m[first] >= 0 && m[(first + 2) % 3] < 0)) ++first;
  const int a = t[first];
  const int b = t[(first + 1) % 3];
  const int c = t[(first + 2) % 3];
  const int ab = m[first];
  const int bc = m[(first + 1) % 3];
  const int ca = m[(first + 2) % 3];
  if (count == 0) {
    out.push_back(t);
  } else if (count == 1) {
    out.push_back({a, ab, c});
    out.push_back({ab, b, c});
  } else if (count == 2) {
    out.push_back({ab, b, bc});
    out.push_back({a, ab, bc});
    out.push_back({a, bc, c});
  } else {
    out.push_back({a, ab, ca});
    out.push_back({ab, b, bc});
    out.push_back({bc, c, ca});
    out.push_back({ab, bc, ca});
  }
}

}  // namespace

void split_edges(TriangleMesh& mesh, double longest, std::size_t max_triangles) {
  mesh.part.clear();
  mesh.parts.clear();
  while (mesh.triangles.size() <= max_triangles / 4) {
    bool any = false;
    const std::vector<std::array<int, 3>> middle = middles(mesh, longest, any);
    if (!any) return;
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(2 * mesh.triangles.size());
    for (std::size_t t = 0; t < middle.size(); ++t) split(mesh.triangles[t], middle[t], triangles);
    mesh.triangles = std::move(triangles);
  }
}

}  // namespace hawser
