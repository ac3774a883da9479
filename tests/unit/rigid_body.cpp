// Inertia and springs of a rigid body: tangents against differences, momentum, energy, and the conversion of
// mass matrices.
#include "hawser/kernels/rigid_body.hpp"

#include <gtest/gtest.h>

#include "hawser/kernels/coupled_mass.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/mass_matrix.hpp"
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

// A symmetric, full mass matrix with coupling of translations and rotations.
Mat6 coupled() {
  Mat6 N;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) N(i, j) = std::cos(1.0 + i + j + 0.3 * i * j);
  return N;
}

// The residual is linear in N, which is entirely that of the coupled mass.
TEST(RigidBody, TangentsOfCoupledMassAreDerivatives) {
  const Mat6 N = coupled();
  const auto of = [&](const RigidBodyState& s) {
    RigidBodyResidual r;
    add_coupled_mass(N, s, r);
    return r;
  };
  const RigidBodyResidual r = of(state());
  const Vec6 zero = Vec6::Zero();
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const Vec6 K = slope([&](const Vec6& u) { return of(state(u)).f(); }, d);
    const Vec6 C = slope([&](const Vec6& u) { return of(state(zero, u)).f(); }, d);
    const Vec6 M = slope([&](const Vec6& u) { return of(state(zero, zero, u)).f(); }, d);
    EXPECT_LT((r.K * d - K).norm(), 1e-8 * r.K.norm()) << k;
    EXPECT_LT((r.C * d - C).norm(), 1e-8 * r.C.norm()) << k;
    EXPECT_LT((r.M * d - M).norm(), 1e-8 * r.M.norm()) << k;
  }
}

// Force and moment are the rates of momentum and angular momentum; their power is the rate of kinetic energy.
TEST(RigidBody, CoupledMassKeepsMomentumAndEnergy) {
  const Mat6 N = coupled();
  const RigidBodyState now = state();
  const auto at = [&](double t) {
    RigidBodyState s = now;
    s.x += t * now.v + 0.5 * t * t * now.a;
    s.v += t * now.a;
    s.w += t * now.alpha;
    // R' = R w^, with w = w0 + alpha t; (w0 x alpha) t³/12 of Magnus' series.
    s.q =
        now.q * exp_so3(Vec3(t * now.w + 0.5 * t * t * now.alpha + t * t * t / 12 * now.w.cross(now.alpha)));
    return s;
  };
  const auto momentum = [&](double t) {
    const RigidBodyState s = at(t);
    Vec6 rate;
    rate << s.q.conjugate() * s.v, s.w;
    const Vec6 P = N * rate;
    const Vec3 p = s.q * P.head<3>();
    Vec6 out;
    out << p, s.x.cross(p) + s.q * P.tail<3>();
    return out;
  };
  RigidBodyResidual r;
  add_coupled_mass(N, now, r);
  const Vec6 f = r.f();
  const double e = 1e-3;
  const auto rate = [&](const auto& of) -> decltype(of(e)) {
    return (8 * (of(e) - of(-e)) - (of(2 * e) - of(-2 * e))) / (12 * e);
  };
  const Vec6 change = rate(momentum);
  Vec6 expected;
  expected << f.head<3>(), now.x.cross(f.head<3>()) + now.q * f.tail<3>();
  EXPECT_LT((change - expected).norm(), 1e-8 * expected.norm());
  const double power = rate([&](double t) { return coupled_kinetic(N, at(t)); });
  EXPECT_NEAR(power, f.head<3>().dot(now.v) + f.tail<3>().dot(now.w), 1e-8 * f.norm());
}

// The mass matrix of a rigid body about any point has the mass, centre and inertia of the body, and no
// coupling remains.
TEST(RigidBody, MassMatrixOfARigidBody) {
  model::BodyMass body;
  body.mass = 3;
  body.centre = Vec3(0.5, -0.7, 1.1);
  body.inertia = Vec3(4, 5, 6);
  body.products = Vec3(0.3, 0.1, -0.2);
  model::BodyMass found;
  found.mass = 3;
  const Vec3 about(2, 1, -4);
  found.matrix = model::MassMatrix{model::mass_matrix_about(body, about), about};
  model::use_mass_matrix(found);
  EXPECT_LT((found.centre - body.centre).norm(), 1e-14);
  EXPECT_LT((found.tensor() - body.tensor()).norm(), 1e-13);
  EXPECT_LT(found.coupled.norm(), 1e-13);
  // Surge, heave and yaw about the origin, by hand.
  const Mat6 M = model::mass_matrix_about(body, Vec3::Zero());
  EXPECT_NEAR(M(0, 4), 3 * 1.1, 1e-14);
  EXPECT_NEAR(M(2, 3), 3 * -0.7, 1e-14);
  EXPECT_NEAR(M(5, 5), 6 + 3 * (0.25 + 0.49), 1e-14);
  // If the centre is inconsistent with the couplings, the whole matrix is kept.
  model::BodyMass other = found;
  other.centre = Vec3(0.1, 0.2, 0.3);
  other.centre_given = true;
  model::use_mass_matrix(other);
  EXPECT_GT(other.coupled.norm(), 1);
  EXPECT_LT((model::mass_matrix_about(other, about) - found.matrix->rows).norm(), 1e-12);
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
