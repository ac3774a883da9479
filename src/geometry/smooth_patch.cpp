// Nearest point of a quadratic patch by Newton's method inside and along its edges, and the curvature of the
// distance there.
#include "hawser/geometry/smooth_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/math/segment.hpp"

namespace hawser {
namespace {

// Barycentric coordinates (u, v) of the foot of x on the plane of the flat triangle, clamped to it.
std::array<double, 2> flat_coordinates(const SmoothPatch& q, const Vec3& x) {
  const Vec3 e = q.p[1] - q.p[0];
  const Vec3 f = q.p[2] - q.p[0];
  const Vec3 r = x - q.p[0];
  const double ee = e.dot(e);
  const double ef = e.dot(f);
  const double ff = f.dot(f);
  const double er = e.dot(r);
  const double fr = f.dot(r);
  const double det = ee * ff - ef * ef;
  if (!(det > 1e-24 * ee * ff)) return {1.0 / 3, 1.0 / 3};
  const double u = std::clamp((ff * er - ef * fr) / det, 0.0, 1.0);
  return {u, std::clamp((ee * fr - ef * er) / det, 0.0, 1 - u)};
}

struct OnCurve {
  Vec3 point;
  double s, squared;
};

// Nearest point of p + s e + s (1 - s) c, 0 <= s <= 1. Half the derivative of the squared distance is a
// cubic, whose root is bracketed around the best of a few samples to find the lower of two minima.
OnCurve nearest_on_curve(const Vec3& y, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 e = b - a;
  const auto at = [&](double s) {
    return s < 0.5 ? Vec3(a + s * e + s * (1 - s) * c) : Vec3(b - (1 - s) * e + s * (1 - s) * c);
  };
  double s = nearest_fraction(y, a, b);
  double best = (y - at(s)).squaredNorm();
  for (const double other : {0.0, 0.5, 1.0}) {
    const double squared = (y - at(other)).squaredNorm();
    if (squared < best) {
      best = squared;
      s = other;
    }
  }
  double lo = 0, hi = 1;
  for (int i = 0; i < 40; ++i) {
    const Vec3 r = y - at(s);
    const Vec3 tangent = e + (1 - 2 * s) * c;
    const double slope = -r.dot(tangent);
    const double bend = tangent.squaredNorm() + 2 * r.dot(c);
    (slope > 0 ? hi : lo) = s;
    double next = bend > 0 ? s - slope / bend : 0.5 * (lo + hi);
    if (!(next >= lo && next <= hi))
      next = slope > 0 ? (lo == 0 && next < 0 ? 0 : 0.5 * (lo + hi))
                       : (hi == 1 && next > 1 ? 1 : 0.5 * (lo + hi));
    const double step = std::abs(next - s);
    s = next;
    if (step < 1e-15) break;
  }
  OnCurve out{at(s), s, 0};
  out.squared = (y - out.point).squaredNorm();
  for (const double end : {0.0, 1.0}) {
    const Vec3 x = end == 0 ? a : b;
    const double squared = (y - x).squaredNorm();
    if (squared <= out.squared) out = {x, end, squared};
  }
  return out;
}

}  // namespace

double SmoothPatch::bulge() const {
  // b0 b1 c0 + b1 b2 c1 + b2 b0 c2: at most a third of the largest bend; on an edge a quarter of its own.
  const double largest = std::max({c[0].norm(), c[1].norm(), c[2].norm()});
  const double sum = c[0].norm() + c[1].norm() + c[2].norm();
  return std::min(largest / 3, sum / 4);
}

// A quadratic polynomial of (u, v): its least value is on an edge or where its derivatives are zero.
double SmoothPatch::least(const Vec3& y, const Vec3& r) const {
  const std::array<double, 3> f{r.dot(y - p[0]), r.dot(y - p[1]), r.dot(y - p[2])};
  const std::array<double, 3> k{r.dot(c[0]), r.dot(c[1]), r.dot(c[2])};
  double least = std::min({f[0], f[1], f[2]});
  for (std::size_t i = 0; i < 3; ++i) {  // f + s (g - f) - s (1 - s) k
    const double twice = k[i] + f[i] - f[(i + 1) % 3];
    if (twice > 0 && twice < 2 * k[i]) least = std::min(least, f[i] - twice * twice / (4 * k[i]));
  }
  const double uv = k[0] + k[2] - k[1];
  const double det = 4 * k[0] * k[2] - uv * uv;
  if (!(k[0] > 0 && det > 0)) return least;
  const double by_u = f[1] - f[0] - k[0];
  const double by_v = f[2] - f[0] - k[2];
  const double u = (uv * by_v - 2 * k[2] * by_u) / det;
  const double v = (uv * by_u - 2 * k[0] * by_v) / det;
  return u > 0 && v > 0 && u + v < 1 ? std::min(least, f[0] + 0.5 * (by_u * u + by_v * v)) : least;
}

std::array<double, 2> on_edge(int i, double s) {
  if (i == 0) return {s, 0};
  if (i == 1) return {1 - s, s};
  return {0, 1 - s};
}

namespace {

// Foot of a point on the patch, continued beyond its edges.
struct Foot {
  double u = 0, v = 0;
  bool converged = false;

  bool inside() const { return u >= 0 && v >= 0 && u + v <= 1; }
};

struct SecondDerivatives {
  explicit SecondDerivatives(const SmoothPatch& q)
      : uu(-2 * q.c[0]), vv(-2 * q.c[2]), uv(q.c[1] - q.c[0] - q.c[2]) {}
  Vec3 uu, vv, uv;
};

// Step (du, dv) of Newton's method for the minimum of |r|²/2 with r = y - q(u, v):
//   H (du, dv) = (r . q_u, r . q_v),   H_ij = q_i . q_j - r . q_ij.
// Beyond a centre of curvature H is not positive: Gauss-Newton, H_ij = q_i . q_j. False: H is singular.
bool newton_step(const SmoothPatch& q, const SecondDerivatives& second, const Vec3& r, double u, double v,
                 double& du, double& dv) {
  const Vec3 a = q.by_u(u, v);
  const Vec3 b = q.by_v(u, v);
  const double gu = r.dot(a);
  const double gv = r.dot(b);
  const double iuu = a.dot(a);
  const double iuv = a.dot(b);
  const double ivv = b.dot(b);
  double muu = iuu - r.dot(second.uu);
  double muv = iuv - r.dot(second.uv);
  double mvv = ivv - r.dot(second.vv);
  double det = muu * mvv - muv * muv;
  if (!(muu > 0 && det > 1e-6 * (iuu * ivv - iuv * iuv))) {
    muu = iuu;
    muv = iuv;
    mvv = ivv;
    det = muu * mvv - muv * muv;
  }
  if (!(det > 0)) return false;
  du = (mvv * gu - muv * gv) / det;
  dv = (muu * gv - muv * gu) / det;
  return true;
}

// By Newton's method from the foot on the flat triangle; far beyond the edges it stops.
Foot foot_on_patch(const Vec3& y, const SmoothPatch& q) {
  const SecondDerivatives second(q);
  Foot foot;
  auto& [u, v, converged] = foot;
  const auto [flat_u, flat_v] = flat_coordinates(q, y);
  u = flat_u;
  v = flat_v;
  double squared = std::numeric_limits<double>::infinity();
  double du = 0;
  double dv = 0;
  for (int i = 0; i < 30 && !converged; ++i) {
    const Vec3 r = y - q.point(u, v);
    const double now = r.squaredNorm();
    if (now > squared * (1 + 1e-12)) {  // too far: halve the step
      du *= 0.5;
      dv *= 0.5;
      u -= du;
      v -= dv;
      converged = std::max(std::abs(du), std::abs(dv)) < 1e-9;
      continue;
    }
    squared = now;
    if (!newton_step(q, second, r, u, v, du, dv)) break;
    u += du;
    v += dv;
    converged = std::max(std::abs(du), std::abs(dv)) < 1e-9;  // quadratic: the next would be rounding
    if (std::min({u, v, 1 - u - v}) < -0.5) break;
  }
  return foot;
}

// Replaces `out` by the nearest point of the edges if that is nearer. Only edges near a reliable foot can
// contain the nearest point.
void nearest_on_edges(const Vec3& y, const SmoothPatch& q, const Foot& foot, PatchPoint& out) {
  const double b[3] = {1 - foot.u - foot.v, foot.u, foot.v};
  const bool unreliable = !foot.converged || std::min({b[0], b[1], b[2]}) < -0.25;
  for (int i = 0; i < 3; ++i) {
    // The coordinate of the opposite corner is zero on edge i.
    if (!unreliable && b[(i + 2) % 3] > 1e-3) continue;
    const std::size_t j = static_cast<std::size_t>(i);
    const std::size_t k = static_cast<std::size_t>((i + 1) % 3);
    const OnCurve c = nearest_on_curve(y, q.p[j], q.p[k], q.c[j]);
    if (!(c.squared < out.squared_distance)) continue;
    out.point = c.point;
    out.squared_distance = c.squared;
    out.feature = c.s == 0 ? vertex_feature(i) : c.s == 1 ? vertex_feature((i + 1) % 3) : edge_feature(i);
    const auto at = on_edge(i, c.s);
    out.u = at[0];
    out.v = at[1];
  }
}

}  // namespace

PatchPoint closest_point_on_patch(const Vec3& y, const SmoothPatch& q) {
  const Foot foot = foot_on_patch(y, q);
  PatchPoint out;
  out.squared_distance = std::numeric_limits<double>::infinity();
  if (foot.inside()) {
    out.point = q.point(foot.u, foot.v);
    out.squared_distance = (y - out.point).squaredNorm();
    out.u = foot.u;
    out.v = foot.v;
    if (foot.converged) return out;
  }
  nearest_on_edges(y, q, foot, out);
  return out;
}

bool one_nearest_point(const Vec3& y, const SmoothPatch& q) {
  const Vec3 area = (q.p[1] - q.p[0]).cross(q.p[2] - q.p[0]);  // twice
  const double size = area.norm();
  if (!(size > 0)) return false;
  std::array<double, 3> slope;  // 1/h_i, gradients of the barycentric coordinates
  std::array<Vec3, 6> hull;     // control points relative to y
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = q.p[(i + 1) % 3];
    const Vec3& b = q.p[(i + 2) % 3];
    slope[i] = (b - a).norm() / size;
    hull[i] = q.p[i] - y;
    hull[i + 3] = 0.5 * (q.p[i] + a + q.c[i]) - y;
  }
  double shrinks = 0, bends = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double i = slope[k];
    const double j = slope[(k + 1) % 3];
    double largest = 0;
    for (const Vec3& r : hull) largest = std::max(largest, std::abs(r.dot(q.c[k])));
    shrinks += area.cross(q.c[k]).norm() / size * std::max(i, j);
    bends += 2 * largest * i * j;
  }
  return shrinks < 1 && bends < (1 - shrinks) * (1 - shrinks);
}

Mat3 curvature_over_patch(const SmoothPatch& q, double u, double v, const Vec3& n, double d) {
  const Vec3 a = q.by_u(u, v);
  const Vec3 b = q.by_v(u, v);
  const double aa = a.dot(a);
  const double ab = a.dot(b);
  const double bb = b.dot(b);
  const double area2 = aa * bb - ab * ab;
  if (!(area2 > 0)) return Mat3::Zero();
  // In the orthonormal basis (e, f) of the tangent plane the curvature is a symmetric 2 x 2 matrix.
  const double length = std::sqrt(aa);
  const double height = std::sqrt(area2) / length;
  const double shear = ab / length;
  const Vec3 e = a / length;
  const Vec3 f = (b - shear * e) / height;
  const double uu = 2 * n.dot(q.c[0]);
  const double uv = n.dot(q.c[0] + q.c[2] - q.c[1]);
  const double vv = 2 * n.dot(q.c[2]);
  const double ee = uu / aa;
  const double ef = (uv - shear * uu / length) / (length * height);
  const double ff = (vv - 2 * shear * uv / length + shear * shear * uu / aa) / (height * height);
  const double mean = 0.5 * (ee + ff);
  const double half = std::hypot(0.5 * (ee - ff), ef);
  const auto carried = [&](double k) {
    const double scale = 1 + d * k;
    return k / std::copysign(std::max(std::abs(scale), 1e-3), scale);
  };
  const double k_max = carried(mean + half);
  const double k_min = carried(mean - half);
  // Matrix with the same axes and these two eigenvalues.
  const double middle = 0.5 * (k_max + k_min);
  const double ratio = half > 0 ? 0.5 * (k_max - k_min) / half : 0;
  const double across = ratio * ef;
  return (middle + ratio * (ee - mean)) * e * e.transpose() +
         (middle + ratio * (ff - mean)) * f * f.transpose() +
         across * (e * f.transpose() + f * e.transpose());
}

Mat3 curvature_over_edge(const SmoothPatch& q, int i, double s, const Vec3& n, double d, double small) {
  const std::size_t j = static_cast<std::size_t>(i);
  const std::size_t k = static_cast<std::size_t>((i + 1) % 3);
  const Vec3 tangent = q.p[k] - q.p[j] + (1 - 2 * s) * q.c[j];
  const double length2 = tangent.squaredNorm();
  const double divisor = std::copysign(std::max(std::abs(d), small), d);
  if (!(length2 > 0)) return (Mat3::Identity() - n * n.transpose()) / divisor;
  const Vec3 e = tangent / std::sqrt(length2);
  const double bend = 2 * n.dot(q.c[j]) / length2;
  const double scale = 1 + d * bend;
  return (Mat3::Identity() - n * n.transpose() - e * e.transpose()) / divisor +
         bend / std::copysign(std::max(std::abs(scale), 1e-3), scale) * e * e.transpose();
}

}  // namespace hawser
