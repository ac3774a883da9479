// Motion of a platform's origin and forces that depend on its displacement, against derivatives and
// potentials.
#include "hawser/kernels/platform_frame.hpp"

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"
#include "support/difference.hpp"

namespace hawser::platform_frame_test {
namespace {

using test::slope;

const Vec3 kArm(1.3, -0.7, 2.1);

Mat3 axes() { return exp_so3(Vec3(0, 0, 0.6)).toRotationMatrix(); }

RigidBodyState state(const Vec6& place = Vec6::Zero(), const Vec6& rate = Vec6::Zero(),
                     const Vec6& acceleration = Vec6::Zero()) {
  RigidBodyState s;
  s.x = Vec3(0.3, -0.2, 0.5) + place.head<3>();
  s.q = exp_so3(Vec3(0.2, -0.3, 0.9)) * exp_so3(place.tail<3>());
  s.v = Vec3(0.4, 0.1, -0.3) + rate.head<3>();
  s.w = Vec3(0.5, -0.6, 0.8) + rate.tail<3>();
  s.a = Vec3(0.2, 0.5, -0.1) + acceleration.head<3>();
  s.alpha = Vec3(-0.4, 0.3, 0.7) + acceleration.tail<3>();
  return s;
}

PlatformPotential potential() {
  PlatformPotential V;
  V.axes = axes();
  V.place = Vec3(0.1, 0.4, -0.2);
  const Mat6 half = Mat6::Random();
  V.stiffness = half * half.transpose() + 3 * Mat6::Identity();
  return V;
}

using Motion = PlatformMotion (*)(const Mat3& H, const Vec3& r, const RigidBodyState& s);

class PlatformFrameOf : public testing::TestWithParam<Motion> {
 protected:
  static PlatformMotion motion(const RigidBodyState& s) { return GetParam()(axes(), kArm, s); }
};

INSTANTIATE_TEST_SUITE_P(Axes, PlatformFrameOf,
                         testing::Values(Motion(platform_motion), Motion(platform_motion_by_heading)));

TEST_P(PlatformFrameOf, MotionHasItsDerivatives) {
  const PlatformMotion m = motion(state());
  const Vec6 zero = Vec6::Zero();
  const auto rate = [](const RigidBodyState& s) { return motion(s).rate; };
  const auto acceleration = [](const RigidBodyState& s) { return motion(s).acceleration; };
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const Vec6 by_place = slope([&](const Vec6& u) { return rate(state(u)); }, d);
    const Vec6 by_rate = slope([&](const Vec6& u) { return rate(state(zero, u)); }, d);
    EXPECT_LT((m.rate_by_place * d - by_place).norm(), 1e-9) << k;
    EXPECT_LT((m.G * d - by_rate).norm(), 1e-9) << k;
    const Vec6 a_place = slope([&](const Vec6& u) { return acceleration(state(u)); }, d);
    const Vec6 a_rate = slope([&](const Vec6& u) { return acceleration(state(zero, u)); }, d);
    const Vec6 a_second = slope([&](const Vec6& u) { return acceleration(state(zero, zero, u)); }, d);
    EXPECT_LT((m.acceleration_by_place * d - a_place).norm(), 1e-9) << k;
    EXPECT_LT((m.acceleration_by_rate * d - a_rate).norm(), 1e-9) << k;
    EXPECT_LT((m.G * d - a_second).norm(), 1e-9) << k;
  }
}

TEST_P(PlatformFrameOf, ForcesHaveTheirSlope) {
  Vec6 F;
  F << 3, -1, 2, 0.5, 4, -2;
  const Mat6 K = platform_force_slope(motion(state()), kArm, F);
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const Vec6 found = slope([&](const Vec6& u) -> Vec6 { return motion(state(u)).G.transpose() * F; }, d);
    EXPECT_LT((K * d - found).norm(), 1e-9) << k;
  }
}

// The angular velocity and the moments are in axes that turn with the body: its rotation about the vertical
// does not change them.
TEST(PlatformFrame, MomentsTurnWithTheHeading) {
  const RigidBodyState s = state();
  RigidBodyState turned = s;
  turned.q = exp_so3(Vec3(0, 0, 0.7)) * s.q;
  const PlatformMotion m = platform_motion_by_heading(axes(), kArm, s);
  const PlatformMotion of_turned = platform_motion_by_heading(axes(), kArm, turned);
  EXPECT_LT((m.rate - of_turned.rate).tail<3>().norm(), 1e-14);
  EXPECT_LT((m.P - of_turned.P).norm(), 1e-14);
  EXPECT_GT((m.rate - of_turned.rate).head<3>().norm(), 0.1);
  EXPECT_LT((platform_rate_by_heading(axes(), kArm, s) - m.rate).norm(), 1e-14);
}

// The acceleration is the time derivative of the rate along the motion.
TEST(PlatformFrame, AccelerationIsTheRateOfTheRate) {
  const double h = 1e-4;
  const auto at = [](double t) {
    const RigidBodyState s = state();
    RigidBodyState moved = s;
    moved.x += t * s.v + 0.5 * t * t * s.a;
    moved.v += t * s.a;
    moved.w += t * s.alpha;
    moved.q = s.q * exp_so3(t * s.w + 0.5 * t * t * s.alpha);
    return platform_motion(axes(), kArm, moved).rate;
  };
  const Vec6 slope_in_time = (at(h) - at(-h)) / (2 * h);
  EXPECT_LT((slope_in_time - platform_motion(axes(), kArm, state()).acceleration).norm(), 1e-7);
}

TEST(PlatformFrame, PullIsTheGradientOfItsPotentialWithItsTangent) {
  const PlatformPotential V = potential();
  const PotentialGradient gradient = platform_gradient(V, kArm, state());
  using One = Eigen::Matrix<double, 1, 1>;
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const One work =
        slope([&](const Vec6& u) { return One(platform_gradient(V, kArm, state(u)).potential); }, d);
    EXPECT_NEAR(gradient.f.dot(d), work[0], 1e-8 * gradient.f.norm()) << k;
    const Vec6 found = slope([&](const Vec6& u) { return platform_gradient(V, kArm, state(u)).f; }, d);
    EXPECT_LT((gradient.K * d - found).norm(), 1e-8 * gradient.K.norm()) << k;
  }
}

TEST(PlatformFrame, HeadingHasItsSlope) {
  const Heading heading = heading_of(state().q);
  using One = Eigen::Matrix<double, 1, 1>;
  for (int k = 0; k < 3; ++k) {
    const One found =
        slope([&](const Vec6& u) { return One(heading_of(state(u).q).angle); }, Vec6(Vec6::Unit(3 + k)));
    EXPECT_NEAR(heading.by_turn[k], found[0], 1e-9) << k;
  }
  EXPECT_NEAR(heading_of(exp_so3(Vec3(0, 0, 2.5))).angle, 2.5, 1e-14);
}

// Forces that depend on the heading and act in its axes; if everything is rotated, the forces are as well.
TEST(PlatformFrame, TurningLoadHasItsTangent) {
  const auto F = [](double heading) {
    TurningForce out;
    for (int k = 0; k < 6; ++k) {
      out.force[k] = (k + 1) * std::sin(2 * heading + k);
      out.by_heading[k] = 2 * (k + 1) * std::cos(2 * heading + k);
    }
    return out;
  };
  const auto load = [&](const RigidBodyState& s) { return turning_load(F(heading_of(s.q).angle), kArm, s); };
  const PlatformLoad here = load(state());
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const Vec6 found = slope([&](const Vec6& u) { return load(state(u)).f; }, d);
    EXPECT_LT((here.K * d - found).norm(), 1e-8 * here.K.norm()) << k;
  }
  RigidBodyState s;
  const Vec6 level = turning_load(F(0), Vec3::Zero(), s).f;
  EXPECT_LT((level + F(0).force).norm(), 1e-14);
}

TEST(PlatformFrame, LoadsHaveTheirTangent) {
  for (const bool body_fixed : {false, true}) {
    const RigidBodyLoad load{Vec3(3, -2, 5), Vec3(1, 4, -2), kArm, body_fixed};
    const auto of = [&load](const RigidBodyState& s) {
      RigidBodyResidual r;
      add_load(load, s, r);
      return r;
    };
    for (int k = 0; k < 6; ++k) {
      const Vec6 d = Vec6::Unit(k);
      const Vec6 found = slope([&](const Vec6& u) { return of(state(u)).applied; }, d);
      EXPECT_LT((of(state()).K * d - found).norm(), 1e-9) << k << body_fixed;
    }
  }
}

}  // namespace
}  // namespace hawser::platform_frame_test
