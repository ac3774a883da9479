// Splitting of long edges of a triangle mesh at their middles.
#include "hawser/geometry/mesh_split.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace hawser {
namespace {

using Edge = std::pair<int, int>;
Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

// New vertices in the middle of the edges that are too long.
std::map<Edge, int> middles(TriangleMesh& mesh, double longest) {
  std::map<Edge, int> out;
  for (const std::array<int, 3>& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const Edge e = edge_of(t[i], t[(i + 1) % 3]);
      const Vec3 from = mesh.vertices[static_cast<std::size_t>(e.first)];
      const Vec3 to = mesh.vertices[static_cast<std::size_t>(e.second)];
      if ((to - from).norm() <= longest) continue;
      if (out.try_emplace(e, static_cast<int>(mesh.vertices.size())).second)
        mesh.vertices.push_back(0.5 * (from + to));
    }
  return out;
}

// The triangle t with middles m of its edges, of which -1 are none, from corner `first` on.
void split(const std::array<int, 3>& t, const std::array<int, 3>& m, std::vector<std::array<int, 3>>& out) {
  const auto count = std::count_if(m.begin(), m.end(), [](int v) { return v >= 0; });
  int first = 0;  // with one or two middles: the edge from corner `first` on has one, the edge before it none
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

void split_edges(TriangleMesh& mesh, double longest, std::size_t most) {
  mesh.part.clear();
  mesh.parts.clear();
  while (mesh.triangles.size() <= most / 4) {
    const std::map<Edge, int> middle = middles(mesh, longest);
    if (middle.empty()) return;
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(2 * mesh.triangles.size());
    for (const std::array<int, 3>& t : mesh.triangles) {
      std::array<int, 3> m{-1, -1, -1};
      for (int i = 0; i < 3; ++i)
        if (const auto at = middle.find(edge_of(t[i], t[(i + 1) % 3])); at != middle.end()) m[i] = at->second;
      split(t, m, triangles);
    }
    mesh.triangles = std::move(triangles);
  }
}

}  // namespace hawser
