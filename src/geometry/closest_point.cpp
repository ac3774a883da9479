// Nearest point of a segment and of a triangle, in extended precision if the triangle is a needle or a cap.
// Search among many triangles is in facets.cpp, the sign of the distance in mesh_surface.cpp.
#include "hawser/geometry/closest_point.hpp"

#include <algorithm>

#include "hawser/geometry/extended_precision.hpp"
#include "hawser/math/triple.hpp"

namespace hawser {
namespace {

using detail::Extended;

template <class T>
struct Candidate {
  Triple<T> point;
  T squared;
  int end;  // 0, 1: an end of the segment; -1: between the ends
};

template <class T>
Candidate<T> on_segment(const Triple<T>& p, const Triple<T>& a, const Triple<T>& b) {
  const Triple<T> e = b - a;
  const Triple<T> r = p - a;
  const T along = r.dot(e);
  const T length2 = e.dot(e);
  if (!(along > 0) || !(length2 > 0)) return {a, r.dot(r), 0};
  if (along >= length2) return {b, (p - b).dot(p - b), 1};
  const T t = along / length2;
  // From the nearer end, so that the result is exact near both.
  const Triple<T> c = t < T(0.5) ? a + t * e : b - ((length2 - along) / length2) * e;
  return {c, (p - c).dot(p - c), -1};
}

// Twice the area vector, from the two edges at the corner of the largest angle, whose cross product loses the
// fewest digits. `sine2`: squared sine of that angle; `slender2`: squared ratio of the shortest edge to the
// longest.
template <class T>
Triple<T> area_vector(const Triple<T> v[3], T& sine2, T& slender2) {
  Triple<T> e[3];
  T l[3];
  for (int i = 0; i < 3; ++i) {
    e[i] = v[(i + 1) % 3] - v[i];
    l[i] = e[i].dot(e[i]);
  }
  const int longest = l[0] >= l[1] ? (l[0] >= l[2] ? 0 : 2) : (l[1] >= l[2] ? 1 : 2);
  const int i = (longest + 1) % 3;
  const int j = (longest + 2) % 3;
  const Triple<T> n = e[i].cross(e[j]);
  const T product = l[i] * l[j];
  sine2 = product > 0 ? n.dot(n) / product : T(0);
  slender2 = std::min(l[i], l[j]) / l[longest];
  return n;
}

template <class T>
ClosestPoint on_triangle(const Triple<T>& p, const Triple<T> v[3], const Triple<T>& n, bool flat) {
  ClosestPoint out;
  if (!flat) {
    bool inside = true;
    for (int i = 0; i < 3 && inside; ++i) inside = n.dot((v[(i + 1) % 3] - v[i]).cross(p - v[i])) >= 0;
    if (inside) {
      const T t = n.dot(p - v[0]) / n.dot(n);
      out.point = (p - t * n).vec();
      out.squared_distance = static_cast<double>(t * t * n.dot(n));
      return out;
    }
  }
  Candidate<T> best{};
  for (int i = 0; i < 3; ++i) {
    const Candidate<T> c = on_segment(p, v[i], v[(i + 1) % 3]);
    if (i > 0 && !(c.squared < best.squared)) continue;
    best = c;
    out.feature = c.end < 0 ? edge_feature(i) : vertex_feature((i + c.end) % 3);
  }
  out.point = best.point.vec();
  out.squared_distance = static_cast<double>(best.squared);
  return out;
}

// Squared sine of the largest angle below which the normal needs more than double, and more than long double,
// for an accuracy of 1e-14; and squared ratio of edges below which the choice between two sides of a needle
// needs it.
constexpr double kFlat = 0.04, kVeryFlat = 1e-7, kSlender = 1e-5;

template <class T>
ClosestPoint on_flat_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Triple<T> v[3] = {triple<T>(a), triple<T>(b), triple<T>(c)};
  T sine2 = 0, slender2 = 0;
  const Triple<T> n = area_vector(v, sine2, slender2);
  return on_triangle(triple<T>(p), v, n, !(sine2 > T(1e-40)));
}

}  // namespace

ClosestPoint closest_point_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const auto c = on_segment(triple<double>(p), triple<double>(a), triple<double>(b));
  return {c.point.vec(), c.squared, c.end < 0 ? Feature::edge0 : vertex_feature(c.end)};
}

ClosestPoint closest_point_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Triple<double> v[3] = {triple<double>(a), triple<double>(b), triple<double>(c)};
  double sine2 = 0, slender2 = 0;
  const Triple<double> n = area_vector(v, sine2, slender2);
  if (sine2 > kFlat && slender2 > kSlender) return on_triangle(triple<double>(p), v, n, false);
  if (a == b || b == c || c == a) return on_triangle(triple<double>(p), v, n, true);
  if (sine2 > kVeryFlat) return on_flat_triangle<long double>(p, a, b, c);
  return on_flat_triangle<Extended>(p, a, b, c);
}

Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Triple<double> v[3] = {triple<double>(a), triple<double>(b), triple<double>(c)};
  double sine2 = 0, slender2 = 0;
  const Vec3 n = area_vector(v, sine2, slender2).vec();
  const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (sine2 > kFlat) return n.norm() > 1e-12 * longest2 ? Vec3(n.normalized()) : Vec3(Vec3::Zero());
  const Triple<Extended> fine[3] = {triple<Extended>(a), triple<Extended>(b), triple<Extended>(c)};
  Extended fine_sine2 = 0, fine_slender2 = 0;
  const Vec3 m = area_vector(fine, fine_sine2, fine_slender2).vec();
  return m.norm() > 1e-12 * longest2 ? Vec3(m.normalized()) : Vec3(Vec3::Zero());
}

}  // namespace hawser
