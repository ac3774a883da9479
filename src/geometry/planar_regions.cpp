// Planar regions of a mesh, grown from triangle to triangle, and their smallest width.
#include "planar_regions.hpp"

#include <cmath>
#include <limits>

#include "hawser/math/symmetric.hpp"

namespace hawser::detail {
namespace {

// Largest angle between the normals of a region and that of its first triangle.
constexpr double kFlat = 2e-3;  // rad

double least_extent(const TriangleMesh& mesh, const std::vector<int>& region, const Vec3& normal) {
  Vec3 mean = Vec3::Zero();
  for (const int t : region)
    for (const int v : mesh.triangles[static_cast<std::size_t>(t)])
      mean += mesh.vertices[static_cast<std::size_t>(v)];
  mean /= 3.0 * static_cast<double>(region.size());
  const Vec3 a = normal.unitOrthogonal();
  const Vec3 b = normal.cross(a);
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  const auto each = [&](auto&& f) {
    for (const int t : region)
      for (const int v : mesh.triangles[static_cast<std::size_t>(t)]) {
        const Vec3 r = mesh.vertices[static_cast<std::size_t>(v)] - mean;
        f(Eigen::Vector2d(r.dot(a), r.dot(b)));
      }
  };
  each([&](const Eigen::Vector2d& x) { spread += x * x.transpose(); });
  const Eigen::Matrix2d axes = eigenpairs(spread).vectors;
  Eigen::Vector2d lo = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d hi = -lo;
  each([&](const Eigen::Vector2d& x) {
    const Eigen::Vector2d y = axes.transpose() * x;
    lo = lo.cwiseMin(y);
    hi = hi.cwiseMax(y);
  });
  return (hi - lo).minCoeff();
}

}  // namespace

std::vector<double> planar_widths(const TriangleMesh& mesh, const Topology& topo,
                                  const std::vector<Vec3>& normals) {
  std::vector<double> width(mesh.triangles.size(), 0);
  std::vector<bool> visited(mesh.triangles.size(), false);
  std::vector<int> region;
  const double cosine = std::cos(kFlat);
  for (std::size_t first = 0; first < visited.size(); ++first) {
    const Vec3& n = normals[first];
    if (visited[first] || n.isZero(0)) continue;
    visited[first] = true;
    region.assign(1, static_cast<int>(first));
    for (std::size_t i = 0; i < region.size(); ++i)
      for (const int u : topo.neighbours[static_cast<std::size_t>(region[i])]) {
        if (u < 0 || visited[static_cast<std::size_t>(u)]) continue;
        if (!(normals[static_cast<std::size_t>(u)].dot(n) > cosine)) continue;
        visited[static_cast<std::size_t>(u)] = true;
        region.push_back(u);
      }
    const double w = least_extent(mesh, region, n);
    for (const int t : region) width[static_cast<std::size_t>(t)] = w;
  }
  return width;
}

}  // namespace hawser::detail
