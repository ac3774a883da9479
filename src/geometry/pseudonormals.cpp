// Angle-weighted normals at the corners and edges of a mesh, and the features where they do not determine the
// inside.
#include "pseudonormals.hpp"

#include <cmath>
#include <utility>

#include "hawser/math/disjoint_sets.hpp"

namespace hawser::detail {
namespace {

// Vertices whose triangles do not form a single fan, because the surface touches itself there.
std::vector<bool> pinched(const MeshView& mesh, const Topology& topo) {
  // Corners (3 t + i) joined across the edges beside them.
  DisjointSets group(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const int other = topo.neighbours[t][i];
      if (other < 0) continue;
      const auto u = static_cast<std::size_t>(other);
      for (const std::size_t corner : {i, (i + 1) % 3})
        for (std::size_t k = 0; k < 3; ++k)
          if (mesh.triangles[u][k] == mesh.triangles[t][corner])
            group.unite(static_cast<int>(3 * t + corner), static_cast<int>(3 * u + k));
    }
  std::vector<int> fan(mesh.vertices.size(), -1);
  std::vector<bool> out(mesh.vertices.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(mesh.triangles[t][i]);
      const int r = group.smallest(static_cast<int>(3 * t + i));
      if (fan[v] < 0) fan[v] = r;
      if (fan[v] != r) out[v] = true;
    }
  return out;
}

}  // namespace

Pseudonormals::Pseudonormals(const Facets& facets, const Topology& topo) : neighbours_(topo.neighbours) {
  const MeshView mesh = facets.mesh();
  std::vector<Vec3> vertex(mesh.vertices.size(), Vec3::Zero());
  std::vector<bool> undefined = pinched(mesh, topo);
  std::vector<Vec3> faces(mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Vec3& n = faces[static_cast<std::size_t>(t)] = face(facets, t);
    const SmoothPatch q = facets.patch(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto w = static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i]);
      if (n.isZero(0)) {
        undefined[w] = true;
        continue;
      }
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const Vec3 e = q.p[j] - q.p[i] + q.c[i];
      const Vec3 f = q.p[k] - q.p[i] + q.c[k];
      const Vec3 m = e.cross(f);
      vertex[w] += std::atan2(m.norm(), e.dot(f)) * (q.flat() ? n : Vec3(m.normalized()));
    }
  }
  for (std::size_t v = 0; v < vertex.size(); ++v)
    if (undefined[v] || vertex[v].norm() < 1e-6) {
      vertex[v].setZero();
      complete_ = false;
    }
  vertex_ = std::move(vertex);
  for (std::size_t t = 0; t < neighbours_.size() && complete_; ++t)
    for (const int u : neighbours_[t])
      complete_ = complete_ && u >= 0 && (faces[t] + faces[static_cast<std::size_t>(u)]).norm() > 1e-3;
}

Vec3 Pseudonormals::at(const Facets& facets, int t, const PatchPoint& p) const {
  const auto i = static_cast<std::size_t>(feature_index(p.feature));
  if (is_vertex(p.feature))
    return vertex_[static_cast<std::size_t>(facets.mesh().triangles[static_cast<std::size_t>(t)][i])];
  const bool curved = facets.curved(t);
  if (p.feature == Feature::face)
    return curved ? facets.patch(t).normal(p.u, p.v).normalized() : face(facets, t);
  const int other = neighbours_[static_cast<std::size_t>(t)][i];
  if (other < 0) return Vec3::Zero();
  Vec3 this_normal = face(facets, t);
  Vec3 across = face(facets, other);
  if (this_normal.isZero(0) || across.isZero(0)) return Vec3::Zero();
  if (curved) this_normal = facets.patch(t).normal(p.u, p.v).normalized();
  if (facets.curved(other)) {
    const int a = facets.mesh().triangles[static_cast<std::size_t>(t)][i];
    double s = i == 0 ? p.u : p.v;
    if (i == 2) s = 1 - s;
    if (!curved) {
      const Vec3& from = facets.corner(t, static_cast<int>(i));
      const Vec3& to = facets.corner(t, static_cast<int>(i + 1) % 3);
      s = (p.point - from).dot(to - from) / (to - from).squaredNorm();
    }
    int k = 0;
    while (k < 2 &&
           (facets.mesh().triangles[static_cast<std::size_t>(other)][static_cast<std::size_t>((k + 1) % 3)] !=
                a ||
            facets.mesh().triangles[static_cast<std::size_t>(other)][static_cast<std::size_t>(k)] !=
                facets.mesh().triangles[static_cast<std::size_t>(t)][(i + 1) % 3]))
      ++k;
    const auto uv = on_edge(k, 1 - s);
    across = facets.patch(other).normal(uv[0], uv[1]).normalized();
  }
  const Vec3 n = this_normal + across;
  return n.norm() < 1e-6 ? Vec3(Vec3::Zero()) : n;
}

}  // namespace hawser::detail
