// The nearest points of two segments.
#include "hawser/geometry/segment_distance.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

// Angle below which two directions are parallel to rounding.
constexpr double kParallel = 1e-15;

struct Best {
  double s = 0, t = 0, squared = 0;
  Vec3 w = Vec3::Zero();
};

// |r + s u - t v| over the unit square.
Best solve(const Vec3& r, const Vec3& u, const Vec3& v) {
  const double uu = u.squaredNorm(), vv = v.squaredNorm();
  const auto at = [&](double s, double t) {
    Best b;
    b.s = s, b.t = t;
    b.w = r + s * u - t * v;
    b.squared = b.w.squaredNorm();
    return b;
  };
  // Nearest point of one segment to a given one of the other.
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
    // Along the longer segment the other covers an interval; where they overlap, its middle.
    const bool along_v = vv >= uu;
    const double p = along_v ? r.dot(v) / vv : -r.dot(u) / uu;
    const double q = along_v ? (r + u).dot(v) / vv : (v - r).dot(u) / uu;
    const double lo = std::max(0.0, std::min(p, q)), hi = std::min(1.0, std::max(p, q));
    if (lo <= hi) {
      const double middle = 0.5 * (lo + hi);
      return along_v ? at(on_u(middle), middle) : at(middle, on_v(middle));
    }
  }
  // On an edge of the square; of equal ones the first.
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
  const Best best = solve(a0 - b0, a1 - a0, b1 - b0);
  SegmentPair p;
  p.s = best.s, p.t = best.t, p.difference = best.w, p.distance = std::sqrt(best.squared);
  p.on_a = point(a0, a1, p.s);
  p.on_b = point(b0, b1, p.t);
  return p;
}

}  // namespace hawser
