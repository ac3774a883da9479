// Springs and dampers between two points: tension and energy by definition, and tangent of the force.
#include "hawser/kernels/link.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace hawser::test::link_test {
namespace {

using Rows = std::vector<MonotoneCubic::Row>;

// Linear links and links by tables, each with and without slack.
struct Named {
  std::string name;
  LinkLaw law;
};
std::vector<Named> laws() {
  std::vector<Named> all;
  for (const bool slack : {false, true})
    for (const bool tables : {false, true}) {
      LinkLaw l;
      l.rest_length = 2;
      l.tension_only = slack;
      l.stiffness = tables ? 0 : 500;
      l.damping = tables ? 0 : 60;
      if (tables) {
        l.spring = std::make_shared<MonotoneCubic>(Rows{{-0.1, 5}, {0.2, 100}, {0.5, 120}, {0.9, 400}},
                                                   std::nullopt, 0.1);
        l.damper = std::make_shared<ResponseCurve>(Rows{{0.3, 20}, {1, 90}}, true);
      }
      all.push_back({std::string(tables ? "tables" : "linear") + (slack ? ", slack" : ""), l});
    }
  return all;
}

// Simpson's rule.
template <class F>
double integral(F f, double from, double to) {
  constexpr int n = 20000;
  double sum = 0;
  for (int i = 0; i <= n; ++i) sum += (i % n == 0 ? 1 : i % 2 ? 4 : 2) * f(from + (to - from) * i / n);
  return sum * (to - from) / (3 * n);
}

TEST(Link, TensionByDefinition) {
  LinkLaw l;
  l.rest_length = 2;
  l.stiffness = 500;
  l.damping = 60;
  EXPECT_DOUBLE_EQ(link_tension(l, 2.5, 1).tension, 310);
  EXPECT_DOUBLE_EQ(link_tension(l, 1.5, 1).tension, -190);
  l.tension_only = true;
  EXPECT_DOUBLE_EQ(link_tension(l, 2.5, 1).tension, 310);
  EXPECT_DOUBLE_EQ(link_tension(l, 1.95, 1).tension,
                   35);  // the link becomes taut at a speed at which the damper is already in tension
  EXPECT_EQ(link_tension(l, 1.5, 1).tension, 0);
  EXPECT_EQ(link_tension(l, 2.1, -1).tension, 0);  // closes faster than the spring can pull
  for (const Named& n : laws()) {
    if (!n.law.spring) continue;
    for (const auto& [e, T] : {std::pair{-0.1, 5.0}, {0.2, 100.0}, {0.9, 400.0}})
      EXPECT_NEAR(link_tension(n.law, 2 + e, 0).tension, T, 1e-12) << n.name;
    EXPECT_NEAR(link_tension(n.law, 2.2, 0.3).tension, 120, 1e-12);
    EXPECT_NEAR(link_tension(n.law, 2.2, -0.3).tension, 80, 1e-12);
  }
}

// The spring stores the integral of its tension; the rest of the power is dissipated.
TEST(Link, EnergyAddsUp) {
  for (const auto& [name, law] : laws()) {
    const auto T = [&law = law](double length) { return link_tension(law, length, 0).tension; };
    const double stored = link_tension(law, 2.8, 0).energy - link_tension(law, 1.2, 0).energy;
    EXPECT_NEAR(integral(T, 1.2, 2.8), stored, 2e-4 * (1 + std::abs(stored))) << name;
    // The length oscillates, faster and slower than the time constant of the damper: input energy is stored
    // or dissipated.
    const auto length = [](double t) { return 2 + 0.7 * std::sin(3 * t) + 0.1 * t; };
    const auto speed = [](double t) { return 2.1 * std::cos(3 * t) + 0.1; };
    const double work = integral(
        [&, &law = law](double t) { return link_tension(law, length(t), speed(t)).tension * speed(t); }, 0,
        4);
    const double lost = integral(
        [&, &law = law](double t) { return link_tension(law, length(t), speed(t)).dissipated; }, 0, 4);
    const double kept = link_tension(law, length(4), 0).energy - link_tension(law, length(0), 0).energy;
    printf("  %-14s work %.3f J, stored %.3f J, lost %.3f J\n", name.c_str(), work, kept, lost);
    EXPECT_NEAR(work, kept + lost, 1e-4 * work) << name;
    for (double l = 0.1; l < 4; l += 0.03)
      for (double v = -3; v < 3; v += 0.07) EXPECT_GE(link_tension(law, l, v).dissipated, -1e-9) << name;
  }
}

TEST(Link, TangentAgainstDifferences) {
  double worst = 0;
  for (const auto& [name, law] : laws())
    for (const double size : {0.6, 1.03, 1.35}) {
      const Vec3 d = size * Vec3(1.4, -1.1, 0.9);
      const Vec3 w(0.5, 0.3, -0.8);
      const LinkForce f = link_force(law, d, w);
      constexpr double e = 1e-4;
      const auto slope = [&](auto at) -> Vec3 {
        return (8 * (at(e) - at(-e)) - (at(2 * e) - at(-2 * e))) / (12 * e);
      };
      for (int k = 0; k < 3; ++k) {
        const Vec3 by_place =
            slope([&, &law = law](double s) { return link_force(law, d + s * Vec3::Unit(k), w).pull; });
        const Vec3 by_rate =
            slope([&, &law = law](double s) { return link_force(law, d, w + s * Vec3::Unit(k)).pull; });
        worst = std::max(worst, (by_place - f.by_place.col(k)).norm() / (1 + f.by_place.norm()));
        worst = std::max(worst, (by_rate - f.by_rate.col(k)).norm() / (1 + f.by_rate.norm()));
      }
      EXPECT_TRUE(f.pull.cross(d).isZero(1e-9));
    }
  printf("  tangent of links: %.1e\n", worst);
  EXPECT_LT(worst, 1e-6);
}

// Without a rest length the tension of a linear spring is k d, also at zero distance.
TEST(Link, NoRestLength) {
  LinkLaw law;
  law.stiffness = 500;
  for (const Vec3& d : {Vec3(0, 0, 0), Vec3(1e-15, 0, 0), Vec3(1e-3, 2e-3, 0)}) {
    const LinkForce f = link_force(law, d, Vec3::Zero());
    EXPECT_TRUE(f.by_place.isApprox(500 * Mat3::Identity(), 1e-12));
    EXPECT_NEAR((f.pull - 500 * d).norm(), 0, 1e-9);
  }
}

}  // namespace
}  // namespace hawser::test::link_test
