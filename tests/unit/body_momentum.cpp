// Inertia from the change of momenta over a step: derivatives, limit of short steps, conservation for a free
// body.
#include "hawser/kernels/body_momentum.hpp"

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"
#include "support/difference.hpp"

namespace hawser::body_momentum_test {
namespace {

using test::slope;

RigidBodyData body(bool coupled) {
  RigidBodyData b;
  b.mass = 3;
  b.inertia << 4, 0.3, -0.2, 0.3, 5, 0.1, -0.2, 0.1, 6;
  for (int i = 0; coupled && i < 6; ++i)
    for (int j = 0; j < 6; ++j) b.coupled(i, j) = std::cos(1.0 + i + j + 0.3 * i * j);
  return b;
}

RigidBodyState start() {
  RigidBodyState s;
  s.x = Vec3(0.3, -0.2, 0.5);
  s.q = exp_so3(Vec3(0.7, -1.1, 0.9));
  s.v = Vec3(0.4, 0.1, -0.3);
  s.w = Vec3(0.5, -0.6, 0.8);
  s.a = Vec3(0.2, 0.5, -0.1);
  s.alpha = Vec3(-0.4, 0.3, 0.7);
  return s;
}

// State after a time h of constant accelerations; R' = R w^ with (w0 x alpha) h³/12 of Magnus' series.
RigidBodyState after(double h, const Vec6& u = Vec6::Zero(), const Vec6& rate = Vec6::Zero()) {
  RigidBodyState s = start();
  s.x += h * s.v + 0.5 * h * h * s.a + u.head<3>();
  s.q = s.q * exp_so3(Vec3(h * s.w + 0.5 * h * h * s.alpha + h * h * h / 12 * s.w.cross(s.alpha))) *
        exp_so3(u.tail<3>());
  s.v += h * s.a + rate.head<3>();
  s.w += h * s.alpha + rate.tail<3>();
  return s;
}

MomentumForces carried() {
  MomentumForces f;
  f.q << 1, -2, 3, 0.5, 2, -1;
  f.f << 0.4, 1, -2, 1.5, -0.7, 0.9;
  return f;
}

TEST(BodyMomentum, TangentsAreDerivatives) {
  constexpr double h = 0.4;
  for (const double rho : {1.0, 0.8, 0.0})
    for (const bool coupled : {false, true}) {
      const Mat6 N = momentum_matrix(body(coupled));
      const MeanWeights scheme{AlphaCoefficients(rho)};
      const auto of = [&](const RigidBodyState& s) {
        RigidBodyResidual r;
        add_momentum(N, scheme, h, start(), carried(), s, r);
        return r;
      };
      const RigidBodyResidual r = of(after(h));
      const Vec6 zero = Vec6::Zero();
      for (int k = 0; k < 6; ++k) {
        const Vec6 d = Vec6::Unit(k);
        const Vec6 K = slope([&](const Vec6& u) { return of(after(h, u)).f(); }, d);
        const Vec6 C = slope([&](const Vec6& u) { return of(after(h, zero, u)).f(); }, d);
        EXPECT_LT((r.K * d - K).norm(), 1e-8 * r.K.norm()) << k << (coupled ? " coupled" : "");
        EXPECT_LT((r.C * d - C).norm(), 1e-8 * r.C.norm()) << k << (coupled ? " coupled" : "");
      }
      EXPECT_EQ(r.M.norm(), 0);
    }
}

// In short steps it equals the inertia by accelerations at the end to second order, because the scheme is the
// trapezoidal rule and the rates at the start are known.
TEST(BodyMomentum, ShortStepsHaveTheInertiaOfTheAccelerations) {
  for (const bool coupled : {false, true}) {
    const RigidBodyData b = body(coupled);
    double before = 0;
    for (const double h : {0.02, 0.01}) {
      MomentumForces from;
      from.q = from.f = momentum_rate(b, start());
      const RigidBodyState end = after(h);
      RigidBodyResidual r = rigid_body(without_momentum(b), end, {});
      add_momentum(momentum_matrix(b), MeanWeights{AlphaCoefficients(1)}, h, start(), from, end, r);
      const Vec6 exact = rigid_body(b, end, {}).f();
      const double off = (r.f() - exact).norm() / exact.norm();
      EXPECT_LT(off, 1e-3);
      if (before > 0) {
        EXPECT_NEAR(before / off, 4, 0.2);
      }
      before = off;
    }
  }
}

// At any end of a step the change of momenta about a fixed point equals the transmitted forces and moments,
// at rho = 1 by the trapezoidal rule.
TEST(BodyMomentum, WhatIsCarriedIsTheChange) {
  const RigidBodyData b = body(true);
  const Mat6 N = momentum_matrix(b);
  constexpr double h = 0.3;
  const RigidBodyState end = after(h, (Vec6() << 0.1, 0.2, -0.3, 0.2, -0.1, 0.3).finished());
  const MeanWeights scheme{AlphaCoefficients(1)};
  MomentumForces from = carried();
  from.q = from.f;
  MomentumForces to = from;
  advance_momentum(N, scheme, h, start(), end, to);
  RigidBodyResidual r;
  add_momentum(N, scheme, h, start(), from, end, r);
  const auto about_origin = [](Wrench of, const Vec3& x) {
    of.tail<3>() += x.cross(of.head<3>());
    return of;
  };
  const Vec6 change =
      about_origin(body_momentum(N, end), end.x) - about_origin(body_momentum(N, start()), start().x);
  const Vec6 mean = 0.5 * (about_origin(from.f, start().x) + about_origin(to.f, end.x));
  EXPECT_LT((change - h * mean).norm(), 1e-13 * change.norm());
  Vec6 f = r.f();
  f.tail<3>() = end.q * Vec3(f.tail<3>());
  EXPECT_LT((f - to.f).norm(), 1e-12 * f.norm());
}

}  // namespace
}  // namespace hawser::body_momentum_test
