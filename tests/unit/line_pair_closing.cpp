// Closing of a contact of lines in a step (approach along the normal without sliding) against closed forms,
// and derivatives of the contact law that uses it.
#include "hawser/kernels/line_pair_closing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hawser/kernels/line_pair_law.hpp"

namespace hawser::line_pair_closing_test {
namespace {

constexpr double kReach = 0.1;

// x above y at the end, lines at the given angle, both straight; `way`: displacement of x relative to y.
LinePairMotion<double> straight(double angle, const Vec3& way) {
  const Vec3 a = 0.7 * Vec3::UnitX();
  const Vec3 b = 1.3 * Vec3(std::cos(angle), std::sin(angle), 0);
  const Vec3 away = kReach * Vec3::UnitZ();
  return {away, away - way, a, a, b, b};
}

TEST(LinePairClosing, SweepsHaveNoneAndImpactsHaveAll) {
  for (const double angle : {0.2, 0.6, 1.0, M_PI / 2})
    for (const Vec3& way : {Vec3(0.3, 0, 0), Vec3(0, 0.2, 0), Vec3(-0.1, 0.4, 0)}) {
      EXPECT_NEAR(line_pair_closing(straight(angle, way)), 0, 1e-15);
      EXPECT_NEAR(line_pair_closing(straight(angle, way - Vec3(0, 0, 0.02))), 0.02, 1e-15);
      EXPECT_LT(line_pair_closing(straight(angle, way + Vec3(0, 0, 0.02))), 0);
    }
}

// The closing is finite for an element that reverses within the step, as in a chain that is lowered exactly
// upright.
TEST(LinePairClosing, WhatTurnsRoundIsFinite) {
  LinePairMotion<double> way = straight(0, Vec3(0.1, 0, -0.02));
  way.slope_before = -way.slope;
  EXPECT_TRUE(std::isfinite(line_pair_closing(way)));
  way.along_before = -way.along;
  EXPECT_NEAR(line_pair_closing(way), 0.02, 1e-15);
}

// A rope is drawn over a wire and bent around it, sharply or to a radius: the material moves along the leg,
// so the closing is zero or negative. The same for a rope that is bent away from the wire to a radius.
TEST(LinePairClosing, MaterialThatComesRoundABendSlides) {
  const Vec3 z = Vec3::UnitZ(), b = Vec3::UnitY();
  for (const double turn : {0.3, 0.1, -0.1, -0.3}) {
    const Vec3 leg(std::cos(turn), 0, std::sin(turn));
    const Vec3 end = Vec3::UnitX();
    const Vec3 sharp = 0.2 * leg;
    const Vec3 round = 0.2 / turn * Vec3(std::sin(turn), 0, 1 - std::cos(turn));
    EXPECT_NEAR(line_pair_closing<double>({kReach * z, kReach * z - round, end, leg, b, b}), 0, 1e-6);
    if (turn > 0) {
      EXPECT_LT(line_pair_closing<double>({kReach * z, kReach * z - sharp, end, leg, b, b}), 0);
    }
  }
}

// A rope is wound onto its previous turn by a drum of radius r that rotates by an angle: it descends by the
// height of its leg, r angle²/2.
TEST(LinePairClosing, WhatIsWoundUpCloses) {
  const double r = 1, turn = 0.05;
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  const Vec3 y_before(r * std::sin(turn), 0, -r * (1 - std::cos(turn)));
  const Vec3 x_before((r + kReach) * turn, 0, kReach);
  const Vec3 lower_before(std::cos(turn), 0, -std::sin(turn));
  for (const bool swapped : {false, true}) {
    LinePairMotion<double> w{kReach * z, x_before - y_before, x, x, x, lower_before};
    if (swapped) w = {-w.away, -w.away_before, x, lower_before, x, x};
    EXPECT_NEAR(line_pair_closing(w), 0.5 * r * turn * turn, 0.03 * r * turn * turn);
  }
}

// Derivatives of force and couple by all arguments of the law, with and without limited slip of new material.
TEST(LinePairClosing, DerivativesOfTheLaw) {
  const auto noise = [](int i) { return std::sin(12.9898 * i + 4.1 * i * i); };
  using F = LinePairForce;
  for (int seed = 0; seed < 20; ++seed) {
    LinePairLaw law;
    law.radii = 0.12;
    law.normal.stiffness = 1e3;
    law.normal.smoothing = 1e-3;
    law.normal.damping = 2;
    law.friction.axial = law.friction.lateral = seed % 2 ? 0.3 : 3;
    law.friction.axial_length = law.friction.lateral_length = 0.4;
    double in[F::kInputs];
    const auto force = [&](bool derivatives) {
      const auto v = [&in](int first) { return Vec3(in[first], in[first + 1], in[first + 2]); };
      LinePairPoint at;
      at.away = v(F::kAway);
      at.along = v(F::kAlong);
      at.moved = v(F::kMoved);
      at.rate = in[F::kRate];
      at.slip[0] = in[F::kSlip];
      at.slip[1] = in[F::kSlip + 1];
      at.is_new = seed % 4 < 3;
      at.away_before = v(F::kAwayBefore);
      at.slope = v(F::kSlope);
      at.slope_before = v(F::kSlopeBefore);
      at.along_before = v(F::kAlongBefore);
      return line_pair_force(law, at, derivatives);
    };
    const double base[F::kInputs] = {0.01, 0.02, 0.1, 0.3, 1,   0.05, 0.1, -0.05, 0.02, 0.1, 0.01, -0.02,
                                     -0.2, 0.1,  0.2, 1,   0.1, 0.02, 1,   0,     -0.1, 0.2, 1.1,  0};
    for (int i = 0; i < F::kInputs; ++i) in[i] = base[i] + 0.01 * noise(100 * seed + i);
    const F f = force(true);
    const F same = force(false);
    ASSERT_GT(f.along_normal.force, 0);
    EXPECT_LT((f.force - same.force).norm() + (f.couple - same.couple).norm(), 1e-12);
    for (int i = 0; i < F::kInputs; ++i) {
      const double at = in[i];
      const double e = 1e-6;
      in[i] = at + e;
      const F p = force(false);
      in[i] = at - e;
      const F m = force(false);
      in[i] = at;
      // The couple is force x D.
      const Vec3 away(in[F::kAway], in[F::kAway + 1], in[F::kAway + 2]);
      const Vec3 by = f.by.col(i);
      const Vec3 by_away = i < F::kAlong ? Vec3(Vec3::Unit(i)) : Vec3(Vec3::Zero());
      const Vec3 couple_by = by.cross(away) + f.force.cross(by_away);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(by[c], (p.force[c] - m.force[c]) / (2 * e), 1e-5) << seed << ", " << i;
        EXPECT_NEAR(couple_by[c], (p.couple[c] - m.couple[c]) / (2 * e), 1e-5) << seed << ", " << i;
      }
    }
  }
}

}  // namespace
}  // namespace hawser::line_pair_closing_test
