#include "hawser/geometry/sharp_edges.hpp"

#include <algorithm>
#include <map>

namespace hawser {
namespace {

constexpr double kFlat = 0.9848;  // cos 10 deg

Vec3 normal(const MeshView& m, size_t t) {
  const auto& i = m.triangles[t];
  const auto v = [&](size_t k) { return m.vertices[static_cast<size_t>(i[k])]; };
  return (v(1) - v(0)).cross(v(2) - v(0)).stableNormalized();
}

}  // namespace

std::vector<std::pair<int, int>> sharp_edges(const MeshView& m, const std::vector<bool>& active) {
  std::map<std::pair<int, int>, std::vector<size_t>> sides;
  for (size_t t = 0; t < m.triangles.size(); ++t) {
    if (!active.empty() && !active[t]) continue;
    for (size_t k = 0; k < 3; ++k) {
      const int a = m.triangles[t][k], b = m.triangles[t][(k + 1) % 3];
      sides[{std::min(a, b), std::max(a, b)}].push_back(t);
    }
  }
  std::vector<std::pair<int, int>> out;
  for (const auto& [ends, of] : sides)
    if (of.size() != 2 || normal(m, of[0]).dot(normal(m, of[1])) <= kFlat) out.push_back(ends);
  return out;
}

}  // namespace hawser
