#include "pseudonormals.hpp"

#include <cmath>
#include <numeric>

namespace hawser::detail {
namespace {

// Vertices whose triangles do not form one fan: the surface touches itself there.
std::vector<bool> pinched(const TriangleMesh& mesh, const Topology& topo) {
  // Corners (3 t + i) joined across the edges beside them.
  std::vector<int> parent(3 * mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) {
      auto& p = parent[static_cast<std::size_t>(i)];
      p = parent[static_cast<std::size_t>(p)];
      i = p;
    }
    return i;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const int other = topo.neighbours[t][i];
      if (other < 0) continue;
      const auto u = static_cast<std::size_t>(other);
      for (const std::size_t mine : {i, (i + 1) % 3})
        for (std::size_t k = 0; k < 3; ++k)
          if (mesh.triangles[u][k] == mesh.triangles[t][mine])
            parent[static_cast<std::size_t>(root(static_cast<int>(3 * t + mine)))] =
                root(static_cast<int>(3 * u + k));
    }
  std::vector<int> fan(mesh.vertices.size(), -1);
  std::vector<bool> out(mesh.vertices.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(mesh.triangles[t][i]);
      const int r = root(static_cast<int>(3 * t + i));
      if (fan[v] < 0) fan[v] = r;
      if (fan[v] != r) out[v] = true;
    }
  return out;
}

}  // namespace

Pseudonormals::Pseudonormals(const TriangleMesh& mesh, const Topology& topo)
    : vertex_(mesh.vertices.size(), Vec3::Zero()), triangles_(mesh.triangles), neighbours_(topo.neighbours) {
  std::vector<bool> undefined = pinched(mesh, topo);
  face_.reserve(triangles_.size());
  for (const auto& tri : triangles_) {
    Vec3 v[3];
    for (std::size_t i = 0; i < 3; ++i) v[i] = mesh.vertices[static_cast<std::size_t>(tri[i])];
    const Vec3 n = triangle_normal(v[0], v[1], v[2]);
    face_.push_back(n);
    for (int i = 0; i < 3; ++i) {
      const auto w = static_cast<std::size_t>(tri[static_cast<std::size_t>(i)]);
      if (n.isZero(0)) {
        undefined[w] = true;
        continue;
      }
      const Vec3 e = v[(i + 1) % 3] - v[i], f = v[(i + 2) % 3] - v[i];
      vertex_[w] += std::atan2(e.cross(f).norm(), e.dot(f)) * n;
    }
  }
  for (std::size_t v = 0; v < vertex_.size(); ++v)
    if (undefined[v] || vertex_[v].norm() < 1e-6) vertex_[v].setZero();
}

Vec3 Pseudonormals::at(int t, Feature feature) const {
  const auto i = static_cast<std::size_t>(feature_index(feature));
  if (feature == Feature::face) return face(t);
  if (is_vertex(feature))
    return vertex_[static_cast<std::size_t>(triangles_[static_cast<std::size_t>(t)][i])];
  const int other = neighbours_[static_cast<std::size_t>(t)][i];
  if (other < 0 || face(t).isZero(0) || face(other).isZero(0)) return Vec3::Zero();
  const Vec3 n = face(t) + face(other);
  return n.norm() < 1e-6 ? Vec3(Vec3::Zero()) : n;
}

std::size_t Pseudonormals::memory() const {
  return (face_.capacity() + vertex_.capacity()) * sizeof(Vec3) +
         (triangles_.capacity() + neighbours_.capacity()) * sizeof(triangles_[0]);
}

}  // namespace hawser::detail
