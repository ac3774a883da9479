// Rays from the triangles of a patch that determine its outside, and winding numbers for what it encloses.
#include "patch_visibility.hpp"

#include <algorithm>
#include <cmath>

namespace hawser::detail {
namespace {

// Directions distributed over the sphere (Fibonacci), rotated so that none is along an axis.
Vec3 direction(int i, int n) {
  const double z = 1 - (2 * i + 1.0) / n;
  const double a = 2.399963229728653 * i + 0.3;
  const double r = std::sqrt(1 - z * z);
  return Vec3(r * std::cos(a), r * std::sin(a), z);
}

constexpr int kTriangles = 15;  // most triangles of a patch from which rays start
constexpr int kRays = 9;        // rays from each

// Rays in both directions from the largest triangles of the patch. Calls with_ray(crossings, front): the
// number of triangles the ray meets, and whether it starts at the front.
template <class F>
void each_ray(const MeshView& mesh, const WindingTree& tree, std::vector<int>& patch, F with_ray) {
  const auto larger = [&](int a, int b) {
    const double x = mesh.area_vector(a).squaredNorm();
    const double y = mesh.area_vector(b).squaredNorm();
    return x != y ? x > y : a < b;
  };
  const auto count = std::min<std::size_t>(kTriangles, patch.size());
  std::partial_sort(patch.begin(), patch.begin() + static_cast<long>(count), patch.end(), larger);
  for (std::size_t k = 0; k < count; ++k) {
    const int t = patch[k];
    const Vec3 n = mesh.area_vector(t);
    const Vec3 c = mesh.centroid(t);
    if (n.isZero(0)) continue;
    for (int i = 0; i < kRays; ++i) {
      const Vec3 u = direction(i, kRays);
      const double side = u.dot(n.normalized());
      if (std::abs(side) < 0.1) continue;
      with_ray(tree.crossings(mesh, c, u, t), side > 0);
    }
  }
}

}  // namespace

bool front_faces_inside(const MeshView& mesh, const WindingTree& tree, std::vector<int> patch) {
  int excess = 0;  // rays for the front at the inside, less those for the front at the outside
  each_ray(mesh, tree, patch, [&](int crossings, bool front) {
    const bool to_outside = crossings % 2 == 0;
    excess += to_outside == front ? -1 : 1;
  });
  return excess > 0;
}

double one_sided_visibility(const MeshView& mesh, const WindingTree& tree, std::vector<int> patch) {
  int rays[2] = {0, 0}, free[2] = {0, 0};
  each_ray(mesh, tree, patch, [&](int crossings, bool front) {
    ++rays[front];
    free[front] += crossings == 0;
  });
  if (rays[0] == 0 || rays[1] == 0) return 0;
  return std::abs(static_cast<double>(free[0]) / rays[0] - static_cast<double>(free[1]) / rays[1]);
}

double enclosing(const MeshView& mesh, const WindingTree& tree, std::span<const int> triangles,
                 double margin) {
  double area = 0, visible = 0;
  const std::size_t step = triangles.size() / 20000 + 1;
  for (std::size_t k = 0; k < triangles.size(); k += step) {
    const int t = triangles[k];
    const double a = mesh.area_vector(t).norm();
    const double middle = tree.winding_number(mesh, mesh.centroid(t), 3, t);
    area += a;
    if (middle > margin && middle < 1 - margin) visible += a;
  }
  return area > 0 ? visible / area : 0;
}

}  // namespace hawser::detail
