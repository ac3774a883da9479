// A point of a frame: derivatives with respect to a rotation of the frame, and its moment.
#include "hawser/kernels/frame_point.hpp"

#include <gtest/gtest.h>

namespace hawser::test::frame_point_test {
namespace {

FramePoint turned(const Vec3& theta, const Vec3& more_w = Vec3::Zero()) {
  return {{0.4, -0.2, 0.3},
          (exp_so3(Vec3(0.7, -1.1, 0.9)) * exp_so3(theta)).toRotationMatrix(),
          Vec3(0.5, -0.6, 0.8) + more_w};
}

TEST(FramePoint, DerivativesByATurn) {
  const FramePoint p = turned(Vec3::Zero());
  const Vec3 f(3, -1, 2);
  constexpr double h = 1e-5;
  for (int k = 0; k < 3; ++k) {
    const Vec3 d = h * Vec3::Unit(k);
    const auto slope = [&](const auto& of) -> Vec3 { return (of(turned(d)) - of(turned(-d))) / (2 * h); };
    EXPECT_LT((p.by_turn().col(k) - slope([](const FramePoint& q) { return q.arm(); })).norm(), 1e-9);
    EXPECT_LT((p.velocity_by_turn().col(k) - slope([](const FramePoint& q) { return q.velocity(); })).norm(),
              1e-9);
    EXPECT_LT((p.moment_by_turn(f).col(k) - slope([&](const FramePoint& q) { return q.moment(f); })).norm(),
              1e-9);
    const Vec3 by_w = (turned(Vec3::Zero(), d).velocity() - turned(Vec3::Zero(), -d).velocity()) / (2 * h);
    EXPECT_LT((p.by_turn().col(k) - by_w).norm(), 1e-9);
  }
}

// Vectors that turn with the frame or are fixed in space, and the moment of a force at a point that moves
// relative to the frame.
TEST(FramePoint, DerivativesOfVectors) {
  const FramePoint p = turned(Vec3::Zero());
  const Vec3 a(3, -1, 2);
  const Vec3 in_frame = p.R.transpose() * a;
  constexpr double h = 1e-5;
  for (int k = 0; k < 3; ++k) {
    const Vec3 d = h * Vec3::Unit(k);
    const auto slope = [&](const auto& of) -> Vec3 { return (of(d) - of(-d)) / (2 * h); };
    const Vec3 turns = slope([&](const Vec3& u) -> Vec3 { return turned(u).R * in_frame; });
    const Vec3 stays = slope([&](const Vec3& u) -> Vec3 { return turned(u).R.transpose() * a; });
    const Vec3 moment = slope([&](const Vec3& u) {
      return FramePoint{p.y + p.R.transpose() * u, p.R}.moment(a);
    });
    EXPECT_LT((p.vector_by_turn(a).col(k) - turns).norm(), 1e-9);
    EXPECT_LT((p.components_by_turn(a).col(k) - stays).norm(), 1e-9);
    EXPECT_LT((p.moment_by_position(a).col(k) - moment).norm(), 1e-9);
  }
}

// The moment is that of the arm in space; the power at the point equals that on the frame.
TEST(FramePoint, MomentAndWork) {
  const FramePoint p = turned(Vec3::Zero());
  const Vec3 f(3, -1, 2);
  EXPECT_LT((p.R * p.moment(f) - p.arm().cross(f)).norm(), 1e-14);
  EXPECT_NEAR(f.dot(p.velocity()), p.moment(f).dot(p.w), 1e-14);
}

// For an outward residual the convex part is the derivative across the arm; for an inward residual it is
// zero.
TEST(FramePoint, ConvexPart) {
  const FramePoint p = turned(Vec3::Zero());
  const Vec3 out = -2 * p.arm();  // a force along the arm
  EXPECT_LT((p.convex_moment_by_turn(out) - p.moment_by_turn(out)).norm(), 1e-14);
  EXPECT_EQ(p.convex_moment_by_turn(-out).norm(), 0);
}

}  // namespace
}  // namespace hawser::test::frame_point_test
