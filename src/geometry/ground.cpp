// Closes an open sheet of triangles by walls and a floor, so that the space below it counts as inside.
#include "hawser/geometry/ground.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hawser {
namespace {

std::string place(const TriangleMesh& m, const std::array<int, 3>& t) {
  Vec3 c = Vec3::Zero();
  for (const int v : t) c += m.vertices[static_cast<size_t>(v)] / 3;
  return " near x " + std::to_string(c.x()) + ", y " + std::to_string(c.y());
}

}  // namespace

TriangleMesh ground_under(TriangleMesh sheet) {
  TriangleMesh& m = sheet;
  Box box;
  for (auto& t : m.triangles) {
    const Vec3& a = m.vertices[static_cast<size_t>(t[0])];
    const Vec3& b = m.vertices[static_cast<size_t>(t[1])];
    const Vec3& c = m.vertices[static_cast<size_t>(t[2])];
    for (const Vec3& v : {a, b, c}) box.add(v);
    const Vec3 n = (b - a).cross(c - a);
    if (!(std::abs(n.z()) > 1e-6 * n.norm()))
      throw std::invalid_argument("a triangle stands upright or has no area" + place(m, t) +
                                  ": a bed has one height at each place");
    if (n.z() < 0) std::swap(t[1], t[2]);
  }
  const Topology topo = topology(m);
  if (topo.non_manifold_edges > 0)
    throw std::invalid_argument("it has edges of more than two triangles: a bed is a single sheet");
  const size_t top = m.triangles.size();
  const size_t vertices = m.vertices.size();
  for (size_t i = 0; i < top; ++i)
    for (size_t e = 0; e < 3; ++e) {
      const int other = topo.neighbours[i][e];
      if (other < 0) continue;
      // Both face up: neighbours use their common edge in opposite directions unless the sheet is folded
      // there.
      const int from = m.triangles[i][e];
      const int to = m.triangles[i][(e + 1) % 3];
      const auto& t = m.triangles[static_cast<size_t>(other)];
      for (size_t k = 0; k < 3; ++k)
        if (t[k] == from && t[(k + 1) % 3] == to)
          throw std::invalid_argument("it is folded over itself" + place(m, t) +
                                      ": a bed has one height at each place");
    }
  const Vec3 extent = box.extent();
  const double floor = box.lo.z() - std::max(extent.x(), extent.y());
  const int below = static_cast<int>(vertices);
  for (size_t v = 0; v < vertices; ++v) {
    const Vec3 x = m.vertices[v];
    m.vertices.push_back({x.x(), x.y(), floor});
  }
  const bool parts = !m.part.empty();
  const auto add = [&](int a, int b, int c) {
    m.triangles.push_back({a, b, c});
    if (parts) m.part.push_back(m.part[0]);
  };
  for (size_t i = 0; i < top; ++i) {
    const std::array<int, 3> t = m.triangles[i];
    add(below + t[0], below + t[2], below + t[1]);
    for (size_t e = 0; e < 3; ++e) {
      if (topo.neighbours[i][e] != kOpenEdge) continue;
      const int from = t[e];
      const int to = t[(e + 1) % 3];
      add(to, from, below + from);
      add(to, below + from, below + to);
    }
  }
  return sheet;
}

}  // namespace hawser
