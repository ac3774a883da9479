// Projection of a point onto an element axis by a bracketed Newton iteration, for contact between lines.
#include "hawser/kernels/axis_closest_point.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr int kPlaces = 5, kMaxIterations = 60;
constexpr double kRoot = 1e-15, kNewton = 1e-9;  // the error after a step of Newton's is its square

}  // namespace

AxisProjection point_at(const AxisShape& axis, double eta, const Vec3& x) {
  AxisProjection f;
  f.eta = eta;
  f.away = x - axis.point(eta);
  f.distance = f.away.norm();
  if (f.distance > 0)
    f.normal = f.away / f.distance;
  else  // on the axis all normal directions are equivalent
    f.normal = axis.slope(eta).unitOrthogonal();
  return f;
}

AxisProjection closest_point_on(const AxisShape& axis, const Vec3& x) {
  if (axis.count() == 2) {
    const Vec3 a = axis.point(0);
    const Vec3 u = axis.slope(0);
    const double uu = u.squaredNorm();
    const double t = uu > 0 ? (x - a).dot(u) / uu : 0.0;
    AxisProjection f = point_at(axis, std::clamp(t, 0.0, 1.0), x);
    f.inside = t > 0 && t < 1;
    return f;
  }
  int best = 0;
  double smallest = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double d = (x - axis.point(i / (kPlaces - 1.0))).squaredNorm();
    if (i == 0 || d < smallest) {
      best = i;
      smallest = d;
    }
  }
  double lo = std::max(best - 1, 0) / (kPlaces - 1.0);
  double hi = std::min(best + 1, kPlaces - 1) / (kPlaces - 1.0);
  double eta = best / (kPlaces - 1.0);
  // h = half the derivative of the squared distance.
  const auto h = [&](double e) { return (axis.point(e) - x).dot(axis.slope(e)); };
  if (lo == 0 && h(0) >= 0) return point_at(axis, 0, x);
  if (hi == 1 && h(1) <= 0) return point_at(axis, 1, x);
  for (int i = 0; i < kMaxIterations; ++i) {
    const Vec3 away = axis.point(eta) - x;
    const Vec3 y1 = axis.slope(eta);
    const double v = away.dot(y1);
    const double slope = y1.squaredNorm() + away.dot(axis.bend(eta));
    (v < 0 ? lo : hi) = eta;
    double next = eta - v / slope;
    const bool newton = slope > 0 && next > lo && next < hi;
    if (!newton) next = 0.5 * (lo + hi);
    const double moved = std::abs(next - eta);
    eta = next;
    if (moved <= (newton ? kNewton : kRoot) || hi - lo <= kRoot) break;
  }
  AxisProjection f = point_at(axis, eta, x);
  f.inside = true;
  return f;
}

}  // namespace hawser
