// Surface through a grid of heights: the spline, and the distance to it with its derivatives.
#include "hawser/geometry/height_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace hawser::height_grid_test {
namespace {

std::vector<double> spaced(double from, double to, int count, double uneven = 0) {
  std::vector<double> t;
  for (int i = 0; i <= count; ++i) {
    const double u = static_cast<double>(i) / count;
    t.push_back(from + (to - from) * (u + uneven * u * (1 - u)));
  }
  return t;
}

template <class F>
HeightGrid grid(const std::vector<double>& x, const std::vector<double>& y, F&& f) {
  std::vector<double> z;
  for (const double b : y)
    for (const double a : x) z.push_back(f(a, b));
  return {x, y, z};
}

// The spline reproduces a plane, also beyond the grid, with its exact distance.
TEST(HeightGrid, Plane) {
  const Vec3 n = Vec3(-0.3, 0.2, 1).normalized();
  const HeightGrid g = grid(spaced(-50, 70, 7, 0.3), spaced(10, 90, 5, -0.4),
                            [](double x, double y) { return -100 + 0.3 * x - 0.2 * y; });
  EXPECT_NEAR(g.steepest(), std::hypot(0.3, 0.2), 1e-13);
  for (const Vec3& p : {Vec3(0, 50, -108), Vec3(33, 21, -60), Vec3(-49, 89, -150), Vec3(-500, 400, -300)}) {
    const auto s = g.query(p, 1e9);
    ASSERT_TRUE(s);
    EXPECT_NEAR(s->distance, n.dot(p - Vec3(0, 0, -100)), 1e-10);
    EXPECT_LT((s->normal - n).norm(), 1e-12);
    EXPECT_LT(s->curvature.norm(), 1e-12);
    EXPECT_LT((s->point - (p - s->distance * n)).norm(), 1e-9);
  }
  EXPECT_FALSE(g.query({0, 50, -100}, 5));  // 10 m above the plane, 9.4 m from it
  EXPECT_TRUE(g.query({0, 50, -100}, 9.5));
}

double waves(double x, double y) { return 2 * std::sin(0.21 * x + 0.4) * std::cos(0.17 * y); }

// Slope and curvature are the derivatives of the height, and are continuous between cells and beyond the
// edge; convergence to a smooth surface is of fourth order.
TEST(HeightGrid, SplineIsTwiceDifferentiable) {
  const HeightGrid g = grid(spaced(0, 40, 10, 0.2), spaced(0, 30, 8), waves);
  const double h = 1e-5;
  for (const double x : {-3.0, 5.1, 17.77, 39.9, 44.0})
    for (const double y : {-2.0, 0.3, 11.25, 28.0, 33.0}) {
      const auto a = g.at(x, y);
      const auto e = g.at(x + h, y);
      const auto w = g.at(x - h, y);
      const auto n = g.at(x, y + h);
      const auto s = g.at(x, y - h);
      EXPECT_NEAR(a.slope.x(), (e.z - w.z) / (2 * h), 1e-8);
      EXPECT_NEAR(a.slope.y(), (n.z - s.z) / (2 * h), 1e-8);
      EXPECT_LT((a.bend.col(0) - (e.slope - w.slope) / (2 * h)).norm(), 1e-8);
      EXPECT_LT((a.bend.col(1) - (n.slope - s.slope) / (2 * h)).norm(), 1e-8);
    }
  // Continuity across every grid line and the edges.
  for (const double x : g.x())
    EXPECT_LT((g.at(x - 1e-9, 7.3).bend - g.at(x + 1e-9, 7.3).bend).norm(), 1e-7) << x;
  for (const double y : g.y())
    EXPECT_LT((g.at(13.1, y - 1e-9).bend - g.at(13.1, y + 1e-9).bend).norm(), 1e-7) << y;
  double last = 0;
  for (const int cells : {20, 40, 80}) {
    const HeightGrid fine = grid(spaced(0, 80, 2 * cells), spaced(0, 60, cells), waves);
    double off = 0;
    for (double x = 30; x < 50; x += 0.37)
      off = std::max(off, std::abs(fine.at(x, 0.6 * x).z - waves(x, 0.6 * x)));
    if (last > 0) {
      EXPECT_GT(last / off, 12);
    }
    last = off;
  }
  EXPECT_LT(last, 1e-4);
  double steep = 0;
  for (double x = 0; x < 40; x += 0.1)
    for (double y = 0; y < 30; y += 0.1) steep = std::max(steep, g.at(x, y).slope.norm());
  EXPECT_GE(g.steepest(), steep);
  EXPECT_LT(g.steepest(), 2 * steep);
}

// The distance is the minimum over many points, its gradient the normal, its Hessian the curvature: above,
// below, on the surface and beyond the edge.
TEST(HeightGrid, DistanceAndItsDerivatives) {
  const HeightGrid g = grid(spaced(0, 40, 12), spaced(0, 30, 9), waves);
  for (const Vec3& at : {Vec3(5, 6, 3), Vec3(21, 14, 1), Vec3(21, 14, -3), Vec3(30.2, 9.9, 0.5),
                         Vec3(42, 31, 1), Vec3(12, 25, g.at(12, 25).z)}) {
    const auto s = g.query(at, 100);
    ASSERT_TRUE(s);
    double nearest = 1e9;
    for (double x = s->point.x() - 3; x < s->point.x() + 3; x += 0.02)
      for (double y = s->point.y() - 3; y < s->point.y() + 3; y += 0.02)
        nearest = std::min(nearest, (Vec3(x, y, g.at(x, y).z) - at).norm());
    EXPECT_NEAR(std::abs(s->distance), nearest, 1e-2 * (nearest + 0.03));
    EXPECT_GE(nearest, std::abs(s->distance) - 1e-12);
    EXPECT_EQ(s->distance < 0, at.z() < g.at(at.x(), at.y()).z);
    EXPECT_LT((at - s->distance * s->normal - s->point).norm(), 1e-12);
    const double h = 1e-5;
    for (int i = 0; i < 3; ++i) {
      const auto up = g.query(at + h * Vec3::Unit(i), 100);
      const auto down = g.query(at - h * Vec3::Unit(i), 100);
      EXPECT_NEAR((up->distance - down->distance) / (2 * h), s->normal[i], 1e-9);
      EXPECT_LT(((up->normal - down->normal) / (2 * h) - s->curvature.col(i)).norm(), 1e-7) << at.transpose();
    }
  }
}

// Beside a unit step between equidistant heights the slopes of a cubic spline decrease by r = sqrt(3) - 2
// from point to point, from S = 3/(3 + sqrt(3)) on either side of the step: the spline is S u (1 - u) (r (1 -
// u) - u) in the cell before it.
TEST(HeightGrid, OvershootBesideAStep) {
  const double r = std::sqrt(3) - 2;
  const double S = 3 / (3 + std::sqrt(3));
  double most = 0, where = 0;
  for (double u = 0; u < 1; u += 1e-5)
    if (const double z = S * u * (1 - u) * (r * (1 - u) - u); z < most) {
      most = z;
      where = u;
    }
  const auto long_row = spaced(-300, 300, 60);
  const auto short_row = spaced(0, 40, 4);
  const auto step = [](double x) { return x > 0.1 ? -90.0 : -100.0; };
  const auto along_x = grid(long_row, short_row, [&](double x, double) { return step(x); }).overshoot();
  EXPECT_NEAR(along_x.height, -10 * most, 1e-6);
  // The undershoot below the step and the overshoot above it are symmetric.
  EXPECT_NEAR(along_x.at.x(), along_x.above ? 20 - 10 * where : 10 * where - 10, 1e-2);
  const auto along_y = grid(short_row, long_row, [&](double, double y) { return -step(y); }).overshoot();
  EXPECT_NEAR(along_y.height, -10 * most, 1e-6);
  EXPECT_NEAR(along_y.at.y(), along_y.above ? 10 * where - 10 : 20 - 10 * where, 1e-2);
  // Slightly uneven neighbours do not hide the overshoot.
  const auto noise = [&](double x, double) { return step(x) + 0.01 * std::sin(7 * x * x); };
  EXPECT_NEAR(grid(long_row, short_row, noise).overshoot().height, -10 * most, 0.05);
}

// Hills with a dozen points in a period, and planes, have no overshoot.
TEST(HeightGrid, NoOvershootOfHills) {
  const auto hills = [](double x, double y) {
    return 2 * std::sin(M_PI / 6 * x + 0.4) * std::cos(M_PI / 6 * y);
  };
  EXPECT_LT(grid(spaced(0, 60, 60), spaced(0, 60, 60), hills).overshoot().height, 0.01);
  EXPECT_LT(grid(spaced(0, 9, 3), spaced(0, 9, 3, 0.3), [](double x, double y) { return x - y; })
                .overshoot()
                .height,
            1e-12);
}

TEST(HeightGrid, RefusesWhatIsNoGrid) {
  EXPECT_THROW(HeightGrid({0}, {0, 1}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(HeightGrid({0, 1}, {0, 1}, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(HeightGrid({0, 0}, {0, 1}, {0, 0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace hawser::height_grid_test
