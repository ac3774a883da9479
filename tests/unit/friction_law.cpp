#include "hawser/kernels/friction_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// The plane z = 0, line along x.
Friction<double> flat(const FrictionLaw& law, double N, double a, double l) {
  return friction<double>(law, N, {a, l, 0}, {0, 0, 1}, {1, 0, 0});
}

// N = 1000, mu = (0.3, 0.8), d = (0.01, 0.04): OMAE2006-92155 eqs (6)-(10) with radial return, own evaluation
// of the equations in double precision. The reference force resists: the opposite of the force on the point.
const FrictionLaw kPaper{0.3, 0.8, 0, 0.01, 0.04};

TEST(FrictionLaw, PaperFormula) {
  struct Row {
    double a, l, fa, fl;
  };
  const Row rows[] = {{0.002, 0, 60, 0},
                      {0, 0.01, 0, 200},
                      {0.01, 0, 300, 0},
                      {0, 0.04, 0, 800},
                      {0.006, 0, 180, 0},
                      {0.006, 0.03, 56.50901902147329, 753.4535869529773},
                      {0.002, 0.01, 18.836339673824433, 251.1511956509924},
                      {0.005, 0.02, 51.44957554275265, 548.7954724560284},
                      {0.007, 0.03, 68.16888468192553, 779.0729677934346},  // slides from here on
                      {0.02, 0.05, 111.41720290623111, 742.7813527082074},
                      {-0.003, 0.06, -14.981285083167672, 799.0018711022758}};
  for (const Row& r : rows) {
    const Friction<double> f = flat(kPaper, 1000, r.a, r.l);
    EXPECT_NEAR(f.force.x(), -r.fa, 1e-9);
    EXPECT_NEAR(f.force.y(), -r.fl, 1e-9);
    const double R = std::hypot(r.a / 0.01, r.l / 0.04);
    EXPECT_EQ(f.slides, R > 1);
    EXPECT_NEAR((f.slip * std::max(R, 1.0) - Vec3(r.a, r.l, 0)).norm(), 0, 1e-15);
  }
}

struct PathRow {
  double U[2], f[2], origin[2];
};

void expect_path(int increments, const std::vector<PathRow>& rows, double tolerance) {
  Vec3 slip = Vec3::Zero(), U = Vec3::Zero();
  for (const PathRow& row : rows) {
    const Vec3 d = (Vec3(row.U[0], row.U[1], 0) - U) / increments;
    Friction<double> f;
    for (int i = 0; i < increments; ++i) {
      f = friction<double>(kPaper, 1000, slip + d, {0, 0, 1}, {1, 0, 0});
      slip = f.slip;
    }
    U = {row.U[0], row.U[1], 0};
    EXPECT_NEAR(f.force.x(), -row.f[0], tolerance * 1000);
    EXPECT_NEAR(f.force.y(), -row.f[1], tolerance * 1000);
    EXPECT_NEAR(U.x() - slip.x(), row.origin[0], 0.01 * tolerance);
    EXPECT_NEAR(U.y() - slip.y(), row.origin[1], 0.01 * tolerance);
  }
}

TEST(FrictionLaw, PaperPathOneStepALeg) {
  expect_path(
      1,
      {{{0.006, 0}, {180, 0}, {0, 0}},
       {{0.006, 0.03}, {56.50901902147329, 753.4535869529773}, {0, 0}},
       {{0.02, 0.03}, {166.41005886756875, 665.6402354702749}, {0.010636708224309553, 0.01595506233646433}},
       {{-0.02, 0.03},
        {-272.70895009510326, 333.3848337605079},
        {-0.010065035816968009, 0.02544546523671805}},
       {{-0.02, -0.05},
        {-39.16708155928443, -793.152650448142},
        {-0.015339623229414533, -0.014609405010667063}},
       {{0, 0}, {217.23968167015445, 551.7288912845186}, {-0.009728053572052746, -0.009264965147713692}}},
      1e-12);
}

TEST(FrictionLaw, PaperPathTenStepsALeg) {
  expect_path(
      10,
      {{{0.006, 0}, {180, 0}, {0, 0}},
       {{0.006, 0.03}, {56.50901902147329, 753.4535869529773}, {0, 0}},
       {{0.02, 0.03}, {208.37374780541083, 575.53302815098}, {0.010319279769251627, 0.019973111498392666}},
       {{-0.02, 0.03},
        {-295.36980921964425, 140.01081359002268},
        {-0.010009859635122857, 0.02822418248661691}},
       {{-0.02, -0.05},
        {-24.25846431851841, -797.3802746891471},
        {-0.016913364989281785, -0.011953147975558652}},
       {{0, 0}, {223.50698124805086, 533.6307792780967}, {-0.009758533698585085, -0.008737065918102511}}},
      1e-12);
}

// Isotropic steady circle of radius rho: work per turn 2 pi rho mu N sqrt(1 - (d/rho)²).
TEST(FrictionLaw, SteadyCircle) {
  const FrictionLaw law{0.5, 0.5, 0, 0.01, 0.01};
  const double rho = 0.05, N = 1000;
  const int steps = 20000;
  Vec3 slip = Vec3::Zero(), force = Vec3::Zero();
  double work = 0;
  const auto at = [&](int i) {
    const double t = 2 * std::numbers::pi * i / steps;
    return Vec3(rho * std::cos(t), rho * std::sin(t), 0);
  };
  for (int i = 1; i <= 3 * steps; ++i) {
    const Vec3 d = at(i) - at(i - 1);
    const Friction<double> f = friction<double>(law, N, slip + d, {0, 0, 1}, {1, 0, 0});
    if (i > 2 * steps) work -= 0.5 * (f.force + force).dot(d);
    slip = f.slip;
    force = f.force;
  }
  EXPECT_NEAR(work, 153.9059796, 1e-3 * 153.9);
}

TEST(FrictionLaw, SpringsAndEllipse) {
  const FrictionLaw law{0.3, 0.8, 1e5, 0, 0};
  Friction<double> f = flat(law, 1000, 0.001, -0.002);  // sticks: 100 and 200 N are inside
  EXPECT_NEAR((f.force - Vec3(-100, 200, 0)).norm(), 0, 1e-10);
  EXPECT_FALSE(f.slides);
  f = flat(law, 1000, 0.005, 0.01);  // 500 and 1000 N: sqrt((5/3)² + (5/4)²) = 25/12
  EXPECT_NEAR((f.force - Vec3(-240, -480, 0)).norm(), 0, 1e-10);
  EXPECT_NEAR((f.slip - Vec3(0.0024, 0.0048, 0)).norm(), 0, 1e-15);
  EXPECT_TRUE(f.slides);
  f = flat({0.3, 0, 1e5, 0, 0}, 1000, 0.005, 0.01);  // no friction across
  EXPECT_NEAR((f.force - Vec3(-300, 0, 0)).norm(), 0, 1e-10);
  f = flat({0.3, 0.3, 1e5, 0, 0}, 1000, 0.003, 0.004);
  EXPECT_NEAR((f.force - Vec3(-180, -240, 0)).norm(), 0, 1e-10);
  EXPECT_EQ(flat(law, 0, 0.005, 0.01).force.norm(), 0);
}

// Both laws with equal lengths agree with the isotropic branch.
TEST(FrictionLaw, IsotropicIsTheLimit) {
  for (double s : {0.004, 0.03}) {
    const Friction<double> a = flat({0.4, 0.4, 0, 0.01, 0.01}, 700, s, 0.5 * s);
    const Friction<double> b = flat({0.4, 0.4 + 1e-13, 0, 0.01, 0.01}, 700, s, 0.5 * s);
    EXPECT_LT((a.force - b.force).norm(), 1e-8);
    const Friction<double> c = flat({0.4, 0.4, 3e4, 0, 0}, 700, s, 0.5 * s);
    const Friction<double> d = flat({0.4, 0.4 + 1e-13, 3e4, 0, 0}, 700, s, 0.5 * s);
    EXPECT_LT((c.force - d.force).norm(), 1e-8);
  }
}

TEST(FrictionLaw, SlipTurnsWithTheNormal) {
  const Vec3 from = Vec3(1, 2, -1).normalized(), to = Vec3(1, 1.5, 0.3).normalized();
  const Vec3 slip = 0.01 * from.cross(Vec3(0.3, -0.4, 1)).normalized();
  const Vec3 turned = transport_slip<double>(slip, from, to);
  EXPECT_NEAR(turned.dot(to), 0, 1e-16);
  EXPECT_LT((turned - minimal_rotation(from, to) * slip).norm(), 1e-16);
  EXPECT_LT((transport_slip<double>(slip, from, from) - slip).norm(), 1e-18);
  EXPECT_TRUE(transport_slip<double>(slip, from, -from).allFinite());
}

}  // namespace
}  // namespace hawser
