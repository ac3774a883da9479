// Bent axes during a step: each change of sides is found, and no false change is reported, for crossings at
// known heights.
#include "hawser/kernels/axis_approach.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hawser/kernels/axis_closest_point.hpp"
#include "hawser/math/so3.hpp"

namespace hawser::axis_approach_test {
namespace {

// An axis that bends by up to 0.5 rad at either end.
AxisEnds bent(const Vec3& a, const Vec3& b, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  AxisEnds e;
  e.x1 = a;
  e.x2 = b;
  e.length = 1.01 * (b - a).norm();
  const Quat along = minimal_rotation(e.tangent, b - a);
  const auto turn = [&] { return exp_so3(0.5 * Vec3(unit(random), unit(random), unit(random))) * along; };
  e.q1 = turn();
  e.q2 = turn();
  return e;
}

AxisEnds shifted(AxisEnds e, const Vec3& by) {
  e.x1 += by;
  e.x2 += by;
  return e;
}

// Least distance of two axes.
double distance(const AxisShape& a, const AxisShape& b) {
  double least = HUGE_VAL, at = 0;
  for (int level = 0; level < 4; ++level) {
    const double width = std::pow(0.02, level);
    const double middle = at;
    for (int i = -50; i <= 50; ++i) {
      const double xi = std::clamp((level ? middle : 0.5) + 0.01 * i * width, 0.0, 1.0);
      const double d = closest_point_on(b, a.point(xi)).distance;
      if (d < least) {
        least = d;
        at = xi;
      }
    }
  }
  return least;
}

// Lines that cross at (0, 0) in plan view, one above the other by `gap`, which changes in the step.
TEST(AxisApproach, EveryChangeOfSidesIsFoundHoweverDeep) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double reach = 0.15;
  const ApproachLimits limits{0.25 * reach, 0.5, 0.1 * reach, -1};
  int through = 0, kept = 0;
  for (int i = 0; i < 400; ++i) {
    const AxisEnds b = bent({0, -1, 0}, {0, 1, 0}, random);
    AxisEnds a = bent({-1, 0.3 * unit(random), 0}, {1, 0.3 * unit(random), 0}, random);
    // Bisection for the height at which the axes just meet, so that the gap between the curves is known.
    double low = -1, high = 1;
    const AxisShape B(b);
    for (int k = 0; k < 60; ++k) {
      const double z = 0.5 * (low + high);
      const AxisShape A(shifted(a, {0, 0, z}));
      // Position of the crossing in plan view.
      double x = 0.5, y = 0.5;
      for (int n = 0; n < 30; ++n) {
        const Vec3 d = A.point(x) - B.point(y);
        const Vec3 u = A.slope(x);
        const Vec3 v = B.slope(y);
        const double det = -u.x() * v.y() + u.y() * v.x();
        x -= (-d.x() * v.y() + d.y() * v.x()) / det;
        y -= (u.x() * d.y() - u.y() * d.x()) / det;
      }
      (A.point(x).z() > B.point(y).z() ? high : low) = z;
    }
    a = shifted(a, {0, 0, low});
    // The gap is 0.3 % to 100 % of the sum of the radii. It changes to the other side or nearly to zero.
    const double start_gap = reach * std::pow(10, -1.25 + 1.25 * unit(random));
    const double side = unit(random) < 0 ? -1 : 1;
    const AxisShape from(shifted(a, {0, 0, side * start_gap}));
    for (const double factor : {-1.0, -0.2, -0.01}) {
      ++through;
      EXPECT_EQ(sides_kept(from, AxisShape(shifted(a, {0, 0, side * factor * start_gap})), B, B, limits),
                Sides::near)
          << i << ": " << start_gap << " to " << factor;
    }
    for (const double factor : {0.7, 0.9, 1.0, 1.5}) {
      const AxisShape to(shifted(a, {0, 0, side * factor * start_gap}));
      const double d0 = distance(from, B);
      const double d1 = distance(to, B);
      const double least = std::min(d0, d1);
      double limit = std::min(limits.min_distance, limits.part * d0);
      if (d0 >= limits.floor) limit = std::max(limit, limits.floor);
      const Sides s = sides_kept(from, to, B, B, limits);
      kept += s == Sides::kept;
      if (least < limit) {
        EXPECT_EQ(s, Sides::near) << i;
      }
      if (least > 1.3 * limit && std::abs(d0 / limits.floor - 1) > 0.45) {
        EXPECT_EQ(s, Sides::kept) << i << ": " << d0 / reach << " to " << d1 / reach;
      }
    }
  }
  EXPECT_EQ(through, 1200);
  EXPECT_GT(kept, 400);
}

// Statics: axes that cross in the start shape have no side to keep.
TEST(AxisApproach, AxesThatCrossHaveNoSide) {
  std::mt19937 random(4);
  const AxisShape b(bent({0, -1, 0}, {0, 1, 0}, random));
  AxisEnds e = bent({-1, 0, 0}, {1, 0, 0}, random);
  e = shifted(e, b.point(0.4) - AxisShape(e).point(0.6));
  const AxisShape a(e);
  const AxisShape on(shifted(e, {0, 0, 0.01}));
  EXPECT_EQ(sides_kept(a, on, b, b, {0.1, 0.9, 0, 1e-9}), Sides::crossing);
  EXPECT_EQ(sides_kept(a, on, b, b, {0.1, 0.9, 0, -1}), Sides::near);
  EXPECT_EQ(sides_kept(on, a, b, b, {0.1, 0.9, 0, 1e-9}), Sides::near);
}

}  // namespace
}  // namespace hawser::axis_approach_test
