// Curved triangle: a quadratic patch over a facet of a mesh, and its nearest point.
//
//   q(u, v) = b0 p0 + b1 p1 + b2 p2 + b0 b1 c0 + b1 b2 c1 + b2 b0 c2,  b1 = u, b2 = v, b0 = 1 - u - v
//
// The bend c_i [m] of edge i (from p_i to p_(i+1)) is common to both its triangles, so that they share its
// curve, a parabola whose middle is c_i / 4 off the chord. This is the Phong tessellation of Boubekeur &
// Alexa (2008), "Phong tessellation", ACM Trans. Graph. 27(5), with shape factor 1/2 in terms of edges.
// mesh_bends.hpp computes the bends of a mesh.
#pragma once

#include <array>

#include "hawser/geometry/closest_point.hpp"

namespace hawser {

struct SmoothPatch {
  std::array<Vec3, 3> p, c;  // m, corners and bends

  bool flat() const { return c[0].isZero(0) && c[1].isZero(0) && c[2].isZero(0); }
  Vec3 point(double u, double v) const {
    const double w = 1 - u - v;
    return p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]) + w * u * c[0] + u * v * c[1] + w * v * c[2];
  }
  Vec3 by_u(double u, double v) const { return p[1] - p[0] + (1 - 2 * u - v) * c[0] + v * (c[1] - c[2]); }
  Vec3 by_v(double u, double v) const { return p[2] - p[0] + u * (c[1] - c[0]) + (1 - u - 2 * v) * c[2]; }
  // Outward normal, not a unit vector.
  Vec3 normal(double u, double v) const { return by_u(u, v).cross(by_v(u, v)); }
  // Upper bound of the distance of the patch from the flat triangle, m.
  double bulge() const;
  // Least value over the patch of r . (y - q); divided by |r|, a lower bound of the distance from y, for any
  // r.
  double least(const Vec3& y, const Vec3& r) const;
};

// (u, v) of the point s in [0, 1] on edge i.
std::array<double, 2> on_edge(int i, double s);

struct PatchPoint : ClosestPoint {
  double u = 0, v = 0;
};

// Nearest point of a patch that is not flat, by Newton's method from the foot on the flat triangle; on the
// edges, where it leaves the patch, by a bracketed Newton's method. It is the global minimum if y is not
// beyond the centres of curvature, else a local one.
PatchPoint closest_point_on_patch(const Vec3& y, const SmoothPatch& patch);

// True if this local minimum is known to be global because the squared distance is convex over the patch.
// Along a direction b' of the barycentric coordinates, which moves the point of the flat triangle by w,
//   (|q - y|²/2)'' = |q'|² + (q - y) . q'',
//   q' = w + sum (b_i b_j' + b_i' b_j) c_k,  q'' = 2 sum b_i' b_j' c_k
// over the edges k = ij. With the heights h_i of the triangle |b_i'| <= |w| / h_i, and q lies in the hull of
// its control points, which bounds both terms.
bool one_nearest_point(const Vec3& y, const SmoothPatch& patch);

// Hessian of the signed distance [1/m] for a nearest point (u, v) inside the patch, with unit normal
// n and signed distance d: A I^-1 II (I + d II)^-1 A', with A = [q_u q_v], I = A'A and II_ab = -n . q_ab
// (the surface's curvatures k become k / (1 + d k) at the distance d). Zero factors 1 + d k are bounded.
Mat3 curvature_over_patch(const SmoothPatch& patch, double u, double v, const Vec3& n, double d);

// Hessian for a nearest point at s on edge i: 1/d across the edge, with |d| at least `small` [m], and along
// it the curvature of the edge's curve in the direction of n.
Mat3 curvature_over_edge(const SmoothPatch& patch, int i, double s, const Vec3& n, double d, double small);

}  // namespace hawser
