// Points and directions along straight lengths and arcs in a vertical plane.
#include "hawser/kernels/support_path.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

// Point at the distance s from `p` along one segment.
PathPoint beyond(const PathPoint& p, const PathSegment& segment, double s) {
  PathPoint out = p;
  if (!(segment.radius > 0)) {
    out.at += s * p.along;
    return out;
  }
  const double a = s / segment.radius;
  out.along = std::cos(a) * p.along - std::sin(a) * p.up;
  out.up = std::sin(a) * p.along + std::cos(a) * p.up;
  out.at += segment.radius * (out.up - p.up);
  out.dip += a;
  return out;
}

}  // namespace

Vec3 across(const Vec3& along) { return (Vec3::UnitZ() - along.z() * along).normalized(); }

Vec3 direction_at(const std::vector<Vec3>& points, size_t i) {
  const size_t n = points.size();
  if (n == 2) return (points[1] - points[0]).normalized();
  const size_t m = std::clamp<size_t>(i, 1, n - 2);  // middle point of the parabola
  const Vec3 first = points[m] - points[m - 1];
  const Vec3 second = points[m + 1] - points[m];
  const double a = first.norm();
  const double b = second.norm();
  const Vec3 before = first / a;
  const Vec3 after = second / b;
  // Slopes of the parabola at its three points.
  const Vec3 middle = (b * before + a * after) / (a + b);
  const Vec3 bend = (after - before) / (a + b);
  return (i < m ? Vec3(middle - 2 * a * bend) : i > m ? Vec3(middle + 2 * b * bend) : middle).normalized();
}

SupportPath::SupportPath(const Vec3& from, const Vec3& direction, std::vector<PathSegment> segments)
    : segments_(std::move(segments)) {
  PathPoint p{from, direction, across(direction), -std::asin(std::clamp(direction.z(), -1.0, 1.0))};
  for (const PathSegment& s : segments_) {
    starts_.push_back(p);
    p = beyond(p, s, s.length);
  }
}

double SupportPath::length() const {
  double sum = 0;
  for (const PathSegment& s : segments_) sum += s.length;
  return sum;
}

PathPoint SupportPath::at(double s) const {
  size_t i = 0;
  while (i + 1 < segments_.size() && s > segments_[i].length) s -= segments_[i++].length;
  return beyond(starts_[i], segments_[i], s);
}

}  // namespace hawser
