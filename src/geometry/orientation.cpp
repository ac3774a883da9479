// Orientation of a mesh: consistent patches, volumes of pieces, and nesting of pieces.
#include <cmath>

#include "hawser/geometry/point_in_polyhedron.hpp"
#include "hawser/geometry/triangle_mesh.hpp"
#include "nesting.hpp"

namespace hawser {
namespace {

// True if edge (a, b) of `other` runs from a to b as well.
bool same_direction(const std::array<int, 3>& other, int a, int b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (other[i] == a && other[(i + 1) % 3] == b) return true;
  return false;
}

}  // namespace

namespace detail {

bool grow_patch(const MeshView& mesh, const Topology& topo, int first, std::vector<signed char>& turn,
                std::vector<int>& patch) {
  bool two_sided = true;
  turn[static_cast<std::size_t>(first)] = 0;
  patch.assign(1, first);
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const auto t = static_cast<std::size_t>(patch[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      const int other = topo.neighbours[t][i];
      if (other < 0) continue;
      const auto u = static_cast<std::size_t>(other);
      const bool agree =
          !same_direction(mesh.triangles[u], mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
      const auto required = static_cast<signed char>(agree ? turn[t] : 1 - turn[t]);
      if (turn[u] < 0) {
        turn[u] = required;
        patch.push_back(other);
      } else if (turn[u] != required) {
        two_sided = false;
      }
    }
  }
  return two_sided;
}

std::vector<double> component_volumes(const MeshView& mesh, const Topology& topo) {
  std::vector<double> volume(static_cast<std::size_t>(topo.components), 0);
  // Relative to a vertex of the piece, so that distant pieces lose no digits.
  std::vector<int> origin(volume.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto c = static_cast<std::size_t>(topo.component[t]);
    if (origin[c] < 0) origin[c] = mesh.triangles[t][0];
    const Vec3& o = mesh.vertices[static_cast<std::size_t>(origin[c])];
    volume[c] += (mesh.corner(t, 0) - o).dot((mesh.corner(t, 1) - o).cross(mesh.corner(t, 2) - o)) / 6;
  }
  return volume;
}

std::vector<int> nesting_depth(const MeshView& mesh, const Topology& topo) {
  const auto n = static_cast<std::size_t>(topo.components);
  std::vector<int> depth(n, 0);
  if (n < 2) return depth;
  std::vector<std::vector<std::size_t>> members(n);
  std::vector<Box> box(n);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto c = static_cast<std::size_t>(topo.component[t]);
    members[c].push_back(t);
    for (std::size_t i = 0; i < 3; ++i) box[c].add(mesh.corner(t, i));
  }
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t t = members[c].front();
    const Vec3 p = mesh.centroid(t);
    for (std::size_t o = 0; o < n; ++o) {
      if (o == c || !box[o].contains(p)) continue;
      double angle = 0;
      for (const std::size_t u : members[o])
        angle += solid_angle(p, mesh.corner(u, 0), mesh.corner(u, 1), mesh.corner(u, 2));
      if (std::abs(angle) > 2 * M_PI) ++depth[c];
    }
  }
  return depth;
}

}  // namespace detail

}  // namespace hawser
