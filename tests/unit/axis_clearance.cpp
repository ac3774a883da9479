// Distances of axes to each other and to surfaces, against closed forms and fine sampling.
#include "hawser/kernels/axis_clearance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hawser/geometry/segment_distance.hpp"
#include "hawser/geometry/surface.hpp"

namespace hawser::axis_clearance_test {
namespace {

BezierAxis random_axis(std::mt19937& random, double bend) {
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vec = [&] { return Vec3(u(random), u(random), u(random)); };
  BezierAxis a = BezierAxis::straight(vec(), vec());
  a.b[1] += bend * vec();
  a.b[2] += bend * vec();
  return a;
}

TEST(AxisClearance, BoundsHold) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const BezierAxis a = random_axis(random, 0.5);
    const auto halves = a.halves();
    for (double z = 0; z <= 1; z += 0.05) {
      EXPECT_LE(a.slope(z).norm(), a.slope_bound() * (1 + 1e-12));
      EXPECT_TRUE(a.box().grown(1e-12).contains(a.point(z)));
      const Vec3 u = a.b[3] - a.b[0];
      const double t = std::clamp(u.dot(a.point(z) - a.b[0]) / u.squaredNorm(), 0.0, 1.0);
      EXPECT_LE((a.point(z) - a.b[0] - t * u).norm(), a.sagitta() * (1 + 1e-12) + 1e-12);
      EXPECT_LT((halves[0].point(z) - a.point(0.5 * z)).norm(), 1e-14);
      EXPECT_LT((halves[1].point(z) - a.point(0.5 + 0.5 * z)).norm(), 1e-14);
      const double h = 1e-5;
      EXPECT_LT(((a.point(z + h) - a.point(z - h)) / (2 * h) - a.slope(z)).norm(), 1e-7);
      EXPECT_LT(((a.slope(z + h) - a.slope(z - h)) / (2 * h) - a.bend(z)).norm(), 1e-7);
    }
  }
}

TEST(AxisClearance, StraightAxesAreSegments) {
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    const BezierAxis a = random_axis(random, 0);
    const BezierAxis b = random_axis(random, 0);
    const auto near = nearest_of(a, b, HUGE_VAL, 1e-3);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distance, closest_points_of_segments(a.b[0], a.b[3], b.b[0], b.b[3]).distance, 1e-12);
    EXPECT_FALSE(nearest_of(a, b, near->distance * (1 - 1e-9), 1e-3));
  }
}

// Against fine sampling: the result is a lower bound, and the distance at the returned place is close to it.
TEST(AxisClearance, BentAxes) {
  std::mt19937 random(3);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const BezierAxis a = random_axis(random, 0.6);
    const BezierAxis b = random_axis(random, 0.6);
    const auto near = nearest_of(a, b, HUGE_VAL, 1e-3);
    ASSERT_TRUE(near);
    EXPECT_NEAR((a.point(near->xi) - b.point(near->eta)).norm(), near->distance, 1e-14);
    double least = HUGE_VAL;
    constexpr int n = 300;
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k)
        least = std::min(least, (a.point(j / 300.0) - b.point(k / 300.0)).squaredNorm());
    worst = std::max(worst, near->distance - std::sqrt(least));
  }
  // Points whose distances differ by less than the resolution count as equal.
  EXPECT_LT(worst, 1e-3);
}

// Quarter circles about one axis, one above the other by 0.3; the cubic of a quarter circle is accurate to
// 3e-4 of the radius.
TEST(AxisClearance, ParallelArcs) {
  const double k = 4.0 / 3 * (std::sqrt(2.0) - 1);
  BezierAxis a{{Vec3(1, 0, 0), Vec3(1, k, 0), Vec3(k, 1, 0), Vec3(0, 1, 0)}};
  BezierAxis b = a;
  for (Vec3& p : b.b) p.z() += 0.3;
  EXPECT_NEAR(nearest_of(a, b, 1, 1e-4)->distance, 0.3, 1e-12);
  for (Vec3& p : b.b) p = 0.5 * Vec3(p.x(), p.y(), 0);
  EXPECT_NEAR(nearest_of(a, b, 1, 1e-4)->distance, 0.5, 5e-4);
}

auto field_of(const Surface& s) {
  return [&s](const Vec3& x, double within, Vec3& normal) -> std::optional<double> {
    const auto p = s.query(x, within);
    if (!p) return std::nullopt;
    normal = p->normal;
    return p->distance;
  };
}

TEST(AxisClearance, ToAPlaneAndACylinder) {
  const PlaneSurface plane(Vec3(0, 0, 0), Vec3(0, 0, 1));
  BezierAxis a{{Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 1)}};
  auto near = nearest_to(field_of(plane), a, HUGE_VAL, 2);
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->distance, 0.25, 1e-12);
  EXPECT_NEAR(near->xi, 0.5, 1e-6);
  EXPECT_FALSE(nearest_to(field_of(plane), a, 0.2499, 2));
  for (Vec3& p : a.b) p.z() -= 0.5;  // penetrating
  EXPECT_NEAR(nearest_to(field_of(plane), a, HUGE_VAL, 2)->distance, -0.25, 1e-12);

  const CylinderSurface cylinder(Vec3(1.3, -1, -1), Vec3(1.3, 1, -1), 0.5);
  const BezierAxis bar = BezierAxis::straight(Vec3(0, 0.2, 0), Vec3(3, -0.2, 0));
  near = nearest_to(field_of(cylinder), bar, HUGE_VAL, 3);
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->distance, 0.5, 1e-12);
  EXPECT_NEAR(near->xi, 1.3 / 3, 1e-7);
}

}  // namespace
}  // namespace hawser::axis_clearance_test
