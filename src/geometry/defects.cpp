// Detection of holes of a mesh, overlapping pieces and internal facets, near which the nearest facet does not
// determine the inside.
#include "defects.hpp"

#include <algorithm>
#include <cmath>

#include "edge_uses.hpp"
#include "hawser/geometry/closest_point.hpp"
#include "hawser/math/disjoint_sets.hpp"

namespace hawser::detail {
namespace {

// Edges that are not used equally often in both directions, as sets of connected corners.
std::vector<std::vector<int>> boundaries(const MeshView& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  DisjointSets group(mesh.vertices.size());
  std::vector<bool> on_boundary(mesh.vertices.size(), false);
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    int sum = 0;
    for (j = i; j < uses.size() && uses[j].same_edge(uses[i]); ++j) sum += uses[j].forward ? 1 : -1;
    if (sum == 0) continue;
    group.unite(uses[i].low, uses[i].high);
    on_boundary[static_cast<std::size_t>(uses[i].low)] = on_boundary[static_cast<std::size_t>(uses[i].high)] =
        true;
  }
  int count = 0;
  const std::vector<int> number =
      group.numbered([&](int v) { return on_boundary[static_cast<std::size_t>(v)]; }, count);
  std::vector<std::vector<int>> out(static_cast<std::size_t>(count));
  for (std::size_t v = 0; v < on_boundary.size(); ++v)
    if (number[v] >= 0) out[static_cast<std::size_t>(number[v])].push_back(static_cast<int>(v));
  return out;
}

Defects::Hole around(const MeshView& mesh, const std::vector<int>& corners) {
  const auto x = [&](int v) -> const Vec3& { return mesh.vertices[static_cast<std::size_t>(v)]; };
  // Axis through approximately the two most distant corners.
  const auto farthest = [&](const Vec3& from) {
    return *std::max_element(corners.begin(), corners.end(), [&](int a, int b) {
      return (x(a) - from).squaredNorm() < (x(b) - from).squaredNorm();
    });
  };
  Defects::Hole h;
  h.from = x(farthest(x(corners[0])));
  h.to = x(farthest(h.from));
  for (const int v : corners)
    h.radius = std::max(h.radius, std::sqrt(closest_point_on_segment(x(v), h.from, h.to).squared_distance));
  return h;
}

}  // namespace

double Defects::Hole::distance(const Vec3& y) const {
  return std::max(0.0, std::sqrt(closest_point_on_segment(y, from, to).squared_distance) - radius);
}

Defects find_defects(const MeshView& mesh, const Topology& topo, const WindingTree& tree) {
  Defects out;
  const std::size_t n = mesh.triangles.size();
  out.undecided.assign(n, false);
  out.straight.assign(n, false);
  out.internal.assign(n, false);
  for (const auto& corners : boundaries(mesh)) out.holes.push_back(around(mesh, corners));
  if (out.holes.size() > 3000) {  // no consistent surface: everywhere
    Box box;
    for (const Vec3& v : mesh.vertices) box.add(v);
    out.holes = {{box.centre(), box.centre(), 0.5 * box.diagonal()}};
  }
  // Pieces may overlap: a facet is certain only outside the boxes of the other pieces.
  std::vector<Box> piece(static_cast<std::size_t>(topo.components));
  for (std::size_t t = 0; t < n; ++t)
    for (std::size_t i = 0; i < 3; ++i)
      piece[static_cast<std::size_t>(topo.component[t])].add(mesh.corner(t, i));
  const bool few = piece.size() <= 1000;
  for (std::size_t t = 0; t < n; ++t) {
    Box facet_box;
    for (std::size_t i = 0; i < 3; ++i) facet_box.add(mesh.corner(t, i));
    for (std::size_t p = 0; p < piece.size() && few && !out.undecided[t]; ++p)
      out.undecided[t] = p != static_cast<std::size_t>(topo.component[t]) && piece[p].overlaps(facet_box);
    if (!few) out.undecided[t] = true;
    const Vec3 c = mesh.centroid(t);
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) reach = std::max(reach, (mesh.corner(t, i) - c).norm());
    for (const Defects::Hole& h : out.holes)
      if (h.distance(c) <= 2 * std::min(2 * h.radius, 0.5 * (h.to - h.from).norm()) + reach) {
        out.undecided[t] = true;
        break;
      }
    // On the facet itself, without its own solid angle, the winding number is the mean of those on its two
    // sides.
    const double middle = tree.winding_number(mesh, c, 3, static_cast<int>(t));
    if (std::abs(middle - 0.5) > 0.4) out.undecided[t] = out.straight[t] = true;
    // A facet is internal only if all of it is: also at the corners and edge midpoints.
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
  if (std::find(out.undecided.begin(), out.undecided.end(), true) == out.undecided.end())
    out.undecided.clear();
  return out;
}

}  // namespace hawser::detail
