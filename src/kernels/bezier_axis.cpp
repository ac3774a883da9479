// Element axes as cubic Bézier curves: evaluation, bounds and parts.
#include "hawser/kernels/bezier_axis.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

Vec3 BezierAxis::point(double z) const {
  const double y = 1 - z;
  return y * y * y * b[0] + 3 * z * y * y * b[1] + 3 * z * z * y * b[2] + z * z * z * b[3];
}
Vec3 BezierAxis::slope(double z) const {
  const double y = 1 - z;
  return 3 * (y * y * (b[1] - b[0]) + 2 * y * z * (b[2] - b[1]) + z * z * (b[3] - b[2]));
}
Vec3 BezierAxis::bend(double z) const {
  return 6 * ((1 - z) * (b[2] - 2 * b[1] + b[0]) + z * (b[3] - 2 * b[2] + b[1]));
}
double BezierAxis::slope_bound() const {
  return 3 * std::max({(b[1] - b[0]).norm(), (b[2] - b[1]).norm(), (b[3] - b[2]).norm()});
}
// The two inner Bernstein polynomials sum to at most 3/4.
double BezierAxis::sagitta() const {
  return 0.75 * std::max((b[1] - (2 * b[0] + b[3]) / 3).norm(), (b[2] - (b[0] + 2 * b[3]) / 3).norm());
}
double BezierAxis::farthest_distance(const BezierAxis& other) const {
  double squared = 0;
  for (std::size_t i = 0; i < b.size(); ++i) squared = std::max(squared, (other.b[i] - b[i]).squaredNorm());
  return std::sqrt(squared);
}
Box BezierAxis::box() const {
  Box out;
  for (const Vec3& p : b) out.add(p);
  return out;
}
std::array<BezierAxis, 2> BezierAxis::halves() const {
  const Vec3 p = 0.5 * (b[0] + b[1]);
  const Vec3 q = 0.5 * (b[1] + b[2]);
  const Vec3 r = 0.5 * (b[2] + b[3]);
  const Vec3 pq = 0.5 * (p + q);
  const Vec3 qr = 0.5 * (q + r);
  const Vec3 m = 0.5 * (pq + qr);
  return {BezierAxis{{b[0], p, pq, m}}, BezierAxis{{m, qr, r, b[3]}}};
}
// De Casteljau's algorithm: the polar form of the cubic for all combinations of the two ends.
BezierAxis BezierAxis::part(double from, double to) const {
  const auto blossom = [this](double r, double s, double t) {
    std::array<Vec3, 4> p = b;
    std::size_t n = 3;
    for (const double z : {r, s, t}) {
      for (std::size_t i = 0; i < n; ++i) p[i] = (1 - z) * p[i] + z * p[i + 1];
      --n;
    }
    return p[0];
  };
  return {{blossom(from, from, from), blossom(from, from, to), blossom(from, to, to), blossom(to, to, to)}};
}

BezierAxis between(const BezierAxis& from, const BezierAxis& to) {
  BezierAxis m;
  for (std::size_t i = 0; i < m.b.size(); ++i) m.b[i] = 0.5 * (from.b[i] + to.b[i]);
  return m;
}

}  // namespace hawser
