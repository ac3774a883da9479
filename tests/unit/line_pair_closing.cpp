// How far a contact of lines closed in a step: what comes nearer along the normal and is not made by sliding.
#include "hawser/kernels/line_pair_closing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::line_pair_closing_test {
namespace {

constexpr double kReach = 0.1;

// x on top of y at the end, lines at the angle between them, both straight; `way`: of x relative to y.
LinePairWay straight(double angle, const Vec3& way) {
  const Vec3 a = 0.7 * Vec3::UnitX(), b = 1.3 * Vec3(std::cos(angle), std::sin(angle), 0),
             away = kReach * Vec3::UnitZ();
  return {away, away - way, a, a, b, b};
}

TEST(LinePairClosing, SweepsHaveNoneAndBlowsHaveAll) {
  for (const double angle : {0.2, 0.6, 1.0, M_PI / 2})
    for (const Vec3& way : {Vec3(0.3, 0, 0), Vec3(0, 0.2, 0), Vec3(-0.1, 0.4, 0)}) {
      EXPECT_NEAR(line_pair_closing(straight(angle, way), false).value, 0, 1e-15);
      EXPECT_NEAR(line_pair_closing(straight(angle, way - Vec3(0, 0, 0.02)), false).value, 0.02, 1e-15);
      EXPECT_EQ(line_pair_closing(straight(angle, way + Vec3(0, 0, 0.02)), false).value, 0);
    }
}

// A rope drawn over a wire that it is bent about, sharply or to a radius: the material comes along the leg.
// One that is bent away from the wire, to a radius, does so too.
TEST(LinePairClosing, MaterialThatComesRoundABendSlides) {
  const Vec3 z = Vec3::UnitZ(), b = Vec3::UnitY();
  for (const double turn : {0.3, 0.1, -0.1, -0.3}) {
    const Vec3 leg(std::cos(turn), 0, std::sin(turn)), end = Vec3::UnitX();
    const Vec3 sharp = 0.2 * leg, round = 0.2 / turn * Vec3(std::sin(turn), 0, 1 - std::cos(turn));
    EXPECT_NEAR(line_pair_closing({kReach * z, kReach * z - round, end, leg, b, b}, false).value, 0, 1e-6);
    if (turn > 0) {
      EXPECT_EQ(line_pair_closing({kReach * z, kReach * z - sharp, end, leg, b, b}, false).value, 0);
    }
  }
}

// A rope wound up by a drum of radius r that turns by an angle, upon the turn that lies there: it comes down
// by the height of its leg above that, r angle²/2.
TEST(LinePairClosing, WhatIsWoundUpCloses) {
  const double r = 1, turn = 0.05;
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  const Vec3 y_before(r * std::sin(turn), 0, -r * (1 - std::cos(turn))),
      x_before((r + kReach) * turn, 0, kReach);
  const Vec3 lower_before(std::cos(turn), 0, -std::sin(turn));
  for (const bool swapped : {false, true}) {
    LinePairWay w{kReach * z, x_before - y_before, x, x, x, lower_before};
    if (swapped) w = {-w.away, -w.away_before, x, lower_before, x, x};
    EXPECT_NEAR(line_pair_closing(w, false).value, 0.5 * r * turn * turn, 0.03 * r * turn * turn);
  }
}

TEST(LinePairClosing, Derivatives) {
  const auto noise = [](int i) { return std::sin(12.9898 * i + 4.1 * i * i); };
  for (int seed = 0; seed < 20; ++seed) {
    double in[LinePairClosing::kInputs];
    const auto way = [&]() -> LinePairWay {
      const auto v = [&in](int k) { return Vec3(in[3 * k], in[3 * k + 1], in[3 * k + 2]); };
      return {v(0), v(1), v(2), v(3), v(4), v(5)};
    };
    const Vec3 base[6] = {{0.01, 0.02, 0.1}, {-0.2, 0.1, 0.2}, {1, 0.1, 0.02},
                          {1, 0, -0.1},      {0.3, 1, 0.05},   {0.2, 1.1, 0}};
    for (int i = 0; i < LinePairClosing::kInputs; ++i)
      in[i] = base[i / 3][i % 3] + 0.02 * noise(100 * seed + i);
    const LinePairClosing c = line_pair_closing(way(), true);
    ASSERT_GT(c.value, 0);
    EXPECT_NEAR(c.value, line_pair_closing(way(), false).value, 1e-14);
    for (int i = 0; i < LinePairClosing::kInputs; ++i) {
      const double at = in[i], e = 1e-6;
      in[i] = at + e;
      const double p = line_pair_closing(way(), false).value;
      in[i] = at - e;
      const double m = line_pair_closing(way(), false).value;
      in[i] = at;
      EXPECT_NEAR(c.by[i], (p - m) / (2 * e), 1e-8) << seed << ", " << i;
    }
  }
}

}  // namespace
}  // namespace hawser::line_pair_closing_test
