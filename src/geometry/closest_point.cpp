// The nearest point of a segment and of a triangle, and the normal of a triangle.
#include "hawser/geometry/closest_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser {
namespace {

// Sine of the largest angle below which a triangle counts as its three edges: rounding then tilts its plane
// by more than its height.
constexpr double kNoFace = 1e-8;

struct OnSegment {
  Vec3 point;
  double squared;
  int end;  // 0, 1: an end of the segment; -1: between
};

OnSegment on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a, r = p - a;
  const double along = r.dot(e), length2 = e.dot(e);
  if (!(along > 0) || !(length2 > 0)) return {a, r.dot(r), 0};
  if (along >= length2) return {b, (p - b).dot(p - b), 1};
  const double t = along / length2;
  // From the nearer end, so that the result is exact near both.
  const Vec3 c = t < 0.5 ? Vec3(a + e * t) : Vec3(b - e * ((length2 - along) / length2));
  return {c, (p - c).dot(p - c), -1};
}

// Twice the area vector, from the two edges at the corner of the largest angle: their cross product loses
// least. `face`: it is a face and not a segment or a point.
Vec3 area_vector(const std::array<Vec3, 3>& v, bool& face) {
  std::array<Vec3, 3> e;
  std::array<double, 3> l;  // m²
  for (std::size_t i = 0; i < 3; ++i) e[i] = v[(i + 1) % 3] - v[i], l[i] = e[i].squaredNorm();
  const auto longest = static_cast<std::size_t>(std::max_element(l.begin(), l.end()) - l.begin());
  const std::size_t i = (longest + 1) % 3, j = (longest + 2) % 3;
  const Vec3 n = e[i].cross(e[j]);
  face = n.squaredNorm() > kNoFace * kNoFace * l[i] * l[j];
  return n;
}

}  // namespace

ClosestPoint closest_point_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const OnSegment c = on_segment(p, a, b);
  return {c.point, c.squared, c.end < 0 ? Feature::edge0 : vertex_feature(c.end)};
}

ClosestPoint closest_point_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<Vec3, 3> v{a, b, c};
  bool inside = false;
  const Vec3 n = area_vector(v, inside);
  ClosestPoint out;
  for (std::size_t i = 0; i < 3 && inside; ++i) inside = n.dot((v[(i + 1) % 3] - v[i]).cross(p - v[i])) >= 0;
  if (inside) {
    const double t = n.dot(p - a) / n.squaredNorm();
    out.point = p - n * t;
    out.squared_distance = t * t * n.squaredNorm();
    return out;
  }
  OnSegment best{};
  for (std::size_t i = 0; i < 3; ++i) {
    const OnSegment s = on_segment(p, v[i], v[(i + 1) % 3]);
    if (i > 0 && !(s.squared < best.squared)) continue;
    best = s;
    const int k = static_cast<int>(i);
    out.feature = s.end < 0 ? edge_feature(k) : vertex_feature((k + s.end) % 3);
  }
  out.point = best.point, out.squared_distance = best.squared;
  return out;
}

Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  bool face = false;
  const Vec3 n = area_vector({a, b, c}, face);
  return face ? Vec3(n.normalized()) : Vec3(Vec3::Zero());
}

}  // namespace hawser
