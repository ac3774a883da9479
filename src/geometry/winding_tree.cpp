#include "hawser/geometry/winding_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/point_in_polyhedron.hpp"

namespace hawser {
namespace {

constexpr int kLeaf = 8, kDeepest = 64;

const Vec3& corner(const MeshView& mesh, int t, std::size_t i) {
  return mesh.vertices[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i])];
}

}  // namespace

WindingTree::WindingTree(const MeshView& mesh) : order_(mesh.triangles.size()) {
  if (order_.empty()) return;
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vec3> centroids;
  for (int t = 0; t < static_cast<int>(order_.size()); ++t)
    centroids.push_back((corner(mesh, t, 0) + corner(mesh, t, 1) + corner(mesh, t, 2)) / 3);
  build(mesh, centroids, 0, static_cast<int>(order_.size()));
}

int WindingTree::build(const MeshView& mesh, const std::vector<Vec3>& centroids, int first, int count) {
  const std::size_t me = nodes_.size();
  nodes_.emplace_back();
  Node n;
  n.first = first, n.count = count;
  Box box;
  double weight = 0;
  const auto each = [&](auto&& f) {
    for (int i = first; i < first + count; ++i) {
      const int t = order_[static_cast<std::size_t>(i)];
      const Vec3& a = corner(mesh, t, 0);
      f(t, Vec3(0.5 * (corner(mesh, t, 1) - a).cross(corner(mesh, t, 2) - a)),
        centroids[static_cast<std::size_t>(t)]);
    }
  };
  each([&](int, const Vec3& area, const Vec3& c) {
    n.area += area;
    n.centre += area.norm() * c;
    weight += area.norm();
    box.add(c);
  });
  n.centre = weight > 0 ? Vec3(n.centre / weight) : box.centre();
  each([&](int t, const Vec3& area, const Vec3& c) {
    n.moment += area * (c - n.centre).transpose();
    for (std::size_t i = 0; i < 3; ++i) n.radius = std::max(n.radius, (corner(mesh, t, i) - n.centre).norm());
  });
  if (count > kLeaf) {
    int axis = 0;
    box.extent().maxCoeff(&axis);
    const int half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](int a, int b) {
      const double x = centroids[static_cast<std::size_t>(a)][axis],
                   y = centroids[static_cast<std::size_t>(b)][axis];
      return x != y ? x < y : a < b;
    });
    n.child[0] = build(mesh, centroids, first, half);
    n.child[1] = build(mesh, centroids, first + half, count - half);
  }
  nodes_[me] = n;
  return static_cast<int>(me);
}

double WindingTree::winding_number(const MeshView& mesh, const Vec3& p, double accuracy, int without) const {
  if (nodes_.empty()) return 0;
  double angle = 0;
  int stack[kDeepest], depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& n = nodes_[static_cast<std::size_t>(stack[--depth])];
    const Vec3 r = n.centre - p;
    const double r2 = r.squaredNorm(), away = accuracy * n.radius;
    if (r2 > away * away) {
      // Integral of n . x / |x|³: the field at the centre, and its gradient times the first moment.
      const double r1 = std::sqrt(r2), r3 = r2 * r1;
      angle += r.dot(n.area) / r3 + n.moment.trace() / r3 - 3 * r.dot(n.moment * r) / (r3 * r2);
      continue;
    }
    if (n.child[0] >= 0) {
      stack[depth++] = n.child[1];
      stack[depth++] = n.child[0];
      continue;
    }
    for (int i = n.first; i < n.first + n.count; ++i) {
      const int t = order_[static_cast<std::size_t>(i)];
      if (t != without) angle += solid_angle(p, corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2));
    }
  }
  return angle / (4 * M_PI);
}

bool WindingTree::inside(const MeshView& mesh, const Vec3& p) const {
  double w = 0;
  // Margins twice the errors found on hulls and more (tests/unit/geometry_winding.cpp).
  for (const auto& [accuracy, margin] :
       {std::pair{1.5, 0.3}, std::pair{3.0, 0.1}, std::pair{10.0, 3e-3}, std::pair{1e9, 0.0}}) {
    w = winding_number(mesh, p, accuracy);
    if (std::abs(w - 0.5) > margin) break;
  }
  return w > 0.5;
}

int WindingTree::crossings(const MeshView& mesh, const Vec3& p, const Vec3& u, int without) const {
  if (nodes_.empty()) return 0;
  int met = 0;
  int stack[kDeepest], depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& n = nodes_[static_cast<std::size_t>(stack[--depth])];
    const Vec3 r = n.centre - p;
    const double along = r.dot(u);
    if (along < -n.radius || (r - along * u).squaredNorm() > n.radius * n.radius) continue;
    if (n.child[0] >= 0) {
      stack[depth++] = n.child[0];
      stack[depth++] = n.child[1];
      continue;
    }
    for (int i = n.first; i < n.first + n.count; ++i) {
      const int t = order_[static_cast<std::size_t>(i)];
      if (t == without) continue;
      const Vec3 a = corner(mesh, t, 0) - p, b = corner(mesh, t, 1) - p, c = corner(mesh, t, 2) - p;
      const double x = u.dot(a.cross(b)), y = u.dot(b.cross(c)), z = u.dot(c.cross(a));
      if (!((x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0))) continue;
      // Ahead when the volume and the side of passing agree.
      met += (a.dot(b.cross(c)) > 0) == (x > 0);
    }
  }
  return met;
}

}  // namespace hawser
