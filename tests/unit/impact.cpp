// How steps are cut beside and in a contact, and how long what an impact set in motion is followed.
#include "hawser/kernels/impact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "hawser/solve/step_control.hpp"

namespace hawser {
namespace {

constexpr double kSlow = 0.01, kSeen = 1e-3;    // s, m
constexpr double kStep = 2 * M_PI / 6 * kSlow;  // s, six in a period
constexpr double kNever = std::numeric_limits<double>::infinity();

double longest(double gap, double closing, double acceleration = 0, bool last = true) {
  return impact_limit(kSlow, kSeen, {gap, closing, acceleration, last}).longest;
}

TEST(Impact, WhatIsSlowIsNone) {
  // 0.09 m/s goes 0.9 mm deep, 9 m/s² is as far from its balance.
  EXPECT_EQ(longest(-0.01, 0.09), kNever);
  EXPECT_EQ(longest(0.01, 0.09), kNever);
  EXPECT_EQ(longest(-0.01, 0, 9), kNever);
  EXPECT_EQ(longest(-0.01, 0.11), kStep);
  EXPECT_EQ(longest(-0.01, 0, -11), kStep);
  EXPECT_EQ(longest(-0.01, 0.08, 8), kStep);  // together
}

TEST(Impact, StepsEndAtTheTouch) {
  EXPECT_DOUBLE_EQ(longest(0.2, 2), 0.1);
  EXPECT_DOUBLE_EQ(longest(0.01, 2), 0.005);
  // Pushed back, v t - a t²/2 = gap, and pulled in.
  const double t = longest(0.01, 2, 5);
  EXPECT_NEAR(2 * t - 2.5 * t * t, 0.01, 1e-15);
  const double u = longest(0.01, 2, -5);
  EXPECT_NEAR(2 * u + 2.5 * u * u, 0.01, 1e-15);
  // It turns before; accelerations change, so it is looked at again on the way.
  EXPECT_DOUBLE_EQ(longest(0.2, 2, 50), 0.2);
  // There already, but for rounding.
  EXPECT_EQ(longest(1e-6, 2), kStep);
  EXPECT_EQ(longest(0, 2), kStep);
  EXPECT_EQ(longest(0.2, -2), kNever);
  EXPECT_EQ(longest(0.2, -2, 20), kStep);  // shakes as fast as the contact
}

TEST(Impact, StepsEndAtItsEnd) {
  // As the trapezoidal rule has it: pushed at the start of the step, no more at its end.
  const double p = 0.004, u = 2, a = 40;
  const double t = longest(-p, -u, a);
  EXPECT_NEAR(-p + t * u + t * t / 4 * a, 0, 1e-15);
  EXPECT_LT(t, kStep);
  // One step does not get there, two do; three do.
  const double far = 2 * 0.04 / (u + std::sqrt(u * u + a * 0.04));
  ASSERT_TRUE(far > kStep && far < 2 * kStep);
  EXPECT_DOUBLE_EQ(longest(-0.04, -u, a), far / 2);
  EXPECT_EQ(longest(-0.3, -u, a), kStep);
  EXPECT_DOUBLE_EQ(longest(-p, -u), p / u);
  EXPECT_EQ(longest(-p, -u, -2000), kStep);  // pulled in again
  // Others of the contact are deeper, or it is out but for rounding.
  EXPECT_EQ(longest(-p, -u, a, false), kStep);
  EXPECT_EQ(longest(-1e-6, -u, a), kStep);
}

TEST(Impact, TellsThePeriodWhileItTouches) {
  EXPECT_DOUBLE_EQ(impact_limit(kSlow, kSeen, {-0.01, 1, 0}).period, 2 * M_PI * kSlow);
  EXPECT_EQ(impact_limit(kSlow, kSeen, {-0.01, 0.01, 0}).period, kNever);
  EXPECT_EQ(impact_limit(kSlow, kSeen, {0.01, 1, 0}).period, kNever);
}

// A linear spring, no damping, the trapezoidal rule (rho = 1): with the steps cut so an impact gives back
// what it took, wherever the steps began; steps of the same length that are not cut do not.
TEST(Impact, MakesNoEnergy) {
  const double w = 1 / kSlow;
  const auto bounce = [&](double start, bool cut) {
    double x = start, v = -2, a = 0, made = 0;
    for (int n = 0; n < 200 && x < 0.2; ++n) {
      double h = kStep;
      if (cut) h = std::min(h, longest(x, -v, a));
      // x1 = x + h (v + v1)/2, v1 = v + h (a + a1)/2, a1 = -w² x1 in touch.
      const double free = x + h * v + h * h / 4 * a;
      const double x1 = free < 0 ? free / (1 + w * w * h * h / 4) : free;
      const double a1 = x1 < 0 ? -w * w * x1 : 0;
      v += h / 2 * (a + a1), x = x1, a = a1;
      made = (v * v + (x < 0 ? w * w * x * x : 0)) / 4 - 1;
    }
    EXPECT_GT(x, 0);
    return made;
  };
  double cut = 0, uncut = 0;
  for (int i = 0; i < 20; ++i) {
    const double start = 0.05 + 0.001 * i;
    cut = std::max(cut, std::abs(bounce(start, true))),
    uncut = std::max(uncut, std::abs(bounce(start, false)));
  }
  std::printf("energy of an impact: %.1e cut, %.1e not\n", cut, uncut);
  EXPECT_LT(cut, 1e-2);
  EXPECT_GT(uncut, 0.1);
}

TEST(StepControl, AnImpactIsFollowed) {
  StepSettings s;
  s.first = s.longest = 0.1;
  StepControl c(s);
  EXPECT_DOUBLE_EQ(c.next(0, 1, kNever), 0.1);
  c.struck(1, 0.03);
  EXPECT_DOUBLE_EQ(c.next(1, 2, kNever), 0.01);
  EXPECT_DOUBLE_EQ(c.next(1, 2, 0.002), 0.002);
  EXPECT_NEAR(c.next(1.59, 1.69, kNever), 0.01, 1e-12);
  EXPECT_NEAR(c.next(1.61, 1.71, kNever), 0.1, 1e-12);
  // A softer one does not make steps longer meanwhile; afterwards it counts.
  c.struck(1.2, 0.3), c.struck(1.2, kNever);
  EXPECT_DOUBLE_EQ(c.next(1.3, 2.3, kNever), 0.01);
  c.struck(1.7, 0.15);
  EXPECT_DOUBLE_EQ(c.next(1.8, 2.8, kNever), 0.05);
  // As after a restart.
  StepControl d(s);
  d.restore(c.wish(), c.wait(), c.ringing(), c.calm());
  EXPECT_DOUBLE_EQ(d.next(1.8, 2.8, kNever), 0.05);
}

TEST(StepControl, FixedStepsAreDividedAtImpactsUnlessToldOtherwise) {
  StepSettings s;
  s.fixed = 0.1;
  StepControl c(s);
  EXPECT_TRUE(c.limited());
  EXPECT_DOUBLE_EQ(c.next(0, 1, kNever), 0.1);
  EXPECT_DOUBLE_EQ(c.next(0, 1, 0.04), 0.04);
  c.accepted(0.04, 2, 0);
  EXPECT_DOUBLE_EQ(c.next(0.04, 1.04, kNever), 0.1);  // it comes back to what was asked
  s.resolve_impacts = false;
  StepControl strict(s);
  EXPECT_FALSE(strict.limited());
  strict.struck(0, 0.03);
  EXPECT_DOUBLE_EQ(strict.next(0, 1, 0.04), 0.1);
}

}  // namespace
}  // namespace hawser
