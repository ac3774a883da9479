// Law of contact of a point with a surface: tangents, rotation with the body, and transport of the slip.
#include "hawser/kernels/surface_contact_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "hawser/math/so3.hpp"

namespace hawser::volume_contact_test {
namespace {

// Distance field of a sphere of radius 2 about the origin minus a line radius of 0.1, or of the plane z = 0.
ContactTrial on_sphere(const Vec3& y, const Vec3& u) {
  ContactTrial t;
  const double r = y.norm();
  t.point = y;
  t.velocity = u;
  t.gap = r - 2.1;
  t.normal = y / r;
  t.curvature = (Mat3::Identity() - t.normal * t.normal.transpose()) / r;
  return t;
}
ContactTrial on_plane(const Vec3& y, const Vec3& u) { return {y, u, y.z(), Vec3::UnitZ(), Mat3::Zero()}; }

using Field = std::function<ContactTrial(const Vec3&, const Vec3&)>;

struct Situation {
  const char* name;
  Field field;
  ContactStart start;
  Vec3 point;
  bool slides;
};

std::vector<Situation> situations() {
  const Vec3 n = Vec3(0.3, -0.4, 1).normalized();
  const Vec3 s = 2e-3 * n.cross(Vec3(1, 0.2, 0)).normalized();
  ContactStart touching{2.095 * n, -0.005, Vec3(1, 0.5, 0.2).normalized(), s, n};
  ContactStart away{2.12 * n, 0.02, Vec3(1, 0.5, 0.2).normalized(), Vec3::Zero(), Vec3::UnitZ()};
  ContactStart lighter = touching;  // the normal force has increased since
  lighter.peak = 3e3;
  ContactStart heavier = touching;
  heavier.peak = 1e4;
  ContactStart facet{
      {0, 0, -0.01}, -0.01, Vec3(1, 0.5, 0.2).normalized(), s, n};  // last step's facet was tilted
  return {{"stick", on_sphere, touching, 2.095 * n + Vec3(1e-3, 5e-4, -3e-4), false},
          {"slip", on_sphere, touching, 2.095 * n + Vec3(0.02, 0.03, -0.005), true},
          {"stick under more force", on_sphere, lighter, 2.095 * n + Vec3(1e-3, 5e-4, -3e-4), false},
          {"stick under less force", on_sphere, heavier, 2.095 * n + Vec3(2e-4, 1e-4, -3e-4), false},
          {"slip under less force", on_sphere, heavier, 2.095 * n + Vec3(0.02, 0.03, -0.005), true},
          {"in the ramp", on_sphere, touching, 2.1005 * n + Vec3(1e-4, 2e-4, 0), false},
          {"first touch", on_sphere, away, 2.095 * n + Vec3(3e-3, -2e-3, 1e-4), false},
          {"first touch, slip", on_sphere, away, 2.095 * n + Vec3(-0.06, 0.08, 0.04), true},
          {"facet change", on_plane, facet, {5e-4, 1e-3, -0.008}, false},
          {"facet change, slip", on_plane, facet, {0.05, 0.03, -0.008}, true}};
}

std::vector<ContactLaw> laws() {
  static const std::vector<ContactForceTable::Row> rows{{0.003, 1000}, {0.006, 3500}, {0.02, 30000}};
  static const ContactForceTable table(rows);
  const NormalLaw normal{1e6, 1e-3, 2e3};
  const NormalLaw by_table{table.largest_slope(), 0, 2e3, &table};
  std::vector<ContactLaw> out;
  for (const NormalLaw& n : {normal, by_table}) {
    out.push_back({n, {}});
    for (const FrictionReturn return_rule : {FrictionReturn::radial, FrictionReturn::associated})
      for (const double speed : {0.0, 0.3}) {
        std::vector<FrictionLaw> f{{0.4, 0.4, 3e5, 0, 0},
                                   {0.3, 0.8, 3e5, 0, 0},
                                   {0.4, 0.4, 0, 0.006, 0.006},
                                   {0.3, 0.8, 0, 0.005, 0.009},
                                   {0.3, 0.8, 0, 0.005, 0.009}};
        f.back().spring = FrictionSpring::michalopoulos;
        for (FrictionLaw& law : f) {
          law.return_rule = return_rule;
          law.blend_speed = speed;
          law.axial_kinetic = 0.6 * law.axial;
          law.lateral_kinetic = 0.6 * law.lateral;
          out.push_back({n, law});
        }
      }
  }
  return out;
}

// Taylor test: |F(y + h d) - F(y) - h K d| falls as h², and the fourth-order difference agrees with K d.
void expect_tangent(const std::function<Vec3(const Vec3&)>& F, const Mat3& K, double size,
                    const std::string& what) {
  for (const Vec3& d : {Vec3(0.5, 0.7, -0.4), Vec3(-0.8, 0.1, 0.5), Vec3(0.1, -0.9, -0.3)}) {
    const double h = 2e-4 * size;
    const Vec3 difference = (8 * (F(h * d) - F(-h * d)) - (F(2 * h * d) - F(-2 * h * d))) / (12 * h);
    EXPECT_LT((difference - K * d).norm(), 1e-7 * (K.norm() + 1)) << what;
    const double e1 = (F(4 * h * d) - F(Vec3::Zero()) - 4 * h * K * d).norm();
    const double e2 = (F(2 * h * d) - F(Vec3::Zero()) - 2 * h * K * d).norm();
    if (e2 > 1e-9 * K.norm() * h) {
      EXPECT_GT(e1 / e2, 3.5) << what;
    }
  }
}

TEST(VolumeContactKernel, TangentIsExact) {
  const Vec3 u(0.3, -0.2, -0.15);
  for (const ContactLaw& law : laws())
    for (const Situation& s : situations()) {
      const ContactForce c = surface_contact(law, s.start, s.field(s.point, u), true);
      if (law.normal.table && s.field(s.point, u).gap >= 0) continue;  // a table has no ramp before contact
      ASSERT_GT(c.along_normal.force, 0) << s.name;
      // Mobilisation laws are limited by a length, spring laws by a force; each situation is made for one of
      // them.
      if (law.friction.active() && std::string(s.name).find("slip") != std::string::npos) {
        EXPECT_TRUE(c.slides) << s.name;
      }
      expect_tangent(
          [&](const Vec3& d) { return surface_contact(law, s.start, s.field(s.point + d, u), false).force; },
          c.by_point, 0.02, std::string(s.name) + " by point");
      expect_tangent(
          [&](const Vec3& d) { return surface_contact(law, s.start, s.field(s.point, u + d), false).force; },
          c.by_velocity, 1, std::string(s.name) + " by velocity");
      EXPECT_LT((c.force - surface_contact(law, s.start, s.field(s.point, u), false).force).norm(),
                1e-14 * c.force.norm());
    }
}

TEST(VolumeContactKernel, TurnsWithTheBody) {
  const Quat Q = exp_so3({0.7, -1.1, 0.4});
  const Mat3 R = Q.toRotationMatrix();
  for (const ContactLaw& law : laws())
    for (const Situation& s : situations()) {
      const ContactTrial t = s.field(s.point, {0.3, -0.2, -0.15});
      const ContactStart a = s.start;
      const ContactForce plain = surface_contact(law, a, t, true);
      const ContactStart turned_start{R * a.point, a.gap, R * a.tangent, R * a.slip, R * a.normal, a.peak};
      const ContactForce turned = surface_contact(
          law, turned_start,
          {R * t.point, R * t.velocity, t.gap, R * t.normal, R * t.curvature * R.transpose()}, true);
      EXPECT_LE((turned.force - R * plain.force).norm(), 1e-12 * plain.force.norm()) << s.name;
      EXPECT_LT((turned.slip - R * plain.slip).norm(), 1e-15) << s.name;
      EXPECT_LE((turned.by_point - R * plain.by_point * R.transpose()).norm(), 1e-11 * plain.by_point.norm())
          << s.name;
    }
}

TEST(VolumeContactKernel, FacetChangeKeepsTheSlip) {
  const ContactLaw law{{1e6, 0, 0}, {0.9, 0.9, 1e5, 0, 0}};
  const Vec3 n(0, std::sin(0.2), std::cos(0.2));
  const Vec3 s(3e-3, 0, 0);  // along the edge between the facets: the direction does not change
  const ContactStart start{{0, 0, -0.01}, -0.01, Vec3::UnitX(), s, n};
  const ContactForce c = surface_contact(law, start, on_plane({0, 0, -0.01}, Vec3::Zero()), false);
  EXPECT_LT((c.slip - s).norm(), 1e-16);
  const ContactStart across{{0, 0, -0.01}, -0.01, Vec3::UnitX(), n.cross(Vec3(3e-3, 0, 0)), n};
  const ContactForce d = surface_contact(law, across, on_plane({0, 0, -0.01}, Vec3::Zero()), false);
  EXPECT_LT((d.slip - Vec3(0, 3e-3, 0)).norm(), 1e-16);  // rotated, not shortened
}

// Friction with mobilisation lengths, under a normal force that varies while the point moves back and forth
// along the surface, receives energy: what it has received is never less than the energy of its spring. A
// spring that follows the normal force down and up would return more than it received, 0.5 (10 N - N) mu s²/d
// in each turn of the first path.
TEST(VolumeContactKernel, FrictionUnderVaryingForceGeneratesNoEnergy) {
  struct Point {
    double depth, place;  // m
  };
  std::vector<Point> turn{{1e-3, 0}, {1e-3, 1e-3}, {1e-2, 1e-3}, {1e-2, 0}, {1e-3, 0}};
  std::vector<Point> any;
  for (int i = 0; i < 3000; ++i)
    any.push_back(
        {1e-3 + 9e-3 * std::abs(std::sin(1.7 * i)), 4e-3 * std::sin(0.9 * i) * std::cos(0.013 * i)});
  int count = 0;
  for (const FrictionReturn return_rule : {FrictionReturn::radial, FrictionReturn::associated})
    for (const auto& [lateral, blend_speed] : {std::pair{0.4, 0.0}, {0.8, 0.0}, {0.4, 0.1}, {0.8, 0.1}})
      for (const std::vector<Point>& path : {turn, any}) {
        FrictionLaw friction{0.4, lateral, 0, 5e-3, 5e-3 * lateral / 0.4, return_rule};
        friction.axial_kinetic = friction.lateral_kinetic = 0.1;
        friction.blend_speed = blend_speed;
        const ContactLaw law{{1e6, 0, 0}, friction};
        ContactStart start{{0, 0, -path[0].depth}, -path[0].depth, Vec3(1, 1, 0).normalized()};
        double received = 0;
        for (int round = 0; round < 5; ++round)
          for (const Point& p : path) {
            const Vec3 y(p.place, 0, -p.depth);
            const Vec3 u(0.1 * (count++ % 3), 0, 0);
            const ContactForce c = surface_contact(law, start, on_plane(y, u), false);
            received -= c.friction.dot(y - start.point);
            EXPECT_GE(received, -0.5 * c.friction.dot(c.slip) - 1e-12);
            start.point = y;
            start.gap = -p.depth;
            start.slip = c.slip;
            start.peak = c.peak;
          }
      }
}

// Far above the blend speed the weight exp(-(v/v0)²) of the coefficients at rest is below all numbers.
TEST(VolumeContactKernel, FastSlidingWithoutKineticFriction) {
  for (const FrictionSpring spring : {FrictionSpring::elliptic, FrictionSpring::michalopoulos})
    for (const double lateral : {0.4, 0.8})
      for (const double speed : {0.5, 2.0, 2.5, 10.0}) {
        FrictionLaw friction{0.4, lateral, 0, 5e-3, 5e-3};
        friction.spring = spring;
        friction.blend_speed = 0.1;
        ContactStart start{{0, 0, -1e-3}, -1e-3, Vec3(1, 1, 0).normalized()};
        start.slip = Vec3(1e-3, 0, 0);
        start.peak = 800;
        const ContactForce c = surface_contact({{1e6, 0, 0}, friction}, start,
                                               on_plane({0.1, 0.02, -1e-3}, {speed, 0, 0}), true);
        EXPECT_LT(c.friction.norm(), 1e-7) << speed;
        EXPECT_TRUE(c.by_point.allFinite()) << speed;
        EXPECT_TRUE(c.by_velocity.allFinite()) << speed;
      }
}

// The spring keeps its force when the normal force increases, and slides when it decreases below what holds
// it.
TEST(VolumeContactKernel, FrictionUnderVaryingForce) {
  const ContactLaw law{{1e6, 0, 0}, {0.4, 0.4, 0, 5e-3, 5e-3}};
  ContactStart start{{0, 0, -1e-3}, -1e-3, Vec3::UnitX()};
  const auto force = [&](double x, double depth) {
    const Vec3 y(x, 0, -depth);
    const ContactForce c = surface_contact(law, start, on_plane(y, Vec3::Zero()), false);
    start.point = y;
    start.gap = -depth;
    start.slip = c.slip;
    start.peak = c.peak;
    return c.friction.x();
  };
  EXPECT_NEAR(force(1e-3, 1e-3), -80, 1e-9);     // 0.4 N s/d, N = 1 kN
  EXPECT_NEAR(force(1e-3, 4e-3), -80, 1e-9);     // N = 4 kN
  EXPECT_NEAR(force(2e-3, 4e-3), -400, 1e-9);    // and 320 N/mm from there on
  EXPECT_NEAR(force(2e-3, 2e-3), -400, 1e-9);    // 0.4 N = 800 N still hold it
  EXPECT_NEAR(force(2e-3, 5e-4), -200, 1e-9);    // slides
  EXPECT_NEAR(force(1.9e-3, 5e-4), -168, 1e-9);  // 320 N/mm
  EXPECT_NEAR(force(1.9e-3, 1e-3), -168, 1e-9);
}

// Only the motion after the first contact counts: half of it if contact begins half way.
TEST(VolumeContactKernel, FirstTouch) {
  const ContactLaw law{{1e6, 0, 0}, {0.9, 0.9, 1e5, 0, 0}};
  const ContactStart start{{0, 0, 0.01}, 0.01, Vec3::UnitX(), Vec3::Zero(), Vec3::UnitZ()};
  const ContactForce c = surface_contact(law, start, on_plane({4e-3, 0, -0.01}, Vec3::Zero()), false);
  EXPECT_LT((c.slip - Vec3(2e-3, 0, 0)).norm(), 1e-17);
  EXPECT_LT((c.force - Vec3(-200, 0, 1e4)).norm(), 1e-9);
}

}  // namespace
}  // namespace hawser::volume_contact_test
