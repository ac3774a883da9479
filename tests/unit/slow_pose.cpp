// Filter of slow motion against an integration in small steps, and its frequency response.
#include "hawser/kernels/slow_pose.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace hawser::slow_pose_test {
namespace {

constexpr double kPeriod = 100, kC = 2 * M_PI / kPeriod;

// Steps of several lengths with uniform motion, against Heun's method with 10^4 steps in each.
TEST(SlowPose, IsExactForUniformMotion) {
  WavePose slow = WavePose::at(Vec3(1, -2, 0.5));
  std::array<Vec3, 6> y;  // the pose and its five filtered values
  y.fill(Vec3(1, -2, 0.5));
  const double steps[] = {0.5, 3, 0.1, 20};
  const Vec3 moves[] = {Vec3(0.3, 0, 0.01), Vec3(-1, 2, -0.4), Vec3(0.2, 0.2, 0.02), Vec3(9, -5, 0.7)};
  for (int k = 0; k < 4; ++k) {
    constexpr int kSmall = 10000;
    const double h = steps[k] / kSmall;
    for (int i = 0; i < kSmall; ++i) {
      std::array<Vec3, 6> end = y;
      end[0] += moves[k] / kSmall;
      for (size_t n = 1; n < 6; ++n) end[n] += h * kC * (y[n - 1] - y[n]);
      const std::array<Vec3, 6> first = y;
      y[0] = end[0];
      for (size_t n = 1; n < 6; ++n) y[n] += 0.5 * h * kC * (first[n - 1] - first[n] + end[n - 1] - end[n]);
    }
    slow = slow.after(y[0], steps[k], kPeriod);
    for (size_t n = 1; n < 6; ++n)
      EXPECT_LT((slow.delayed.segment<3>(3 * static_cast<Eigen::Index>(n) - 3) - y[n]).norm(), 1e-7) << k;
    for (int i = 0; i < 3; ++i) {
      const size_t n = i < 2 ? 5 : 3;  // the heading is filtered by third order
      const double order = static_cast<double>(n);
      const double drift = kC * (y[n - 1][i] - y[n][i]);
      EXPECT_NEAR(slow.drift[i], drift, 1e-7) << k;
      EXPECT_NEAR(slow.place[i], y[n][i] + order / kC * drift, 1e-6) << k;
      EXPECT_NEAR(slow.speed[i], drift + order * kC * (y[n - 2][i] - 2 * y[n - 1][i] + y[n][i]), 1e-7) << k;
    }
  }
}

// Largest deflection of the slow pose in an oscillation of unit amplitude with a tenth of the period.
template <int N>
double gain_in_waves() {
  SlowPose<N> slow = SlowPose<N>::at(Vec3::Zero());
  double largest = 0;
  for (int i = 1; i <= 4000; ++i) {
    const double t = 0.25 * i;
    slow = slow.after(Vec3(0, std::sin(2 * M_PI * t / 10), 0), 0.25, kPeriod);
    if (t > 600) largest = std::max(largest, std::abs(slow.place.y()));
  }
  return largest;
}

// The filter follows uniform motion without lag, and passes |1 + i N w/c|/|1 + i w/c|^N of an oscillation:
// with a tenth of the period 3 % (N = 3) and 0.05 % (N = 5).
TEST(SlowPose, FollowsUniformMotionAndNotWaves) {
  WavePose slow = WavePose::at(Vec3::Zero());
  for (int i = 1; i <= 4000; ++i) {
    const double t = 0.25 * i;
    slow = slow.after(Vec3(2 * t, 0, 0), 0.25, kPeriod);
    if (t < 600) continue;
    EXPECT_NEAR(slow.place.x(), 2 * t, 1e-6);
    EXPECT_NEAR(slow.drift.x(), 2, 1e-8);
    EXPECT_NEAR(slow.speed.x(), 2, 1e-8);
  }
  EXPECT_NEAR(gain_in_waves<3>(), std::hypot(1, 30) / std::pow(std::hypot(1, 10), 3), 1e-3);
  EXPECT_NEAR(gain_in_waves<5>(), std::hypot(1, 50) / std::pow(std::hypot(1, 10), 5), 1e-4);
}

// Place and velocity are linear in the pose at the end of a step.
TEST(SlowPose, DerivativesByThePose) {
  const ControllerPose start = ControllerPose::at(Vec3(1, -2, 0.5)).after(Vec3(1.3, -2.1, 0.6), 0.4, kPeriod);
  const Vec3 pose(1.1, -2.4, 0.55), change(0.2, -0.3, 0.1);
  for (const double h : {0.02, 1.0, 30.0}) {
    const ControllerPose a = start.after(pose, h, kPeriod);
    const ControllerPose b = start.after(pose + change, h, kPeriod);
    const auto by_pose = ControllerPose::derivatives(h, kPeriod);
    EXPECT_LT((b.place - a.place - by_pose.place * change).norm(), 1e-12) << h;
    EXPECT_LT((b.speed - a.speed - by_pose.speed * change).norm(), 1e-12 * (1 + by_pose.speed)) << h;
  }
}

TEST(SlowPose, TurnsTheShorterWay) {
  WavePose slow = WavePose::at(Vec3(0, 0, 3.1));
  for (int i = 0; i < 10000; ++i) slow = slow.after(Vec3(0, 0, -3.1), 0.1, kPeriod);
  EXPECT_NEAR(slow.place.z(), 2 * M_PI - 3.1, 1e-9);
}

}  // namespace
}  // namespace hawser::slow_pose_test
