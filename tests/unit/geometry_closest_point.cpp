// Closest point of a triangle against an independent method in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/closest_point.hpp"
#include "hawser/geometry/extended_precision.hpp"
#include "hawser/math/triple.hpp"

namespace hawser::geometry_closest_point_test {
namespace {

using W = detail::Extended;
using V = Triple<W>;

// The foot of p on the plane if its barycentric coordinates are in [0, 1]; otherwise the nearest point of the
// three segments. In 113 bits this is practically exact.
double reference_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, V& best) {
  const V v[3] = {triple<W>(a), triple<W>(b), triple<W>(c)};
  const V q = triple<W>(p);
  W squared = -1;
  const auto offer = [&](const V& x) {
    const W d = (q - x).dot(q - x);
    if (squared < 0 || d < squared) {
      squared = d;
      best = x;
    }
  };
  for (int i = 0; i < 3; ++i) {
    const V e = v[(i + 1) % 3] - v[i];
    const W l = e.dot(e);
    W t = l > 0 ? (q - v[i]).dot(e) / l : W(0);
    t = t < 0 ? W(0) : t > 1 ? W(1) : t;
    offer(v[i] + t * e);
  }
  const V e = v[1] - v[0];
  const V f = v[2] - v[0];
  const V r = q - v[0];
  const V n = e.cross(f);
  const W nn = n.dot(n);
  if (nn > W(1e-50) * e.dot(e) * f.dot(f)) {
    const W s = n.dot(r.cross(f)) / nn;
    const W t = n.dot(e.cross(r)) / nn;
    if (s >= 0 && t >= 0 && s + t <= 1) offer(v[0] + s * e + t * f);
  }
  // Square root by Newton's method, starting from double.
  W root = std::sqrt(static_cast<double>(squared));
  if (root > 0) root = (root + squared / root) / 2;
  return static_cast<double>(root);
}

void expect_exact(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  V best{};
  const double d = reference_distance(p, a, b, c, best);
  const ClosestPoint got = closest_point_on_triangle(p, a, b, c);
  const double scale = std::max({p.norm(), a.norm(), b.norm(), c.norm()});
  ASSERT_LE(std::abs(std::sqrt(got.squared_distance) - d), 1e-14 * scale)
      << p.transpose() << " | " << a.transpose() << " | " << b.transpose() << " | " << c.transpose();
  ASSERT_LE((got.point - p).norm() - d, 1e-14 * scale);
  ASSERT_GE((got.point - p).norm() - d, -1e-14 * scale);
  // The nearest point is unique, so the points agree as well: to 1e-14 unless the triangle is a sliver.
  const Vec3 r = best.vec();
  ASSERT_LE((got.point - r).norm(), 1e-14 * scale + 1e-15 * scale * scale / std::max(d, scale))
      << p.transpose();
}

Feature feature(const Vec3& p) {
  return closest_point_on_triangle(p, {0, 0, 0}, {4, 0, 0}, {0, 3, 0}).feature;
}

TEST(GeometryClosestPoint, EveryVoronoiRegion) {
  for (const double z : {-2.0, 0.0, 5.0}) {
    EXPECT_EQ(feature({1, 1, z}), Feature::face);
    EXPECT_EQ(feature({2, -1, z}), Feature::edge0);
    EXPECT_EQ(feature({4, 3, z}), Feature::edge1);
    EXPECT_EQ(feature({-1, 1, z}), Feature::edge2);
    EXPECT_EQ(feature({-1, -2, z}), Feature::vertex0);
    EXPECT_EQ(feature({6, -1, z}), Feature::vertex1);
    EXPECT_EQ(feature({-1, 5, z}), Feature::vertex2);
  }
  const ClosestPoint c = closest_point_on_triangle({4, 3, 2}, {0, 0, 0}, {4, 0, 0}, {0, 3, 0});
  // Foot of (4, 3) on the line 3x + 4y = 12: (4, 3) - 12/25 (3, 4).
  EXPECT_NEAR(c.point.x(), 2.56, 1e-15 * 4);
  EXPECT_NEAR(c.point.y(), 1.08, 1e-15 * 4);
  EXPECT_NEAR(c.squared_distance, 5.76 + 4, 1e-14 * 10);
  EXPECT_EQ(feature_index(Feature::edge1), 1);
  EXPECT_EQ(feature_index(Feature::vertex2), 2);
}

TEST(GeometryClosestPoint, RandomTriangles) {
  std::mt19937 gen(3);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto x = [&] { return Vec3(u(gen), u(gen), u(gen)); };
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = x();
    const Vec3 b = x();
    const Vec3 c = x();
    ASSERT_NO_FATAL_FAILURE(expect_exact(2 * x(), a, b, c));
    // Points very near to the triangle, and points far away.
    ASSERT_NO_FATAL_FAILURE(expect_exact((a + b + c) / 3 + 1e-9 * x(), a, b, c));
    ASSERT_NO_FATAL_FAILURE(expect_exact(1e4 * x(), a, b, c));
  }
}

TEST(GeometryClosestPoint, NeedlesAndCaps) {
  std::mt19937 gen(4);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto x = [&] { return Vec3(u(gen), u(gen), u(gen)); };
  for (double thin = 1e-1; thin > 1e-13; thin *= 0.1)
    for (int i = 0; i < 300; ++i) {
      const Vec3 a = x();
      const Vec3 b = x();
      const Vec3 needle = b + thin * x();
      const Vec3 cap = a + (0.5 + 0.4 * u(gen)) * (b - a) + thin * x();
      for (const Vec3& c : {needle, cap}) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(x(), a, b, c)) << thin;
        ASSERT_NO_FATAL_FAILURE(expect_exact((a + b + c) / 3 + thin * x(), a, b, c)) << thin;
      }
    }
}

TEST(GeometryClosestPoint, CollapsedTriangles) {
  const Vec3 a(1, 2, 3), b(2, 4, 5);
  const Vec3 p(7, -1, 2);
  // Degenerate to a point.
  EXPECT_EQ(closest_point_on_triangle(p, a, a, a).squared_distance, (p - a).squaredNorm());
  // Two equal corners, and three collinear ones: the triangle is a segment.
  const double d2 = closest_point_on_segment(p, a, b).squared_distance;
  EXPECT_NEAR(closest_point_on_triangle(p, a, a, b).squared_distance, d2, 1e-13);
  EXPECT_NEAR(closest_point_on_triangle(p, a, b, b).squared_distance, d2, 1e-13);
  EXPECT_NEAR(closest_point_on_triangle(p, a, 0.5 * (a + b), b).squared_distance, d2, 1e-13);
  EXPECT_EQ(triangle_normal(a, 0.5 * (a + b), b), Vec3::Zero());
  EXPECT_EQ(triangle_normal(a, a, b), Vec3::Zero());
  // A segment of zero length.
  EXPECT_EQ(closest_point_on_segment(p, a, a).point, a);
}

TEST(GeometryClosestPoint, NormalOfAFlatCap) {
  // Exact in binary: corners (0,0,0), (1,0,0), (1/2, h, 0) tilted by a quarter turn about x.
  const double h = std::ldexp(1.0, -36);
  EXPECT_EQ(triangle_normal({0, 0, 0}, {1, 0, 0}, {0.5, 0, h}), Vec3(0, -1, 0));
}

TEST(GeometryBox, Distances) {
  const Box b{{0, 0, 0}, {1, 2, 3}};
  EXPECT_DOUBLE_EQ(distance(b, Vec3(0.5, 1, 1)), 0);
  EXPECT_DOUBLE_EQ(distance(b, Vec3(4, 6, 3)), 5);
  EXPECT_DOUBLE_EQ(distance(b, Box{{4, 6, 0}, {5, 7, 1}}), 5);
  EXPECT_TRUE(Box{}.empty());
  EXPECT_TRUE(Box::everything().contains({1e300, 0, 0}));
}

}  // namespace

}  // namespace hawser::geometry_closest_point_test
