// Three classical tests for a point in a closed mesh, the one by a ray with exact signs, and a test for
// convexity.
#include "hawser/geometry/point_in_polyhedron.hpp"

#include <cmath>

#include "hawser/geometry/closest_point.hpp"
#include "hawser/geometry/extended_precision.hpp"
#include "hawser/math/triple.hpp"

namespace hawser {
namespace {

Vec3 facet_normal(const MeshView& mesh, std::size_t t) {
  return triangle_normal(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
}

int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Exact sign of the sum of six products of doubles.
int exact_sign(const double (&product)[6][2]) {
  // The sum as an expansion of non-overlapping doubles (Shewchuk 1997, "Adaptive precision floating-point
  // arithmetic", grow-expansion); its sign is that of the largest, the last that is not zero.
  double e[12];
  int n = 0;
  const auto add = [&](double b) {
    for (int i = 0; i < n; ++i) {
      const double s = e[i] + b;
      const double bb = s - e[i];
      e[i] = (e[i] - (s - bb)) + (b - bb);
      b = s;
    }
    e[n++] = b;
  };
  for (const auto& f : product) {
    volatile double high = f[0] * f[1];  // must not be fused with the sums
    add(std::fma(f[0], f[1], -high));
    add(high);
  }
  while (n > 1 && e[n - 1] == 0) --n;
  return sign(e[n - 1]);
}

// Side of the 2D point o relative to the line a -> b: 1 left, -1 right; 0 only if a = b, because o is
// considered moved by (eps, eps²).
int side(const double o[2], const double a[2], const double b[2]) {
  const double ax = a[0] - o[0];
  const double ay = a[1] - o[1];
  const double bx = b[0] - o[0];
  const double by = b[1] - o[1];
  const double l = ax * by;
  const double r = ay * bx;
  const double det = l - r;
  int s = 0;
  if (std::abs(det) > 4e-16 * (std::abs(l) + std::abs(r))) {
    s = sign(det);
  } else {
    s = exact_sign({{a[0], b[1]}, {-a[0], o[1]}, {-o[0], b[1]}, {-a[1], b[0]}, {a[1], o[0]}, {o[1], b[0]}});
  }
  if (s == 0) s = -sign(b[1] - a[1]);
  if (s == 0) s = sign(b[0] - a[0]);
  return s;
}

// Sign of (a - p).n, n = (b - a) x (c - a): 1 when p is below the plane (inside of an outward face).
int below(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const Vec3 r = a - p;
  const double d = n.dot(r);
  const double size = (b - a).cwiseAbs().maxCoeff() * (c - a).cwiseAbs().maxCoeff() * r.cwiseAbs().maxCoeff();
  if (std::abs(d) > 1e-14 * size) return sign(d);
  using detail::Extended;
  const auto wa = triple<Extended>(a);
  const Extended w = (triple<Extended>(b) - wa).cross(triple<Extended>(c) - wa).dot(wa - triple<Extended>(p));
  return w > 0 ? 1 : w < 0 ? -1 : 0;
}

}  // namespace

bool inside_by_tetrahedra(const MeshView& mesh, const Vec3& p) {
  // Six times the volume over twice the area is the height of p above the face.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (facet_normal(mesh, t).dot(p - mesh.corner(t, 0)) > 0) return false;
  return true;
}

bool inside_by_ray(const MeshView& mesh, const Vec3& p, int axis) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double o[2] = {p[u], p[v]};
  int crossings = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double q[3][2];
    for (std::size_t i = 0; i < 3; ++i) {
      q[i][0] = mesh.corner(t, i)[u];
      q[i][1] = mesh.corner(t, i)[v];
    }
    // The sign of an edge must be exactly opposite in its two triangles.
    const int s0 = side(o, q[0], q[1]);
    const int s1 = side(o, q[1], q[2]);
    const int s2 = side(o, q[2], q[0]);
    if (s0 == 0 || s0 != s1 || s1 != s2) continue;
    // Along the axis the face points forward (s = 1) or backward; the crossing is ahead if p is on the
    // matching side of its plane.
    if (below(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) == s0) crossings += s0;
  }
  return crossings > 0;
}

bool inside_by_solid_angle(const MeshView& mesh, const Vec3& p) { return winding_number(mesh, p) > 0.5; }

double solid_angle(const Vec3& p, const Vec3& v0, const Vec3& v1, const Vec3& v2) {
  const Vec3 a = v0 - p;
  const Vec3 b = v1 - p;
  const Vec3 c = v2 - p;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double det = a.dot((v1 - v0).cross(v2 - v0));
  return 2 * std::atan2(det, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double winding_number(const MeshView& mesh, const Vec3& p) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += solid_angle(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
  return sum / (4 * M_PI);
}

bool is_convex(const TriangleMesh& mesh, double tolerance) {
  const MeshView view(mesh);
  const Topology topo = topology(mesh);
  if (topo.components != 1 || topo.odd_edges > 0 || topo.non_manifold_edges > 0) return false;
  // A closed surface that is locally convex everywhere is convex (van Heijenoort 1952), unless it winds
  // twice, which is impossible without self-intersection.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 n = facet_normal(view, t);
    for (const int neighbour : topo.neighbours[t])
      for (const int v : mesh.triangles[static_cast<std::size_t>(neighbour)])
        if (n.dot(mesh.vertices[static_cast<std::size_t>(v)] - view.corner(t, 0)) > tolerance) return false;
  }
  return true;
}

}  // namespace hawser
