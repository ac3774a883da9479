// Water forces on a rigid body: derivatives against differences, potential, wetted fraction, symmetry.
#include "hawser/kernels/body_water.hpp"

#include <gtest/gtest.h>

#include "hawser/kernels/wetting.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/math/symmetric.hpp"
#include "support/difference.hpp"

namespace hawser::body_water_test {
namespace {

using test::slope;

BodyInWater module() {
  BodyInWater b;
  b.centre = Vec3(0.4, -0.3, 0.6);
  b.drag_centre = Vec3(-0.2, 0.5, 0.8);
  b.height = 3;
  b.buoyancy = 60;
  b.displaced_mass = 6;
  b.added = Vec3(3, 5, 9);
  b.drag = Vec3(2, 4, 7);
  return b;
}

RigidBodyState state(double z, const Vec6& u = Vec6::Zero(), const Vec6& rate = Vec6::Zero(),
                     const Vec6& second = Vec6::Zero()) {
  RigidBodyState s;
  s.x = Vec3(0.3, -0.2, z) + u.head<3>();
  s.q = exp_so3(Vec3(0.7, -1.1, 0.9)) * exp_so3(u.tail<3>());
  s.v = Vec3(0.4, 0.1, -0.3) + rate.head<3>();
  s.w = Vec3(0.5, -0.6, 0.8) + rate.tail<3>();
  s.a = Vec3(0.2, 0.5, -0.1) + second.head<3>();
  s.alpha = Vec3(-0.4, 0.3, 0.7) + second.tail<3>();
  return s;
}

// A height-dependent current at z.
Water sea(double z) {
  Water w;
  w.velocity = Vec3(1.1, -0.4, 0.3) + 0.2 * z * Vec3(1, 0.5, 0);
  w.by_height = 0.2 * Vec3(1, 0.5, 0);
  w.acceleration = Vec3(0.6, 0.2, -0.7);
  w.surface = 0.25;
  return w;
}

BodyWaterResidual residual(const BodyInWater& b, const RigidBodyState& s, bool tangent = false,
                           bool convex = false) {
  BodyWaterResidual r;
  body_water(b, s, sea(s.x.z() + (s.q * b.centre).z()), sea(s.x.z() + (s.q * b.drag_centre).z()), tangent,
             convex, r);
  return r;
}

// Partly wet, nearly dry, nearly wet and fully wet; for a body and for a part of a member.
TEST(BodyWater, TangentsAreDerivatives) {
  BodyInWater b = module();
  const Vec6 zero = Vec6::Zero();
  double worst = 0;
  for (const double z : {-0.6, 0.9, -1.9, -8.0, -0.5, -8.1}) {
    b.cross_flow = z == -0.5 || z == -8.1;
    const BodyWaterResidual r = residual(b, state(z), true);
    EXPECT_GT(r.f.norm(), 0.1);
    for (int k = 0; k < 6; ++k) {
      const Vec6 d = Vec6::Unit(k);
      const Vec6 K = slope([&](const Vec6& u) { return residual(b, state(z, u)).f; }, d);
      const Vec6 C = slope([&](const Vec6& u) { return residual(b, state(z, zero, u)).f; }, d);
      const Vec6 M = slope([&](const Vec6& u) { return residual(b, state(z, zero, zero, u)).f; }, d);
      for (const auto& [J, by] : {std::pair{r.K, K}, {r.C, C}, {r.M, M}})
        worst = std::max(worst, (J * d - by).norm() / J.norm());
    }
  }
  printf("body in water: tangents %.1e off\n", worst);
  EXPECT_LT(worst, 1e-8);
}

TEST(BodyWater, BuoyancyPullsDownItsPotential) {
  BodyInWater b = module();
  b.added.setZero();
  b.drag.setZero();
  const Water calm;
  for (const double z : {-0.6, 0.9, -1.9, -8.0, 4.0}) {
    BodyWaterResidual r;
    body_water(b, state(z), calm, calm, false, false, r);
    for (int k = 0; k < 6; ++k) {
      const Vec6 d = Vec6::Unit(k);
      const double e = 1e-3;
      const auto energy = [&](double by) { return body_water_potential(b, state(z, by * d), 0); };
      EXPECT_NEAR((8 * (energy(e) - energy(-e)) - energy(2 * e) + energy(-2 * e)) / (12 * e), r.f[k], 1e-7);
    }
  }
}

// The stiffness that statics uses far from the solution must not be negative.
TEST(BodyWater, ConvexPartIsNotNegative) {
  for (const double z : {-0.6, 0.9, -1.9, -8.0}) {
    const Mat6 K = residual(module(), state(z), true, true).K;
    EXPECT_LT((K - K.transpose()).norm(), 1e-12 * (1 + K.norm()));
    EXPECT_GT(eigenpairs(K).values[0], -1e-10);
  }
}

// The force on a body with equal axes is independent of its rotation and equals the closed form of drag,
// added mass and buoyancy.
TEST(BodyWater, RoundBodyHasNoAxes) {
  BodyInWater b = module();
  b.centre.setZero();
  b.drag_centre.setZero();
  b.added.setConstant(4);
  b.drag.setConstant(3);
  RigidBodyState s = state(-8);
  RigidBodyState other = s;
  other.q = exp_so3(Vec3(-0.4, 0.8, 1.7));
  EXPECT_LT((residual(b, s).f - residual(b, other).f).norm(), 1e-12);
  const Vec3 u = sea(-8).velocity - s.v;
  const Vec3 a = sea(-8).acceleration;
  const Vec3 force = 3 * u.norm() * u + (6 + 4) * a - 4 * s.a + 60 * Vec3::UnitZ();
  EXPECT_LT((residual(b, s).f.head<3>() + force).norm(), 1e-12);
}

// Cross-flow principle: flow along a member does not increase the drag across it.
TEST(BodyWater, CrossFlow) {
  BodyInWater b;
  b.drag = Vec3(3, 3, 0.5);
  b.cross_flow = true;
  EXPECT_LT((body_drag(b, Vec3(0.6, -0.8, 7)) - Vec3(1.8, -2.4, 24.5)).norm(), 1e-14);
  EXPECT_LT((body_drag(b, Vec3(0, 0, -2)) - Vec3(0, 0, -2)).norm(), 1e-14);
}

TEST(BodyWater, EvenWetting) {
  for (double u = -1.3; u < 1.3; u += 0.0371) {
    const double e = 1e-5;
    EXPECT_NEAR((even_wetting(u + e).fraction - even_wetting(u - e).fraction) / (2 * e),
                even_wetting(u).slope, 1e-5);
    EXPECT_NEAR((even_wetting(u + e).integral - even_wetting(u - e).integral) / (2 * e),
                even_wetting(u).fraction, 1e-5);
    EXPECT_NEAR(even_wetting(u).fraction + even_wetting(-u).fraction, 1, 1e-15);
  }
  EXPECT_NEAR(even_wetting(-0.89).fraction, 0.055, 1e-15);
  EXPECT_NEAR(even_wetting(0.3).fraction, 0.65, 1e-15);
  EXPECT_EQ(even_wetting(-1.1).integral, 0);
  EXPECT_NEAR(even_wetting(1.0999999).integral, 1.0999999, 1e-12);
}

}  // namespace
}  // namespace hawser::body_water_test
