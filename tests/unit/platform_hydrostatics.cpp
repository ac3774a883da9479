// Hydrostatics of a platform by heave and tilt: the force is the gradient of the potential, the tangent its
// derivative, and yaw is free.
#include "hawser/kernels/platform_hydrostatics.hpp"

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"
#include "support/difference.hpp"

namespace hawser::platform_hydrostatics_test {
namespace {

using test::slope;

const Vec3 kArm(-3.9, 0.4, -2.5);

PlatformHydrostatics hydrostatics() {
  PlatformHydrostatics V;
  V.stiffness << 9, -1, 20, -1, 70, 3, 20, 3, 900;
  V.level = -0.2;
  V.buoyancy = 30;
  V.arm_x = 3.9;
  V.arm_y = -0.4;
  return V;
}

// A body with the rotation `tilt`, followed by yaw.
RigidBodyState state(const Vec3& tilt, double yaw, const Vec6& by = Vec6::Zero()) {
  RigidBodyState s;
  s.x = Vec3(0.3, -0.2, 0.5) + by.head<3>();
  s.q = exp_so3(yaw * Vec3::UnitZ()) * exp_so3(tilt) * exp_so3(by.tail<3>());
  return s;
}

// Upright, on both sides of the end of the series of alpha/sin alpha (0.451 rad), and beyond 90 degrees.
TEST(PlatformHydrostatics, PullIsTheGradientOfItsPotentialWithItsTangent) {
  const PlatformHydrostatics V = hydrostatics();
  for (const Vec3& tilt : {Vec3(0, 0, 0), Vec3(0.05, -0.1, 0), Vec3(0.44, 0.05, 0), Vec3(0.2, 0.42, 0),
                           Vec3(-0.9, 0.6, 0), Vec3(1, 1.5, 0)}) {
    const double yaw = 2.2;
    const PotentialGradient gradient = hydrostatic_gradient(V, kArm, state(tilt, yaw));
    using One = Eigen::Matrix<double, 1, 1>;
    for (int k = 0; k < 6; ++k) {
      const Vec6 d = Vec6::Unit(k);
      const auto potential = [&](const Vec6& u) {
        return One(hydrostatic_gradient(V, kArm, state(tilt, yaw, u)).potential);
      };
      const auto force = [&](const Vec6& u) { return hydrostatic_gradient(V, kArm, state(tilt, yaw, u)).f; };
      EXPECT_NEAR(gradient.f.dot(d), slope(potential, d)[0], 1e-7) << tilt.transpose() << ", " << k;
      EXPECT_LT((gradient.K * d - slope(force, d)).norm(), 1e-7) << tilt.transpose() << ", " << k;
    }
  }
}

// For pure tilt the energy is that of a stiffness with the rotation vector.
TEST(PlatformHydrostatics, TiltIsTheRotationVector) {
  const PlatformHydrostatics V = hydrostatics();
  for (const Vec3& tilt : {Vec3(0.1, -0.2, 0), Vec3(0.7, 1.1, 0)}) {
    const RigidBodyState s = state(tilt, 0);
    const Vec3 O = s.x + s.q * kArm;
    const Vec3 eta(O.z() - V.level, tilt.x(), tilt.y());
    const double buoy = (O + s.q * Vec3(V.arm_x, V.arm_y, 0)).z() - V.level;
    const double expected = 0.5 * eta.dot(V.stiffness * eta) - V.buoyancy * buoy;
    EXPECT_NEAR(hydrostatic_gradient(V, kArm, s).potential, expected, 1e-12 * std::abs(expected));
  }
}

// Forces rotate with the body, and the yaw moment is zero.
TEST(PlatformHydrostatics, YawIsFree) {
  const PlatformHydrostatics V = hydrostatics();
  const Vec3 tilt(0.2, -0.3, 0);
  const PotentialGradient straight = hydrostatic_gradient(V, kArm, state(tilt, 0));
  for (const double yaw : {0.5, 1.5, 3.0, -2.5}) {
    const RigidBodyState s = state(tilt, yaw);
    const PotentialGradient turned = hydrostatic_gradient(V, kArm, s);
    EXPECT_NEAR(turned.potential, straight.potential, 1e-12 * std::abs(straight.potential));
    EXPECT_LT((turned.f - straight.f).norm(), 1e-12 * straight.f.norm());
    const Vec3 moment = s.q * Vec3(turned.f.tail<3>());  // about the centre of mass
    EXPECT_NEAR(moment.z(), 0, 1e-12 * moment.norm());
  }
}

// In the upright position, buoyancy on the vertical through the centre of mass has no moment, for any yaw.
TEST(PlatformHydrostatics, OffsetBuoyancyTurnsWithTheBody) {
  PlatformHydrostatics V = hydrostatics();
  for (const double yaw : {0.0, 1.0, 2.0, 3.0}) {
    const RigidBodyState s = state(Vec3::Zero(), yaw);
    V.level = s.x.z() + kArm.z();
    const PotentialGradient gradient = hydrostatic_gradient(V, kArm, s);
    EXPECT_NEAR(gradient.f[2], -V.buoyancy, 1e-12);
    EXPECT_LT(gradient.f.tail<3>().norm(), 1e-12);
  }
}

}  // namespace
}  // namespace hawser::platform_hydrostatics_test
