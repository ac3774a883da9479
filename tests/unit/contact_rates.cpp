// Derivative of contact forces along a line against differences, and slips between two points of the line.
#include "hawser/kernels/contact_rates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hawser/terms/previous_slip.hpp"

namespace hawser::contact_rates_test {
namespace {

// A curved line over a sphere of radius 2, with all arguments of contact varying along it.
struct Place {
  ContactStart start;
  ContactTrial trial;
};

struct Situation {
  std::string name;
  double axial = 0.3, lateral = 0.3, stiffness = 0, slip = 1e-4, before = -1e-3;
  double blend = 0;    // m/s
  double damping = 0;  // sqrt(kg)
  double peak = 0;     // N
};

Place at(const Situation& s, double xi) {
  const double ball = 2, radius = 0.1;
  Place p;
  p.trial.point = Vec3(0.3 + 0.4 * xi, -0.2 + 0.1 * xi * xi, 2.04 - 0.06 * xi);
  const double r = p.trial.point.norm();
  p.trial.gap = r - ball - radius;
  p.trial.normal = p.trial.point / r;
  p.trial.curvature = (Mat3::Identity() - p.trial.normal * p.trial.normal.transpose()) / r;
  p.trial.step = 0.01;
  p.trial.velocity = Vec3(0.1 + 0.3 * xi, 0.2 * xi * xi, -0.4 + 0.1 * xi);
  p.start.point = p.trial.point + s.slip * Vec3(2 - xi, 1 + 2 * xi, 0.4 * xi * xi);
  p.start.gap = s.before + 2e-3 * (s.before > 0) * xi;
  p.start.tangent = Vec3(0.4 + 0.2 * xi, 0.2 * xi + 0.1, 0.1 - 0.2 * xi).normalized();
  if (s.before > 0) return p;
  const Vec3 na = Vec3(0.2, -0.1, 1).normalized();
  const Vec3 nb = Vec3(0.3, 0.1, 1).normalized();
  const Vec3 a = s.slip * na.cross(Vec3(1, 2, 0));
  const Vec3 b = s.slip * nb.cross(Vec3(2, -1, 0.5));
  const SlipBetween m = slip_between(a, na, b, nb, xi, false);
  p.start.slip = m.slip;
  p.start.normal = m.normal;
  p.start.peak = s.peak * (1 + 0.3 * xi);
  return p;
}

template <class F>
Vec3 difference(F f, double xi, double e) {
  return (8 * (f(xi + e) - f(xi - e)) - (f(xi + 2 * e) - f(xi - 2 * e))) / (12 * e);
}

TEST(ContactAlong, DerivativeOfTheForce) {
  const Situation all[] = {{"smooth", 0, 0},
                           {"sticks"},
                           {"slides", 0.3, 0.3, 0, 0.05},
                           {"sticks, anisotropic", 0.3, 0.6},
                           {"slides, anisotropic", 0.3, 0.6, 0, 0.05},
                           {"spring sticks", 0.3, 0.3, 2e4},
                           {"spring slides, anisotropic", 0.3, 0.6, 2e4, 0.2},
                           {"slides at a speed", 0.3, 0.3, 0, 0.05, -1e-3, 0.4},
                           {"slides at a speed, anisotropic", 0.3, 0.6, 2e4, 0.2, -1e-3, 0.4},
                           {"sticks, damped", 0.3, 0.3, 0, 1e-5, -1e-3, 0, 0.5},
                           {"slides, damped", 0.3, 0.3, 2e4, 0.2, -1e-3, 0.4, 2},
                           {"sticks under more force", 0.3, 0.3, 0, 1e-4, -1e-3, 0, 0, 1000},
                           {"sticks under more force, damped", 0.3, 0.3, 0, 1e-5, -1e-3, 0, 0.5, 1000},
                           {"sticks under less force, anisotropic", 0.3, 0.6, 0, 1e-5, -1e-3, 0, 0, 4e4},
                           {"slides under less force", 0.3, 0.3, 0, 0.05, -1e-3, 0, 0, 4e4},
                           {"met in the step, sticks", 0.3, 0.3, 0, 1e-4, 0.02},
                           {"met in the step, slides, anisotropic", 0.3, 0.6, 0, 0.1, 0.02}};
  for (const Situation& s : all) {
    ContactLaw law;
    law.normal = {1e5, 1e-3, 300};
    law.friction.axial = s.axial;
    law.friction.lateral = s.lateral;
    law.friction.stiffness = s.stiffness;
    law.friction.blend_speed = s.blend;
    law.friction.damping = s.damping;
    law.friction.axial_kinetic = 0.5 * s.axial;
    law.friction.lateral_kinetic = 0.6 * s.lateral;
    law.friction.axial_length = law.friction.lateral_length = 2e-3;
    for (const double xi : {0.3, 0.55}) {
      const auto rate = [xi](auto value) {
        return difference([&](double x) -> Vec3 { return value(x); }, xi, 1e-3);
      };
      const Place p = at(s, xi);
      ContactRates by;
      by.point = rate([&](double x) { return at(s, x).trial.point; });
      by.velocity = rate([&](double x) { return at(s, x).trial.velocity; });
      by.start_point = rate([&](double x) { return at(s, x).start.point; });
      by.start_tangent = rate([&](double x) { return at(s, x).start.tangent; });
      by.start_slip = rate([&](double x) { return at(s, x).start.slip; });
      by.start_normal = rate([&](double x) { return at(s, x).start.normal; });
      by.start_peak = rate([&](double x) { return Vec3::Constant(at(s, x).start.peak); }).x();
      by.start_gap = rate([&](double x) { return Vec3::Constant(at(s, x).start.gap); }).x();
      const auto contact = [&](double x) {
        const Place q = at(s, x);
        return surface_contact(law, q.start, q.trial, false);
      };
      const ContactForce c = contact(xi);
      ASSERT_GT(c.along_normal.force, 0) << s.name;
      EXPECT_EQ(c.slides, s.name.find("slides") != std::string::npos) << s.name;
      const Vec3 expected = rate([&](double x) { return contact(x).force; });
      const Vec3 found = contact_force_along(law, p.start, p.trial, by);
      EXPECT_LT((found - expected).norm(), 1e-7 * expected.norm()) << s.name << " at " << xi;
      EXPECT_GT(expected.norm(), 1) << s.name;
      // The surface of a rotating sphere slips as well.
      const Vec3 turn(0.002, -0.001, 0.003);
      const auto ball = [&](double x) {
        Place q = at(s, x);
        q.trial.lever = 0.1;
        return ball_contact(law, q.start, q.trial, turn, false);
      };
      Place q = at(s, xi);
      q.trial.lever = 0.1;
      const Vec3 of_ball = rate([&](double x) { return ball(x).force; });
      EXPECT_LT((ball_force_along(law, q.start, q.trial, turn, by) - of_ball).norm(), 1e-7 * of_ball.norm())
          << s.name << " at " << xi;
    }
  }
  ContactTrial away;
  away.gap = 0.1;
  EXPECT_EQ(contact_force_along({}, {}, away, {}), Vec3(Vec3::Zero()));
}

TEST(ContactAlong, SlipBetweenPlaces) {
  const Vec3 na = Vec3(0.4, -0.1, 1).normalized();
  const Vec3 nb = Vec3(-0.3, 0.5, 1).normalized();
  const Vec3 a = na.cross(Vec3(1, 2, 0));
  const Vec3 b = nb.cross(Vec3(2, -1, 0.5));
  const auto between = [&](double t) { return slip_between(a, na, b, nb, t, true); };
  EXPECT_LT((between(0).slip - a).norm(), 1e-15);
  EXPECT_LT((between(1).slip - b).norm(), 1e-15);
  for (const double t : {0.1, 0.5, 0.8}) {
    const SlipBetween m = between(t);
    EXPECT_NEAR(m.normal.norm(), 1, 1e-15);
    EXPECT_NEAR(m.slip.dot(m.normal), 0, 1e-15);
    EXPECT_LT((m.slip - slip_between(a, na, b, nb, t, false).slip).norm(), 1e-15);
    EXPECT_LT((m.slip_by_t - difference([&](double x) { return between(x).slip; }, t, 1e-3)).norm(), 1e-9);
    EXPECT_LT((m.normal_by_t - difference([&](double x) { return between(x).normal; }, t, 1e-3)).norm(),
              1e-9);
  }
}

// Between points whose normal forces had different peaks P, the springs have the interpolated force P s, and
// not more than the interpolated energy (P s)²/(2 P). The derivatives are those of the interpolation.
TEST(ContactAlong, PreviousSlipUnderDifferentPeaks) {
  struct Point {
    double xi, from, to;
    Vec3 slip, normal;
    double peak;
  };
  const Vec3 n = Vec3::UnitZ();
  for (const double ratio : {0.0, 1.0, 3.0, 1000.0}) {
    const std::vector<Point> points{{0.2, 0, 1, {1e-3, 0, 0}, n, ratio * 10},
                                    {0.8, 0, 1, {2e-3, 1e-3, 0}, n, ratio > 0 ? 10.0 : 0.0}};
    const auto at = [&](double xi, ContactRates* rates) {
      ContactStart s;
      EXPECT_TRUE(previous_slip(points, xi, s, rates));
      return s;
    };
    for (const double t : {0.1, 0.5, 0.9}) {
      const double xi = 0.2 + 0.6 * t;
      ContactRates by;
      const ContactStart s = at(xi, &by);
      EXPECT_LT((at(xi, nullptr).slip - s.slip).norm(), 1e-18);
      const auto mean = [&](auto value) { return (1 - t) * value(points[0]) + t * value(points[1]); };
      for (int i = 0; i < 3; ++i) {
        const auto force = [&](const auto& p) { return (ratio > 0 ? p.peak : 1) * p.slip[i]; };
        EXPECT_NEAR(force(s), mean(force), 1e-14);
      }
      const auto energy = [](const auto& p) { return 0.5 * p.peak * p.slip.squaredNorm(); };
      EXPECT_LE(energy(s), mean(energy) * (1 + 1e-12));
      const Vec3 rate = difference([&](double x) { return at(x, nullptr).slip; }, xi, 1e-4);
      EXPECT_LT((by.start_slip - rate).norm(), 1e-5 * rate.norm() + 1e-12) << ratio << " at " << t;
      EXPECT_NEAR(by.start_peak, (points[1].peak - points[0].peak) / 0.6, 1e-9);
    }
  }
}

}  // namespace
}  // namespace hawser::contact_rates_test
