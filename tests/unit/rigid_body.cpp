#include "hawser/kernels/rigid_body.hpp"

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"
#include "support/difference.hpp"

namespace hawser::rigid_body_test {
namespace {

using test::slope;

RigidBodyData barge() {
  RigidBodyData b;
  b.mass = 3;
  b.inertia << 4, 0.3, -0.2, 0.3, 5, 0.1, -0.2, 0.1, 6;
  b.weight = Vec3(0, 0, -9);
  b.stiffness = Vec3(20, 30, 50);
  b.damping = Vec3(2, 3, 1);
  b.turning_stiffness = Vec3(40, 25, 35);
  b.turning_damping = Vec3(3, 4, 2);
  return b;
}

RigidBodyState state(const Vec6& u = Vec6::Zero(), const Vec6& rate = Vec6::Zero(),
                     const Vec6& second = Vec6::Zero()) {
  RigidBodyState s;
  s.x = Vec3(0.3, -0.2, 0.5) + u.head<3>();
  s.q = exp_so3(Vec3(0.7, -1.1, 0.9)) * exp_so3(u.tail<3>());
  s.v = Vec3(0.4, 0.1, -0.3) + rate.head<3>();
  s.w = Vec3(0.5, -0.6, 0.8) + rate.tail<3>();
  s.a = Vec3(0.2, 0.5, -0.1) + second.head<3>();
  s.alpha = Vec3(-0.4, 0.3, 0.7) + second.tail<3>();
  return s;
}

RigidPose resting() {
  RigidPose p;
  p.position = Vec3(0.1, 0.2, -0.1);
  p.rotation = exp_so3(Vec3(-0.2, 0.3, 0.4));
  p.velocity = Vec3(0.3, 0, 0.1);
  p.angular_velocity = Vec3(0.2, -0.1, 0.3);
  return p;
}

TEST(RigidBody, TangentsAreDerivatives) {
  const RigidBodyData b = barge();
  const RigidBodyResidual r = rigid_body(b, state(), resting());
  const Vec6 zero = Vec6::Zero();
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const Vec6 K = slope([&](const Vec6& u) { return rigid_body(b, state(u), resting()).f(); }, d);
    const Vec6 C = slope([&](const Vec6& u) { return rigid_body(b, state(zero, u), resting()).f(); }, d);
    const Vec6 M =
        slope([&](const Vec6& u) { return rigid_body(b, state(zero, zero, u), resting()).f(); }, d);
    EXPECT_LT((r.K * d - K).norm(), 1e-8 * r.K.norm()) << k;
    EXPECT_LT((r.C * d - C).norm(), 1e-8 * r.C.norm()) << k;
    EXPECT_LT((r.M * d - M).norm(), 1e-8 * r.M.norm()) << k;
  }
}

TEST(RigidBody, SpringsPullDownTheirEnergy) {
  RigidBodyData b = barge();
  b.weight.setZero();
  b.damping.setZero();
  b.turning_damping.setZero();
  RigidBodyState s = state();
  s.a.setZero();
  s.v.setZero();
  s.w.setZero();
  s.alpha.setZero();
  const RigidBodyResidual r = rigid_body(b, s, resting());
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const double e = 1e-3;
    const auto energy = [&](double z) { return rigid_body_strain(b, state(z * d), resting()); };
    EXPECT_NEAR((8 * (energy(e) - energy(-e)) - energy(2 * e) + energy(-2 * e)) / (12 * e), r.f()[k],
                1e-8 * r.f().norm());
  }
}

}  // namespace
}  // namespace hawser::rigid_body_test
