// Nearest points of two segments, with the same result for either order of the segments.
#include "hawser/geometry/segment_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser {
namespace {

// Angle below which two directions are parallel to round-off.
constexpr double kParallel = 1e-15;
// Lengths outside this range are scaled, because their fourth powers would leave the range of double.
constexpr double kSmall = 1e-60, kLarge = 1e60;

bool before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

struct Best {
  double s = 0, t = 0, squared = 0;
  Vec3 w = Vec3::Zero();
};

// Minimum of |r + s u - t v| over the unit square. The lengths are in range and not all zero.
Best solve(const Vec3& r, const Vec3& u, const Vec3& v) {
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const auto at = [&](double s, double t) {
    Best b;
    b.s = s;
    b.t = t;
    b.w = r + s * u - t * v;
    b.squared = b.w.squaredNorm();
    return b;
  };
  // Nearest point of one segment to a given point of the other.
  const auto on_v = [&](double s) { return vv > 0 ? std::clamp((r + s * u).dot(v) / vv, 0.0, 1.0) : 0.5; };
  const auto on_u = [&](double t) { return uu > 0 ? std::clamp((t * v - r).dot(u) / uu, 0.0, 1.0) : 0.5; };

  if (!(std::max(uu, vv) > 0)) return at(0.5, 0.5);
  const Vec3 n = u.cross(v);
  const double nn = n.squaredNorm();
  if (nn > kParallel * kParallel * uu * vv) {
    const double s = -r.cross(v).dot(n) / nn;
    if (s >= 0 && s <= 1) {
      const double t = (r + s * u).dot(v) / vv;
      if (t >= 0 && t <= 1) return at(s, t);
    }
  } else {
    // Parallel: the projection on the longer segment is an interval; if they overlap, its middle.
    const bool along_v = vv >= uu;
    const double p = along_v ? r.dot(v) / vv : -r.dot(u) / uu;
    const double q = along_v ? (r + u).dot(v) / vv : (v - r).dot(u) / uu;
    const double lo = std::max(0.0, std::min(p, q));
    const double hi = std::min(1.0, std::max(p, q));
    if (lo <= hi) {
      const double middle = 0.5 * (lo + hi);
      return along_v ? at(on_u(middle), middle) : at(middle, on_v(middle));
    }
  }
  // Minimum on an edge of the square, the first of equal ones.
  Best best = at(0, on_v(0));
  for (const Best& b : {at(1, on_v(1)), at(on_u(0), 0), at(on_u(1), 1)})
    if (b.squared < best.squared) best = b;
  return best;
}

Vec3 point(const Vec3& p0, const Vec3& p1, double s) {
  if (s == 1) return p1;
  return p0 + s * (p1 - p0);
}

}  // namespace

SegmentPair closest_points_of_segments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  // Always in the same order, so that rounding is the same.
  if (before(b0, a0) || (b0 == a0 && before(b1, a1))) {
    SegmentPair p = closest_points_of_segments(b0, b1, a0, a1);
    std::swap(p.s, p.t);
    std::swap(p.on_a, p.on_b);
    p.difference = -p.difference;
    return p;
  }
  const Vec3 r = a0 - b0;
  const Vec3 u = a1 - a0;
  const Vec3 v = b1 - b0;
  const double size = std::max({r.cwiseAbs().maxCoeff(), u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff()});
  SegmentPair p;
  if (size > kSmall && size < kLarge) {
    const Best best = solve(r, u, v);
    p.s = best.s;
    p.t = best.t;
    p.difference = best.w;
    p.distance = std::sqrt(best.squared);
  } else if (size > 0) {
    // Scaling by a power of two is exact.
    const int e = std::ilogb(size);
    const auto scaled = [](const Vec3& x, int by) {
      return Vec3(std::ldexp(x[0], by), std::ldexp(x[1], by), std::ldexp(x[2], by));
    };
    const Best best = solve(scaled(r, -e), scaled(u, -e), scaled(v, -e));
    p.s = best.s;
    p.t = best.t;
    p.difference = scaled(best.w, e);
    p.distance = std::ldexp(std::sqrt(best.squared), e);
  } else {
    p.s = p.t = 0.5;
  }
  p.on_a = point(a0, a1, p.s);
  p.on_b = point(b0, b1, p.t);
  return p;
}

}  // namespace hawser
