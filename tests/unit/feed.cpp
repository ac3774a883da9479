// What a winch lets out in a step by its tension, the force of the element at its mouth, and the energy that
// a changed unstretched length brings.
#include "hawser/kernels/feed.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hawser/model/feed.hpp"

namespace hawser::test::feed_test {
namespace {

StiffnessTable rope() {
  return StiffnessTable(std::vector<StiffnessTable::Row>{{0.05, 15}, {0.1, 90}, {0.2, 120}}, false);
}

double tension(const CableSection& s, double chord, double length) {
  const double strain = chord / length - 1 - s.free_strain;
  return strain > 0 ? s.axial(strain).force : 0;
}

TEST(Feed, SolvesItsSpeedLaw) {
  const StiffnessTable table = rope();
  for (const StiffnessTable* t : {static_cast<const StiffnessTable*>(nullptr), &table})
    for (const double k : {0.0, 0.01, 1.0, 100.0})
      for (const double most : {0.0, 0.2}) {
        CableSection s{1, 300, 0, t, 0.01};
        const FeedLaw law{20, k, most, false};
        for (const double chord : {0.3, 0.9, 1.0, 1.05, 1.1, 1.2, 1.8})
          for (const double h : {1e-3, 0.1, 10.0}) {
            const double from = 1.02;
            const FedElement e = feed_step(s, law, from, h, chord);
            const double T = tension(s, chord, e.length), v = (e.length - from) / h;
            EXPECT_GT(e.length, 0);
            if (most > 0) {
              EXPECT_LE(std::abs(v), most * (1 + 1e-9));
            }
            if (most == 0 || std::abs(v) < most * (1 - 1e-9)) {
              if (k == 0) {
                EXPECT_NEAR(T, 20, 1e-9);
              } else if (e.length > 1e-5) {
                EXPECT_NEAR(v, k * (T - 20), 1e-9 * (1 + k * T));
              }
            }
            constexpr double d = 1e-6;
            const double slope = (feed_step(s, law, from, h, chord + d).length -
                                  feed_step(s, law, from, h, chord - d).length) /
                                 (2 * d);
            EXPECT_NEAR(slope, e.by_chord, 1e-6 * (1 + std::abs(slope))) << k << ' ' << chord << ' ' << h;
          }
      }
  EXPECT_EQ(feed_step({1, 300}, {20, 1, 0, true}, 1.02, 0.1, 1.5).length, 1.02);
}

TEST(Feed, TheForceFollowsTheLength) {
  const StiffnessTable table = rope();
  for (const StiffnessTable* t : {static_cast<const StiffnessTable*>(nullptr), &table})
    for (const double k : {0.0, 0.05}) {
      const FeedLaw law{20, k, 0, false};
      const CableSection before{1, 300, 0.02, t, 0.01};
      const CableStart from = cable_start(before, Vec3::Zero(), Vec3(0.9, 0.5, -0.3), 0.01);
      const CableStep step{0.1, 0.06};
      const auto mean = [&](const Vec3& x, CablePull* out) {
        CableSection s = before;
        const FedElement e = feed_step(s, law, 1, step.h, x.norm());
        s.length = e.length, s.follows = e.by_chord;
        if (out) cable_mean(s, from, step, Vec3::Zero(), x, *out);
        return cable_mean(s, from, step, Vec3::Zero(), x);
      };
      const Vec3 x(0.95, 0.52, -0.25), d(0.3, -0.4, 0.6);
      CablePull pull;
      mean(x, &pull);
      constexpr double e = 1e-5;
      const Vec3 slope = (8 * (mean(x + e * d, nullptr) - mean(x - e * d, nullptr)) -
                          (mean(x + 2 * e * d, nullptr) - mean(x - 2 * e * d, nullptr))) /
                         (12 * e);
      EXPECT_LT((slope - pull.k * d).norm(), 1e-8 * slope.norm());
    }
}

// Work of the ends and of what changes the length is the change of energy and what dampers take: exactly.
TEST(Feed, WorkAndEnergyAgree) {
  std::mt19937 g(7);
  std::uniform_real_distribution<double> u(-1, 1);
  const StiffnessTable table = rope();
  for (const StiffnessTable* t : {static_cast<const StiffnessTable*>(nullptr), &table})
    for (int i = 0; i < 400; ++i) {
      const CableSection s0{1 + 0.3 * u(g), 300, i % 2 ? 0.02 : 0, t, 0.01};
      CableSection s1 = s0;
      s1.length *= 1 + 0.2 * u(g);
      const Vec3 d0 = s0.length * (1.05 + 0.1 * u(g)) * Vec3(u(g), u(g), u(g)).normalized(),
                 d1 = s1.length * (1.05 + 0.1 * u(g)) * Vec3(u(g), u(g), u(g)).normalized();
      const CableStart from = cable_start(s0, Vec3::Zero(), d0, 0.02 * u(g));
      const CableStep step{0.1, 0.06};
      const auto energy = [](const CableSection& s, const Vec3& d) {
        return cable_stress(s, {Vec3::Zero(), d, Vec3::Zero(), Vec3::Zero()}).strain_energy;
      };
      const CableLoss lost = cable_loss(s1, from, step, Vec3::Zero(), d1);
      const double work = cable_mean(s1, from, step, Vec3::Zero(), d1).dot(d1 - d0) + lost.fed;
      EXPECT_NEAR(work, energy(s1, d1) - energy(s0, d0) + lost.damped + lost.filtered, 1e-9);
      EXPECT_GE(lost.damped, 0);
    }
}

TEST(Feed, ItsLengthIsTheIntegralOfItsSpeed) {
  model::Feed f;
  f.speed = {{1, 0.5}, {3, -1}, {4, 2}};
  double sum = 0;
  constexpr double h = 1e-4;
  for (int i = 0; i < 60000; ++i) {
    sum += h * model::fed_by(f, (i + 0.5) * h).speed;
    if (i % 5000 == 0) {
      const model::Fed at = model::fed_by(f, (i + 1) * h);
      EXPECT_NEAR(at.length, sum, 1e-6);
      EXPECT_NEAR(at.acceleration, (model::fed_by(f, (i + 1) * h + 1e-6).speed - at.speed) / 1e-6, 1e-6);
    }
  }
  EXPECT_EQ(model::fed_by(f, 0.5).speed, 0.5);
  EXPECT_EQ(model::fed_by(f, 10).speed, 2);
}

}  // namespace
}  // namespace hawser::test::feed_test
