// Springs and dampers with full matrices to a moving support: tangents against differences, balance of
// powers.
#include "hawser/kernels/spring_matrices.hpp"

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"
#include "support/difference.hpp"

namespace hawser::spring_matrices_test {
namespace {

using test::slope;

// A symmetric stiffness; a damping that is not symmetric.
SpringMatrices matrices() {
  SpringMatrices m;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      m.stiffness(i, j) = std::cos(1.0 + i + j + 0.3 * i * j) + (i == j ? 4 : 0);
      m.damping(i, j) = std::sin(2.0 + 3 * i + 5 * j) + (i == j ? 5 : 0);
    }
  m.arm = Vec3(0.4, -0.3, 0.7);
  return m;
}

RigidBodyState state(const Vec6& u = Vec6::Zero(), const Vec6& rate = Vec6::Zero()) {
  RigidBodyState s;
  s.x = Vec3(0.3, -0.2, 0.5) + u.head<3>();
  s.q = exp_so3(Vec3(0.7, -1.1, 0.9)) * exp_so3(u.tail<3>());
  s.v = Vec3(0.4, 0.1, -0.3) + rate.head<3>();
  s.w = Vec3(0.5, -0.6, 0.8) + rate.tail<3>();
  return s;
}

// With constant velocities, at the time t.
RigidPose support(double t = 0) {
  RigidPose p;
  p.velocity = Vec3(0.3, -0.5, 0.1);
  p.angular_velocity = Vec3(0.2, 0.5, -0.3);
  p.position = Vec3(0.1, 0.2, -0.1) + t * p.velocity;
  p.rotation = exp_so3(Vec3(t * p.angular_velocity)) * exp_so3(Vec3(-0.2, 0.3, 0.4));
  return p;
}

TEST(SpringMatrices, TangentsAreDerivatives) {
  const SpringMatrices m = matrices();
  const SpringMatrixForces r = spring_matrix_forces(m, state(), support());
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const Vec6 K = slope([&](const Vec6& u) { return spring_matrix_forces(m, state(u), support()).f; }, d);
    const Vec6 C =
        slope([&](const Vec6& u) { return spring_matrix_forces(m, state(Vec6::Zero(), u), support()).f; }, d);
    EXPECT_LT((r.K * d - K).norm(), 1e-8 * r.K.norm()) << k;
    EXPECT_LT((r.C * d - C).norm(), 1e-8 * r.C.norm()) << k;
  }
}

// The power of the body and of the support is that stored and dissipated.
TEST(SpringMatrices, Powers) {
  const SpringMatrices m = matrices();
  const RigidBodyState now = state();
  const auto potential = [&](double t) {
    RigidBodyState s = now;
    s.x += t * now.v;
    s.q = now.q * exp_so3(Vec3(t * now.w));
    return spring_matrix_forces(m, s, support(t)).potential;
  };
  constexpr double e = 1e-3;
  const double stored =
      (8 * (potential(e) - potential(-e)) - potential(2 * e) + potential(-2 * e)) / (12 * e);
  const SpringMatrixForces r = spring_matrix_forces(m, now, support());
  const double by_body = r.f.head<3>().dot(now.v) + r.f.tail<3>().dot(now.w);
  EXPECT_GT(r.dissipated, 1);
  EXPECT_NEAR(stored + r.dissipated, by_body + r.supplied, 1e-9 * std::abs(by_body));
}

// A body that moves with its support is free of forces.
TEST(SpringMatrices, RestsWithTheSupport) {
  const RigidPose rest = support();
  RigidBodyState s;
  s.x = rest.position;
  s.q = rest.rotation;
  s.v = rest.velocity;
  s.w = rest.rotation.conjugate() * rest.angular_velocity;
  const SpringMatrixForces r = spring_matrix_forces(matrices(), s, rest);
  EXPECT_LT(r.f.norm(), 1e-14);
  EXPECT_LT(r.potential, 1e-14);
}

}  // namespace
}  // namespace hawser::spring_matrices_test
