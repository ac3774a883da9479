// Edges of a mesh at which two triangles meet at an angle, or the number of triangles is not two.
#include "hawser/geometry/sharp_edges.hpp"

#include "edge_uses.hpp"

namespace hawser {
namespace {

constexpr double kFlat = 0.9848;  // cos 10 deg

}  // namespace

std::vector<std::pair<int, int>> sharp_edges(const MeshView& m, const std::vector<bool>& active) {
  std::vector<detail::EdgeUse> uses = detail::edge_uses(m);
  if (!active.empty())
    std::erase_if(uses, [&](const detail::EdgeUse& u) { return !active[static_cast<size_t>(u.triangle)]; });
  const auto normal = [&](size_t k) { return m.area_vector(uses[k].triangle).stableNormalized(); };
  std::vector<std::pair<int, int>> out;
  for (size_t i = 0, j = 0; i < uses.size(); i = j) {
    while (j < uses.size() && uses[j].same_edge(uses[i])) ++j;
    if (j - i != 2 || normal(i).dot(normal(i + 1)) <= kFlat) out.emplace_back(uses[i].low, uses[i].high);
  }
  return out;
}

}  // namespace hawser
