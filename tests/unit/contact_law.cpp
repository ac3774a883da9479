// Normal contact law: ramp, linear and cubic spring, damping and tables, against closed forms and
// differences; impact of a mass on it.
#include "hawser/kernels/contact_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hawser::contact_law_test {
namespace {

TEST(ContactLaw, RampAndLinearPart) {
  const NormalLaw law{2e5, 0.01, 0};
  EXPECT_EQ(normal_force(law, 0.01, -3).force, 0);
  EXPECT_DOUBLE_EQ(normal_force(law, 0, 0).force, 2e5 * 0.01 / 4);
  EXPECT_DOUBLE_EQ(normal_force(law, -0.01, 0).force, 2e5 * 0.01);
  EXPECT_DOUBLE_EQ(normal_force(law, -0.05, 0).force, 2e5 * 0.05);
  for (double knot : {-0.01, 0.01}) {  // potential, force and stiffness are continuous at the knots
    const NormalForce a = normal_force(law, knot - 1e-12, 0);
    const NormalForce b = normal_force(law, knot + 1e-12, 0);
    EXPECT_NEAR(a.potential, b.potential, 1e-8);
    EXPECT_NEAR(a.elastic, b.elastic, 1e-5);
    EXPECT_NEAR(a.by_gap, b.by_gap, 1e-4);
  }
}

TEST(ContactLaw, DerivativesAndPotential) {
  const NormalLaw law{2e5, 0.01, 700};
  for (double g : {0.006, 0.002, -0.006, -0.03})
    for (double v : {-0.3, 0.4}) {
      const double h = 1e-6;
      const NormalForce f = normal_force(law, g, v);
      ASSERT_GT(f.force, 0);
      const auto difference = [](double a, double b, double d) { return (a - b) / (2 * d); };
      const NormalForce gp = normal_force(law, g + h, v);
      const NormalForce gm = normal_force(law, g - h, v);
      const NormalForce vp = normal_force(law, g, v + h);
      const NormalForce vm = normal_force(law, g, v - h);
      EXPECT_NEAR(f.by_gap, difference(gp.force, gm.force, h), 1e-6 * 2e5);
      EXPECT_NEAR(f.by_rate, difference(vp.force, vm.force, h), 1e-6 * 700);
      EXPECT_NEAR(f.elastic, -difference(gp.potential, gm.potential, h), 1e-4);
    }
}

// F = k s + k₃ s³, continuous at the knots of the ramp.
TEST(ContactLaw, GrowsWithTheDepth) {
  NormalLaw law{2e5, 0.01, 0};
  law.cubic = 3e9;
  EXPECT_DOUBLE_EQ(normal_force(law, -0.05, 0).force, 2e5 * 0.05 + 3e9 * 0.05 * 0.05 * 0.05);
  for (double g : {-0.0100001, -0.0099999, 0.0099999, 0.004, -0.004, -0.03}) {
    const double h = 1e-8;
    const NormalForce f = normal_force(law, g, 0);
    const NormalForce p = normal_force(law, g + h, 0);
    const NormalForce m = normal_force(law, g - h, 0);
    EXPECT_NEAR(f.by_gap, (p.force - m.force) / (2 * h), 1e-6 * 1e6);
    EXPECT_NEAR(f.elastic, -(p.potential - m.potential) / (2 * h), 1e-4);
  }
  // A mass of 3 kg with 2 m/s stops at the depth q at which the energy is in the spring.
  const double k = stiffness_of_impact(law, 0, 3, 2);
  const double q2 = (k - 2e5) / (3 * 3e9);
  EXPECT_NEAR(2e5 * q2 / 2 + 3e9 * q2 * q2 / 4, 6, 1e-9);
  EXPECT_NEAR(stiffness_of_impact(law, 0.2, 3, 2), 2e5 + 9e9 * 0.04, 1);
}

TEST(ContactLaw, NeverPulls) {
  const NormalLaw law{2e5, 0.01, 700};
  for (double g = -0.02; g < 0.02; g += 1e-4)
    for (double v = -5; v < 5; v += 0.1) {
      const NormalForce f = normal_force(law, g, v);
      EXPECT_GE(f.force, 0);
      if (f.force == 0) {
        EXPECT_EQ(f.by_gap, 0);
        EXPECT_EQ(f.by_rate, 0);
      }
    }
}

// A tabulated law is zero for gaps, passes through its rows and is straight beyond; its slope and potential
// are compared with differences and an integral.
TEST(ContactLaw, Table) {
  const std::vector<ContactForceTable::Row> rows{{0.01, 500}, {0.02, 500}, {0.03, 4000}, {0.05, 5000}};
  const ContactForceTable table(rows);
  double last = 0, integral = 0;
  const double h = 1e-6;
  for (double p = 0; p < 0.08; p += h) {
    const ContactForceTable::Value v = table.at(p);
    const ContactForceTable::Value w = table.at(p + h);
    ASSERT_GE(w.force, v.force - 1e-9);
    // In the step across a row the second derivative jumps, hence the absolute tolerance.
    ASSERT_NEAR((w.force - v.force) / h, 0.5 * (v.slope + w.slope), 20 + 1e-3 * v.slope);
    ASSERT_LE(v.slope, table.largest_slope() * (1 + 1e-12));
    integral += 0.5 * h * (v.force + w.force);
    last = w.force;
    if (std::abs(p - 0.07) < h / 2) {
      EXPECT_NEAR(w.potential, integral, 1e-6 * integral);
    }
  }
  EXPECT_GT(last, 5000);
  EXPECT_EQ(table.at(-1e-9).force, 0);
  EXPECT_EQ(table.at(0).slope, 0);
  for (const auto& [p, f] : rows) EXPECT_NEAR(table.at(p).force, f, 1e-9);
  double steepest = 0;
  for (double p = 0; p < 0.05; p += 1e-6) steepest = std::max(steepest, table.at(p).slope);
  EXPECT_NEAR(steepest, table.largest_slope(), 1e-3 * steepest);

  const NormalLaw law{2 * table.largest_slope(), 0, 700, &table, 2};
  for (const double g : {-0.004, -0.025, -0.045, -0.06})
    for (const double v : {-0.3, 0.2}) {
      const double e = 1e-7;
      const NormalForce f = normal_force(law, g, v);
      ASSERT_GT(f.force, 0);
      EXPECT_NEAR(f.by_gap, (normal_force(law, g + e, v).force - normal_force(law, g - e, v).force) / (2 * e),
                  1e-5 * law.stiffness);
      EXPECT_NEAR(f.by_rate,
                  (normal_force(law, g, v + e).force - normal_force(law, g, v - e).force) / (2 * e),
                  1e-5 * 700);
      EXPECT_NEAR(f.elastic, 2 * table.at(-g).force, 1e-9);
    }
  EXPECT_EQ(normal_force(law, 1e-9, -3).force, 0);
}

TEST(ContactLaw, TableFaults) {
  const auto make = [](std::vector<ContactForceTable::Row> rows) { return ContactForceTable(rows); };
  EXPECT_NO_THROW(make({{0, 0}, {1, 1}}));
  EXPECT_THROW(make({}), std::invalid_argument);
  EXPECT_THROW(make({{0, 1}, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(make({{1, 1}, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(make({{1, 2}, {2, 1}}), std::invalid_argument);
  EXPECT_THROW(make({{1, 0}, {2, 0}}), std::invalid_argument);
  EXPECT_THROW(make({{1, -1}}), std::invalid_argument);
  EXPECT_THROW(make({{1, NAN}}), std::invalid_argument);
}

struct Bounce {
  double duration = 0, restitution = 0, force = 0;
};

// Impact of a free mass on the surface, integrated by RK4 with small steps; it ends where the force is zero,
// by interpolation.
Bounce bounce(const NormalLaw& law, double mass, double speed) {
  const double h = 1e-6;
  double g = law.smoothing > 0 ? law.smoothing : -1e-18;
  double v = -speed;
  Bounce b;
  double before = 1;
  for (int i = 0; i < 1000000; ++i) {
    const auto a = [&](double gap, double rate) { return normal_force(law, gap, rate).force / mass; };
    const double k1 = a(g, v);
    const double k2 = a(g + h / 2 * v, v + h / 2 * k1);
    const double k3 = a(g + h / 2 * (v + h / 2 * k1), v + h / 2 * k2);
    const double k4 = a(g + h * (v + h / 2 * k2), v + h * k3);
    const double v0 = v;
    g += h * (v + h / 6 * (k1 + k2 + k3));
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    const double force = normal_force(law, g, v).force;
    b.force = std::max(b.force, force);
    // The law is cut off at zero, so the force is extrapolated over the last step.
    const double raw = -law.stiffness * g - law.damping * v;
    if (v > 0 && (law.smoothing > 0 ? g >= law.smoothing : raw <= 0)) {
      const double part = law.smoothing > 0 ? 1 : before / (before - raw);
      b.duration = (i + part) * h;
      b.restitution = (v0 + part * (v - v0)) / speed;
      return b;
    }
    before = raw;
  }
  return b;
}

// Half a period of m = 50 kg on k = 1e5 N/m at 2 m/s, in closed form; with zeta = 0.1, until the force is
// zero.
TEST(ContactLaw, NodeImpact) {
  const Bounce elastic = bounce({1e5, 0, 0}, 50, 2);
  EXPECT_NEAR(elastic.duration, 0.07024814731040725, 1e-8);
  EXPECT_NEAR(elastic.restitution, 1, 1e-8);
  EXPECT_NEAR(elastic.force, 4472.13595499958, 1e-4);
  const Bounce damped = bounce({1e5, 0, contact_damping(0.1, 1e5, 50)}, 50, 2);
  EXPECT_NEAR(damped.duration, 0.0660998537272301, 1e-8);
  EXPECT_NEAR(damped.restitution, 0.7440793977217798, 1e-8);
  // A ramp of 2 % of the penetration changes little and conserves energy.
  const Bounce smooth = bounce({1e5, 1e-3, 0}, 50, 2);
  EXPECT_NEAR(smooth.restitution, 1, 1e-6);
  EXPECT_NEAR(smooth.duration, 0.0702, 1.5e-3);
}

}  // namespace
}  // namespace hawser::contact_law_test
