#include "facets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "spatial_hash_keys.hpp"

namespace hawser::detail {

Facets::Facets(const TriangleMesh& mesh, const std::vector<std::array<Eigen::Vector3f, 3>>& bends)
    : vertices_(large_copy(mesh.vertices)),
      triangles_(large_copy(mesh.triangles)),
      bends_(large_copy(bends)) {}

PatchPoint Facets::closest(int t, const Vec3& y) const {
  if (!bends_.empty()) {
    const SmoothPatch q = patch(t);
    if (!q.flat()) return closest_point_on_patch(y, q);
  }
  PatchPoint best;
  static_cast<ClosestPoint&>(best) = closest_point_on_triangle(y, corner(t, 0), corner(t, 1), corner(t, 2));
  return best;
}

FacetSearch::FacetSearch(const Facets& facets, const std::vector<bool>& chosen) : chosen_(chosen) {
  const MeshView mesh = facets.mesh();
  if (!facets.any_curved()) {
    hash_ = SpatialHash(mesh.vertices, mesh.triangles, chosen);
    return;
  }
  std::vector<PatchTree::Item> items;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    if (chosen.empty() || chosen[static_cast<std::size_t>(t)]) items.push_back({t, facets.patch(t)});
  tree_ = PatchTree(items);
}

std::optional<FacetSearch::Foot> FacetSearch::nearest(const Facets& facets, const Vec3& y,
                                                      double max_distance, int hint) const {
  std::optional<Foot> best;
  if (tree_.empty()) {
    if (const auto found = hash_.nearest(y, max_distance, hint))
      best = Foot{facets.closest(found->triangle, y), found->triangle};
    return best;
  }
  if (!y.allFinite() || !(max_distance >= 0)) return best;
  double limit = max_distance * max_distance;
  const auto visit = [&](int t, double& squared) {
    if (best && t == best->triangle) return;
    const PatchPoint p = facets.closest(t, y);
    if (!(p.squared_distance <= squared)) return;
    if (p.squared_distance == squared && best && t > best->triangle) return;
    best = Foot{p, t};
    squared = p.squared_distance;
  };
  if (facets.has(hint) && (chosen_.empty() || chosen_[static_cast<std::size_t>(hint)])) visit(hint, limit);
  tree_.nearest(y, limit, visit);
  return best;
}

// Of many questions: by cells of the box along a curve, so that what one reads is there for the next.
std::vector<std::uint32_t> FacetSearch::order_of(std::span<const SpatialHash::Question> questions) const {
  constexpr std::size_t kMany = 1024;
  constexpr int kBits = 5;
  std::vector<std::uint32_t> order;
  if (questions.size() < kMany) return order;
  const double cell = tree_.box().extent().maxCoeff() / (1 << kBits), last = (1 << kBits) - 1;
  if (!(cell > 0)) return order;
  const auto key = [&](const SpatialHash::Question& q) {
    std::uint64_t c[3];
    for (int a = 0; a < 3; ++a) {
      const double x = (q.point[a] - tree_.box().lo[a]) / cell;
      c[a] = static_cast<std::uint64_t>(x > 0 ? std::min(x, last) : 0.0);
    }
    return morton(c[0], c[1], c[2]);
  };
  std::vector<std::uint32_t> first((1u << 3 * kBits) + 1, 0u);
  for (const auto& q : questions) ++first[key(q) + 1];
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  order.resize(questions.size());
  for (std::size_t i = 0; i < questions.size(); ++i)
    order[first[key(questions[i])]++] = static_cast<std::uint32_t>(i);
  return order;
}

void FacetSearch::nearest(const Facets& facets, std::span<const SpatialHash::Question> questions,
                          std::span<std::optional<Foot>> feet) const {
  const std::size_t n = questions.size();
  constexpr std::size_t kAhead = 8;
  const auto fetch = [&](auto&& triangle, std::size_t i) {
    if (i + 2 * kAhead < n)
      if (const int t = triangle(i + 2 * kAhead); facets.has(t)) facets.fetch(t);
    if (i + kAhead < n)
      if (const int t = triangle(i + kAhead); facets.has(t)) facets.fetch_corners(t);
  };
  if (!tree_.empty()) {
    const std::vector<std::uint32_t> order = order_of(questions);
    const auto at = [&](std::size_t i) { return order.empty() ? i : order[i]; };
    for (std::size_t i = 0; i < n; ++i) {
      fetch([&](std::size_t k) { return questions[at(k)].hint; }, i);
      const SpatialHash::Question& q = questions[at(i)];
      feet[at(i)] = nearest(facets, q.point, q.max_distance, q.hint);
    }
    return;
  }
  std::vector<std::optional<SpatialHash::Nearest>> found(n);
  hash_.nearest(questions, found);
  for (std::size_t i = 0; i < n; ++i) {
    fetch([&](std::size_t k) { return found[k] ? found[k]->triangle : -1; }, i);
    feet[i].reset();
    if (found[i]) feet[i] = Foot{facets.closest(found[i]->triangle, questions[i].point), found[i]->triangle};
  }
}

}  // namespace hawser::detail
