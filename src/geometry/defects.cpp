// The search for holes of a mesh, overlapping pieces and facets within it: where its nearest facet alone does
// not tell inside from outside.
#include "defects.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "edge_uses.hpp"
#include "hawser/geometry/closest_point.hpp"

namespace hawser::detail {
namespace {

struct Edge {
  int from, to;
  bool used = false;
};

// Edges that do not run equally often each way, as often and the way they are in excess.
std::vector<Edge> boundary(const MeshView& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  std::vector<Edge> out;
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    int sum = 0;
    for (j = i; j < uses.size() && uses[j].same_edge(uses[i]); ++j) sum += uses[j].forward ? 1 : -1;
    for (int k = 0; k < std::abs(sum); ++k)
      out.push_back(sum > 0 ? Edge{uses[i].low, uses[i].high} : Edge{uses[i].high, uses[i].low});
  }
  return out;
}

// As many edges leave each vertex as come to it. A walk that turns back as sharply as it can goes there and
// back along cracks; where it comes to a vertex it has been to, a closed way is done.
std::vector<std::vector<int>> closed_ways(const MeshView& mesh, std::vector<Edge>& edges) {
  const auto x = [&](int v) -> const Vec3& { return mesh.vertices[static_cast<std::size_t>(v)]; };
  std::vector<std::vector<std::size_t>> leaving(mesh.vertices.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    leaving[static_cast<std::size_t>(edges[e].from)].push_back(e);
  std::vector<int> place(mesh.vertices.size(), -1);  // on the walk
  std::vector<std::vector<int>> ways;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (edges[first].used) continue;
    std::vector<int> walk = {edges[first].from};
    place[static_cast<std::size_t>(walk[0])] = 0;
    while (true) {
      const int here = walk.back();
      const Vec3 come =
          walk.size() > 1 ? Vec3((x(here) - x(walk[walk.size() - 2])).normalized()) : Vec3(Vec3::Zero());
      std::size_t best = edges.size();
      double sharpest = 2;
      for (const std::size_t e : leaving[static_cast<std::size_t>(here)]) {
        if (edges[e].used) continue;
        const double turn = come.dot((x(edges[e].to) - x(here)).normalized());
        if (turn < sharpest) sharpest = turn, best = e;
      }
      if (best == edges.size()) break;
      edges[best].used = true;
      const int next = edges[best].to, seen = place[static_cast<std::size_t>(next)];
      if (seen < 0) {
        place[static_cast<std::size_t>(next)] = static_cast<int>(walk.size());
        walk.push_back(next);
        continue;
      }
      ways.emplace_back(walk.begin() + seen, walk.end());
      for (std::size_t i = static_cast<std::size_t>(seen) + 1; i < walk.size(); ++i)
        place[static_cast<std::size_t>(walk[i])] = -1;
      walk.resize(static_cast<std::size_t>(seen) + 1);
    }
    for (const int v : walk) place[static_cast<std::size_t>(v)] = -1;
  }
  return ways;
}

Defects::Hole around(const MeshView& mesh, const std::vector<int>& way) {
  const auto x = [&](int v) -> const Vec3& { return mesh.vertices[static_cast<std::size_t>(v)]; };
  // Along the two corners farthest from each other, about.
  const auto farthest = [&](const Vec3& from) {
    return *std::max_element(way.begin(), way.end(), [&](int a, int b) {
      return (x(a) - from).squaredNorm() < (x(b) - from).squaredNorm();
    });
  };
  Defects::Hole h;
  h.from = x(farthest(x(way[0])));
  h.to = x(farthest(h.from));
  for (const int v : way)
    h.radius = std::max(h.radius, std::sqrt(closest_point_on_segment(x(v), h.from, h.to).squared_distance));
  return h;
}

}  // namespace

double Defects::Hole::distance(const Vec3& y) const {
  return std::max(0.0, std::sqrt(closest_point_on_segment(y, from, to).squared_distance) - radius);
}

Defects find_defects(const MeshView& mesh, const Topology& topo, const WindingTree& tree) {
  Defects out;
  std::vector<Edge> edges = boundary(mesh);
  out.boundary_edges = static_cast<int>(edges.size());
  const std::size_t n = mesh.triangles.size();
  out.unsure.assign(n, false);
  out.straight.assign(n, false);
  out.internal.assign(n, false);
  for (const auto& way : closed_ways(mesh, edges)) out.holes.push_back(around(mesh, way));
  if (out.holes.size() > 3000) {  // a soup: everywhere
    Box box;
    for (const Vec3& v : mesh.vertices) box.add(v);
    out.holes = {{box.centre(), box.centre(), 0.5 * box.diagonal()}};
  }
  // Pieces may overlap: a facet is sure only where the boxes of the others are not.
  std::vector<Box> piece(static_cast<std::size_t>(topo.components));
  for (std::size_t t = 0; t < n; ++t)
    for (std::size_t i = 0; i < 3; ++i)
      piece[static_cast<std::size_t>(topo.component[t])].add(mesh.corner(t, i));
  const bool few = piece.size() <= 1000;
  for (std::size_t t = 0; t < n; ++t) {
    Box own;
    for (std::size_t i = 0; i < 3; ++i) own.add(mesh.corner(t, i));
    for (std::size_t p = 0; p < piece.size() && few && !out.unsure[t]; ++p)
      out.unsure[t] = p != static_cast<std::size_t>(topo.component[t]) && piece[p].overlaps(own);
    if (!few) out.unsure[t] = true;
    const Vec3 c = mesh.centroid(t);
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) reach = std::max(reach, (mesh.corner(t, i) - c).norm());
    for (const Defects::Hole& h : out.holes)
      if (h.distance(c) <= 2 * std::min(2 * h.radius, 0.5 * (h.to - h.from).norm()) + reach) {
        out.unsure[t] = true;
        break;
      }
    // On the facet itself, its own angle left out, the number is half way between those of the two sides.
    const double middle = tree.winding_number(mesh, c, 3, static_cast<int>(t));
    if (std::abs(middle - 0.5) > 0.4) out.unsure[t] = out.straight[t] = true;
    // Internal only as a whole: at the corners and the middles of the edges too.
    bool internal = middle > 1.05;
    for (std::size_t i = 0; i < 6 && internal; ++i) {
      const Vec3 at =
          i < 3 ? mesh.corner(t, i) : Vec3(0.5 * (mesh.corner(t, i - 3) + mesh.corner(t, (i - 2) % 3)));
      internal = tree.winding_number(mesh, c + 0.98 * (at - c), 3, static_cast<int>(t)) > 1.05;
    }
    if (internal) {
      out.internal[t] = true;
      ++out.internal_facets;
    }
  }
  if (std::find(out.internal.begin(), out.internal.end(), false) == out.internal.end()) {
    out.internal.assign(n, false);
    out.internal_facets = 0;
  }
  if (std::find(out.unsure.begin(), out.unsure.end(), true) == out.unsure.end()) out.unsure.clear();
  return out;
}

}  // namespace hawser::detail
