// Wind and current on bodies: reference figures of a yawed, moving ship, derivatives, and gusts.
#include "hawser/kernels/body_flow.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "hawser/kernels/wind.hpp"
#include "hawser/math/so3.hpp"
#include "support/difference.hpp"

namespace hawser::body_flow_test {
namespace {

using test::slope;

constexpr double kDegree = M_PI / 180;

// Every 15 deg from 0 to 180; the other side is the mirror image.
FlowCoefficients mirrored(const std::array<Vec3, 13>& side) {
  std::vector<FlowCoefficients::Row> rows;
  for (int k = 0; k < 24; ++k) {
    const Vec3& C = side[static_cast<size_t>(k <= 12 ? k : 24 - k)];
    rows.push_back({15 * k * kDegree, k <= 12 ? C : Vec3(C.x(), -C.y(), -C.z())});
  }
  return FlowCoefficients(rows);
}

BodyFlow wind() {
  BodyFlow b;
  b.coefficients =
      mirrored({Vec3(0.8, 0, 0), Vec3(0.7727, 0.2459, 0.0502), Vec3(0.6928, 0.475, 0.0879),
                Vec3(0.5657, 0.6718, 0.1041), Vec3(0.4, 0.8227, 0.0953), Vec3(0.2071, 0.9176, 0.0643),
                Vec3(0, 0.95, 0.02), Vec3(-0.2071, 0.9176, -0.0257), Vec3(-0.4, 0.8227, -0.0606),
                Vec3(-0.5657, 0.6718, -0.0759), Vec3(-0.6928, 0.475, -0.0679), Vec3(-0.7727, 0.2459, -0.0398),
                Vec3(-0.8, 0, 0)});
  b.density = 1.225;
  b.frontal = 3939;
  b.lateral = 14368;
  b.length = 320;
  return b;
}

BodyFlow current() {
  BodyFlow b;
  b.coefficients = mirrored({Vec3(0.05, 0, 0), Vec3(0.0483, 0.1812, 0.03), Vec3(0.0433, 0.35, 0.052),
                             Vec3(0.0354, 0.495, 0.06), Vec3(0.025, 0.6062, 0.052),
                             Vec3(0.0129, 0.6761, 0.03), Vec3(0, 0.7, 0), Vec3(-0.0129, 0.6761, -0.03),
                             Vec3(-0.025, 0.6062, -0.052), Vec3(-0.0354, 0.495, -0.06),
                             Vec3(-0.0433, 0.35, -0.052), Vec3(-0.0483, 0.1812, -0.03), Vec3(-0.05, 0, 0)});
  b.density = 1025;
  b.frontal = b.lateral = 320 * 21.5;
  b.length = 320;
  return b;
}

// A ship of 320 m with tables every 15 deg, in a reference evaluated to nine digits: flow speed and
// direction, heading, ship velocity, and forces and moment in space axes [N, N m].
TEST(BodyFlow, YawedMovingShipHasTheReferenceForces) {
  struct Figure {
    bool air;
    double speed, direction, heading;
    Vec3 ship, force;
  };
  const Figure figures[] = {
      {true, 20, 0, 0, Vec3(0, 0, 0), Vec3(772044, 0, 0)},
      {true, 20, 0, 20, Vec3(0, 0, 0), Vec3(1064572.32, -819762.797, -70703587.0)},
      {true, 25, 250, -35, Vec3(0, 0, 0), Vec3(-2639047.61, -4313404.21, -113173144.0)},
      {true, 15, 180, 10, Vec3(2, 0.5, 0), Vec3(-599656.769, 246611.133, -17971996.0)},
      {false, 1.2, 0, 0, Vec3(0, 0, 0), Vec3(253872, 0, 0)},
      {false, 1.2, 90, 15, Vec3(0, 0, 0), Vec3(-825221.666, 3332837.79, 48743424.0)},
      {false, 0.8, 200, 40, Vec3(0.3, -0.2, 0), Vec3(-1148358.35, 1123786.47, -69231901.3)}};
  for (const Figure& f : figures) {
    RigidBodyState s;
    s.q = exp_so3(f.heading * kDegree * Vec3::UnitZ());
    s.v = f.ship;
    FlowVelocity flow;
    flow.velocity = f.speed * Vec3(std::cos(f.direction * kDegree), std::sin(f.direction * kDegree), 0);
    const Vec6 found = -body_flow(f.air ? wind() : current(), s, flow).f;
    const Vec3 force(found[0], found[1], found[5]);
    for (int k = 0; k < 3; ++k) {
      // Half of the last of nine digits, plus 1e-9 of the largest value.
      const double rounded =
          f.force[k] == 0 ? 0 : 0.5 * std::pow(10, std::floor(std::log10(std::abs(f.force[k]))) - 8);
      EXPECT_NEAR(force[k], f.force[k], 1e-9 * f.force.norm() + rounded)
          << f.speed << " " << f.heading << " " << k;
    }
    EXPECT_EQ(found[2], 0);
    EXPECT_EQ(found.segment<2>(3).norm(), 0);
  }
}

RigidBodyState state(const Vec6& place = Vec6::Zero(), const Vec6& rate = Vec6::Zero()) {
  RigidBodyState s;
  s.x = Vec3(0.3, -0.2, -2.5) + place.head<3>();
  s.q = exp_so3(Vec3(0.2, -0.3, 0.9)) * exp_so3(place.tail<3>());
  s.v = Vec3(0.4, 0.1, -0.3) + rate.head<3>();
  s.w = Vec3(0.05, -0.06, 0.08) + rate.tail<3>();
  return s;
}

TEST(BodyFlow, HasItsDerivatives) {
  BodyFlow b = current();
  b.arm = Vec3(3, -2, 5);
  const auto f = [&](const RigidBodyState& s) {
    const double z = (s.x + s.q * b.arm).z();
    const Vec3 surface(1.3, -0.4, 0), shear(0.05, 0.03, 0);
    return body_flow(b, s, {surface + z * shear, shear});
  };
  const BodyFlowResidual r = f(state());
  const Vec6 zero = Vec6::Zero();
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const Vec6 by_place = slope([&](const Vec6& u) { return f(state(u)).f; }, d);
    const Vec6 by_rate = slope([&](const Vec6& u) { return f(state(zero, u)).f; }, d);
    EXPECT_LT((r.K * d - by_place).norm(), 1e-8 * r.K.norm()) << k;
    EXPECT_LT((r.C * d - by_rate).norm(), 1e-8 * r.C.norm()) << k;
  }
}

// If everything is rotated about the vertical, the forces are rotated as well.
TEST(BodyFlow, TurnsWithItsSurroundings) {
  BodyFlow b = wind();
  b.arm = Vec3(3, -2, 25);
  const FlowVelocity flow{Vec3(12, -7, 0), Vec3::Zero()};
  const Vec6 before = body_flow(b, state(), flow).f;
  for (const double angle : {90.0, 180.0, 237.0}) {
    const Quat turn = exp_so3(angle * kDegree * Vec3::UnitZ());
    RigidBodyState s = state();
    s.x = turn * s.x + Vec3(1e5, -1e5, 0);
    s.q = turn * s.q;
    s.v = turn * s.v;
    const Vec6 after = body_flow(b, s, {turn * flow.velocity, Vec3::Zero()}).f;
    EXPECT_LT((after.head<3>() - turn * before.head<3>()).norm(), 1e-10 * before.norm()) << angle;
    EXPECT_LT((after.tail<3>() - before.tail<3>()).norm(), 1e-10 * before.norm()) << angle;
  }
}

// The variance of the gust components equals the integral of the spectrum between its limits; the phases
// depend on the seed only.
TEST(Gusts, HaveTheEnergyOfTheirSpectrum) {
  constexpr double kSpeed = 25, kHeight = 15, kAtTen = 23;
  for (const GustSpectrum kind : {GustSpectrum::iso, GustSpectrum::api}) {
    const std::vector<Gust> all = gusts(kind, kSpeed, kAtTen, kHeight, 200, 3);
    ASSERT_EQ(all.size(), 200u);
    double energy = 0, exact = 0;
    for (const Gust& g : all) {
      energy += 0.5 * g.amplitude * g.amplitude;
      EXPECT_GT(g.omega, 2 * M_PI * kSlowestGust);
      EXPECT_LT(g.omega, 2 * M_PI * kFastestGust);
    }
    constexpr int kCells = 200000;
    const double df = (kFastestGust - kSlowestGust) / kCells;
    for (int i = 0; i < kCells; ++i)
      exact += df * gust_density(kind, kSlowestGust + (i + 0.5) * df, kSpeed, kAtTen, kHeight);
    EXPECT_NEAR(energy, exact, 1e-5 * exact);
    EXPECT_EQ(all[7].phase, gusts(kind, kSpeed, kAtTen, kHeight, 200, 3)[7].phase);
    EXPECT_NE(all[7].phase, gusts(kind, kSpeed, kAtTen, kHeight, 200, 4)[7].phase);
  }
}

// ISO 19901-1: at f = 0 the density is 320 m²/s² s for 10 m/s at 10 m; where the dimensionless frequency is
// 1, it is divided by 2^(5/(3 n)). The integral of API's spectrum over all frequencies is its variance, (0.15
// V (z/20)^-0.125)².
TEST(Gusts, SpectraHaveTheirFormulas) {
  EXPECT_NEAR(gust_density(GustSpectrum::iso, 0, 10, 10, 10), 320, 1e-12);
  EXPECT_NEAR(gust_density(GustSpectrum::iso, 1.0 / 172, 10, 10, 10), 320 / std::pow(2, 5 / (3 * 0.468)),
              1e-10);
  // 20 m/s at 30 m, 0.01 Hz, evaluated by hand.
  EXPECT_NEAR(gust_density(GustSpectrum::iso, 0.01, 23, 20, 30), 89.67444824, 1e-7);
  double sum = 0, before = 0;
  for (double f = 1e-7; f < 1e5; f *= 1.01) {
    const double middle = 0.5 * (before + f);
    sum += (f - before) * gust_density(GustSpectrum::api, middle, 20, 20, 10);
    before = f;
  }
  const double deviation = 0.15 * 20 * std::pow(0.5, -0.125);
  EXPECT_NEAR(sum, deviation * deviation, 2e-3 * deviation * deviation);
}

TEST(Wind, GrowsWithHeightAndItsFactor) {
  Wind w;
  w.mean = Vec3(0, 20, 0);
  w.height = 90;
  w.exponent = 1.0 / 7;
  w.factor = TimeFactor({{0, 1}, {100, 0.5}});
  EXPECT_NEAR(w.steady(10, 0).y(), 20 * std::pow(1.0 / 9, 1.0 / 7), 1e-12);
  EXPECT_NEAR(w.steady(90, 100).y(), 10, 1e-12);
  w.gusts = {{2, 0.1, 0}};
  EXPECT_NEAR(w.gust(20 * M_PI).y(), 2 * w.strength(20 * M_PI), 1e-12);
  w.gust_ramp = 60;
  EXPECT_EQ(w.gust(0).norm(), 0);
}

}  // namespace
}  // namespace hawser::body_flow_test
