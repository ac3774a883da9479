// Winding numbers and ray crossings from a tree of clusters of triangles, distant ones as dipoles.
#include "hawser/geometry/winding_tree.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/point_in_polyhedron.hpp"

namespace hawser {
namespace {

constexpr int kLeaf = 8;

}  // namespace

WindingTree::WindingTree(const MeshView& mesh) {
  std::vector<Box> boxes(mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(boxes.size()); ++t)
    for (std::size_t i = 0; i < 3; ++i) boxes[static_cast<std::size_t>(t)].add(mesh.corner(t, i));
  tree_ = BoxTree(boxes, {}, kLeaf);
  std::vector<Cluster> clusters;
  for (const BoxTree::Node& n : tree_.nodes()) clusters.push_back(cluster(mesh, tree_.below(n)));
  clusters_ = std::move(clusters);
}

WindingTree::Cluster WindingTree::cluster(const MeshView& mesh, std::span<const int> triangles) {
  Cluster c;
  Box box;
  double weight = 0;
  const auto each = [&](auto&& f) {
    for (const int t : triangles) f(t, mesh.area_vector(t), mesh.centroid(t));
  };
  each([&](int, const Vec3& area, const Vec3& centroid) {
    c.area += area;
    c.centre += area.norm() * centroid;
    weight += area.norm();
    box.add(centroid);
  });
  c.centre = weight > 0 ? Vec3(c.centre / weight) : box.centre();
  each([&](int t, const Vec3& area, const Vec3& centroid) {
    c.moment += area * (centroid - c.centre).transpose();
    for (std::size_t i = 0; i < 3; ++i) c.radius = std::max(c.radius, (mesh.corner(t, i) - c.centre).norm());
  });
  return c;
}

double WindingTree::winding_number(const MeshView& mesh, const Vec3& p, double accuracy, int without) const {
  double angle = 0;
  tree_.walk(
      [&](std::size_t node) {
        const Cluster& c = clusters_[node];
        const Vec3 r = c.centre - p;
        const double r2 = r.squaredNorm();
        const double away = accuracy * c.radius;
        if (!(r2 > away * away)) return true;
        // Integral of n . x / |x|³: the field at the centre, and its gradient times the first moment.
        const double r1 = std::sqrt(r2);
        const double r3 = r2 * r1;
        angle += r.dot(c.area) / r3 + c.moment.trace() / r3 - 3 * r.dot(c.moment * r) / (r3 * r2);
        return false;
      },
      [&](int t) {
        if (t != without) angle += solid_angle(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
      });
  return angle / (4 * M_PI);
}

bool WindingTree::inside(const MeshView& mesh, const Vec3& p) const {
  double w = 0;
  // Margins of twice the errors measured on hulls and more (tests/unit/geometry_winding.cpp).
  for (const auto& [accuracy, margin] :
       {std::pair{1.5, 0.3}, std::pair{3.0, 0.1}, std::pair{10.0, 3e-3}, std::pair{1e9, 0.0}}) {
    w = winding_number(mesh, p, accuracy);
    if (std::abs(w - 0.5) > margin) break;
  }
  return w > 0.5;
}

int WindingTree::crossings(const MeshView& mesh, const Vec3& p, const Vec3& u, int without) const {
  int crossings = 0;
  tree_.walk(
      [&](std::size_t node) {
        const Cluster& c = clusters_[node];
        const Vec3 r = c.centre - p;
        const double along = r.dot(u);
        return along >= -c.radius && (r - along * u).squaredNorm() <= c.radius * c.radius;
      },
      [&](int t) {
        if (t == without) return;
        const Vec3 a = mesh.corner(t, 0) - p;
        const Vec3 b = mesh.corner(t, 1) - p;
        const Vec3 c = mesh.corner(t, 2) - p;
        const double x = u.dot(a.cross(b));
        const double y = u.dot(b.cross(c));
        const double z = u.dot(c.cross(a));
        if (!((x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0))) return;
        // Ahead if the signs of the volume and of the side of passing agree.
        crossings += (a.dot(b.cross(c)) > 0) == (x > 0);
      });
  return crossings;
}

}  // namespace hawser
