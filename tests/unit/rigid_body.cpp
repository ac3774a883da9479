#include "hawser/kernels/rigid_body.hpp"

#include <gtest/gtest.h>

#include "hawser/geometry/primitives.hpp"
#include "hawser/kernels/body_contact.hpp"
#include "hawser/math/so3.hpp"

namespace hawser::rigid_body_test {
namespace {

RigidBodyData barge() {
  RigidBodyData b;
  b.mass = 3;
  b.inertia << 4, 0.3, -0.2, 0.3, 5, 0.1, -0.2, 0.1, 6;
  b.weight = Vec3(0, 0, -9);
  b.stiffness = Vec3(20, 30, 50), b.damping = Vec3(2, 3, 1);
  b.turning_stiffness = Vec3(40, 25, 35), b.turning_damping = Vec3(3, 4, 2);
  return b;
}

RigidBodyState state(const Vec6& u = Vec6::Zero(), const Vec6& rate = Vec6::Zero(),
                     const Vec6& second = Vec6::Zero()) {
  RigidBodyState s;
  s.x = Vec3(0.3, -0.2, 0.5) + u.head<3>();
  s.q = exp_so3(Vec3(0.7, -1.1, 0.9)) * exp_so3(u.tail<3>());
  s.v = Vec3(0.4, 0.1, -0.3) + rate.head<3>(), s.w = Vec3(0.5, -0.6, 0.8) + rate.tail<3>();
  s.a = Vec3(0.2, 0.5, -0.1) + second.head<3>(), s.alpha = Vec3(-0.4, 0.3, 0.7) + second.tail<3>();
  return s;
}

RigidPose resting() {
  RigidPose p;
  p.position = Vec3(0.1, 0.2, -0.1), p.rotation = exp_so3(Vec3(-0.2, 0.3, 0.4));
  p.velocity = Vec3(0.3, 0, 0.1), p.angular_velocity = Vec3(0.2, -0.1, 0.3);
  return p;
}

// Fourth-order difference of f along d.
template <class F>
auto slope(F f, const Vec6& d) {
  const double e = 1e-3;
  return ((8 * (f(e * d) - f(-e * d)) - (f(2 * e * d) - f(-2 * e * d))) / (12 * e)).eval();
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
  b.weight.setZero(), b.damping.setZero(), b.turning_damping.setZero();
  RigidBodyState s = state();
  s.a.setZero(), s.v.setZero(), s.w.setZero(), s.alpha.setZero();
  const RigidBodyResidual r = rigid_body(b, s, resting());
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const double e = 1e-3;
    const auto energy = [&](double z) { return rigid_body_strain(b, state(z * d), resting()); };
    EXPECT_NEAR((8 * (energy(e) - energy(-e)) - energy(2 * e) + energy(-2 * e)) / (12 * e), r.f()[k],
                1e-8 * r.f().norm());
  }
}

BodyFrame frame(const Vec3& x, const Vec3& turn, const Vec3& v, const Vec3& w, const Vec6& u,
                const Vec6& rate) {
  BodyFrame f;
  f.x = x + u.head<3>();
  f.R = (exp_so3(turn) * exp_so3(u.tail<3>())).toRotationMatrix();
  f.v = v + rate.head<3>(), f.w = w + rate.tail<3>();
  return f;
}

// A ball on A against a round surface of B, touching; u and rate are those of A and of B.
struct Touch {
  std::shared_ptr<const Surface> surface = make_surface(TorusShape{{0.1, 0, 0}, {0, 0.2, 1}, 2.0, 0.6});
  NormalLaw law{1000, 0.05, 30};
  Vec3 y = Vec3(0.4, -0.2, 0.3);
  double depth = 0;

  BodyContact operator()(const Vec12& u, const Vec12& rate, BodyContactPoint* point = nullptr) const {
    const BodyFrame A = frame({3.0, 0.3, 0.5}, {0.5, 0.2, -0.6}, {-0.5, 0.2, 0.1}, {0.3, -0.2, 0.4},
                              u.head<6>(), rate.head<6>());
    const BodyFrame B = frame({0.2, -0.1, 0.3}, {-0.3, 0.4, 0.1}, {0.2, 0.1, 0}, {-0.1, 0.3, 0.2},
                              u.tail<6>(), rate.tail<6>());
    BodyContact sum;
    const auto at = surface->query(B.to_body(A.to_space(y)), 100);
    const auto p = body_contact(A, y, depth, B, *at, law, 0.7, true, sum);
    if (point) *point = p;
    return sum;
  }
};

TEST(BodyContact, TangentsAreDerivatives) {
  for (const double inside : {0.1, 0.02, -0.01}) {  // below the ramp, on it twice
    Touch touch;
    BodyContactPoint p;
    touch(Vec12::Zero(), Vec12::Zero(), &p);
    touch.depth = p.gap + inside;
    const BodyContact r = touch(Vec12::Zero(), Vec12::Zero(), &p);
    ASSERT_NEAR(p.gap, -inside, 1e-12);
    ASSERT_GT(p.law.force, 0);
    for (int k = 0; k < 12; ++k) {
      const Vec12 d = Vec12::Unit(k), zero = Vec12::Zero();
      const double e = 1e-4;
      const auto K = [&](double z) { return touch(z * d, zero).f; };
      const auto C = [&](double z) { return touch(zero, z * d).f; };
      const Vec12 by_place = (8 * (K(e) - K(-e)) - (K(2 * e) - K(-2 * e))) / (12 * e);
      const Vec12 by_rate = (8 * (C(e) - C(-e)) - (C(2 * e) - C(-2 * e))) / (12 * e);
      EXPECT_LT((r.K * d - by_place).norm(), 1e-7 * r.K.norm()) << inside << ' ' << k;
      EXPECT_LT((r.C * d - by_rate).norm(), 1e-7 * r.C.norm()) << inside << ' ' << k;
    }
  }
}

TEST(BodyContact, KeepsMomentumAndAngularMomentum) {
  Touch touch;
  BodyContactPoint p;
  touch(Vec12::Zero(), Vec12::Zero(), &p);
  touch.depth = p.gap + 0.1;
  const BodyContact r = touch(Vec12::Zero(), Vec12::Zero());
  EXPECT_LT((r.f.segment<3>(0) + r.f.segment<3>(6)).norm(), 1e-13 * r.f.norm());
  const Mat3 RA = exp_so3(Vec3(0.5, 0.2, -0.6)).toRotationMatrix(),
             RB = exp_so3(Vec3(-0.3, 0.4, 0.1)).toRotationMatrix();
  const Vec3 moment = Vec3(3.0, 0.3, 0.5).cross(r.f.segment<3>(0)) + RA * r.f.segment<3>(3) +
                      Vec3(0.2, -0.1, 0.3).cross(r.f.segment<3>(6)) + RB * r.f.segment<3>(9);
  EXPECT_LT(moment.norm(), 1e-12 * r.f.norm());
}

TEST(BodyContact, NothingWhenApart) {
  Touch touch;
  BodyContactPoint p;
  touch(Vec12::Zero(), Vec12::Zero(), &p);
  touch.depth = p.gap - 0.051;
  const BodyContact r = touch(Vec12::Zero(), Vec12::Zero(), &p);
  EXPECT_EQ(p.law.force, 0);
  EXPECT_EQ(r.f.norm() + r.K.norm() + r.C.norm(), 0);
}

}  // namespace
}  // namespace hawser::rigid_body_test
