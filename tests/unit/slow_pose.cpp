// Filter of slow motion against an integration in small steps, and its frequency response.
#include "hawser/kernels/slow_pose.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::slow_pose_test {
namespace {

constexpr double kPeriod = 100, kC = 2 * M_PI / kPeriod;

// Steps of several lengths with uniform motion, against Heun's method with 10^4 steps in each.
TEST(SlowPose, IsExactForEvenMotion) {
  SlowPose slow = SlowPose::at(Vec3(1, -2, 0.5));
  Vec3 y(1, -2, 0.5), v = Vec3::Zero(), z = Vec3::Zero(), x = y;
  const double steps[] = {0.5, 3, 0.1, 20};
  const Vec3 goes[] = {Vec3(0.3, 0, 0.01), Vec3(-1, 2, -0.4), Vec3(0.2, 0.2, 0.02), Vec3(9, -5, 0.7)};
  for (int k = 0; k < 4; ++k) {
    constexpr int kSmall = 10000;
    const double h = steps[k] / kSmall;
    for (int i = 0; i < kSmall; ++i) {
      const auto force = [&](const Vec3& at, const Vec3& rate, double share) {
        return Vec3(kC * kC * (x + share * goes[k] - at) - 2 * kC * rate);
      };
      const double from = static_cast<double>(i) / kSmall, to = static_cast<double>(i + 1) / kSmall;
      const Vec3 a = force(y, v, from), az = kC * (v - z);
      const Vec3 y1 = y + h * v, v1 = v + h * a, z1 = z + h * az;
      y += 0.5 * h * (v + v1);
      z += 0.5 * h * (az + kC * (v1 - z1));
      v += 0.5 * h * (a + force(y1, v1, to));
    }
    x += goes[k];
    slow = slow.after(x, steps[k], kPeriod);
    EXPECT_LT((slow.filtered - y).norm(), 1e-7) << k;
    EXPECT_LT((slow.rate - v).norm(), 1e-7) << k;
    EXPECT_LT((slow.drift - z).norm(), 1e-7) << k;
    EXPECT_LT((slow.place - (y + 2 / kC * z)).norm(), 1e-6) << k;
  }
}

// The filter follows uniform motion without lag, and passes 3 % of waves of a tenth of its period: |c³ + 3 i
// c² w|/|c + i w|³.
TEST(SlowPose, FollowsEvenMotionAndNotWaves) {
  SlowPose slow = SlowPose::at(Vec3::Zero());
  double most = 0;
  for (int i = 1; i <= 4000; ++i) {
    const double t = 0.25 * i;
    slow = slow.after(Vec3(2 * t, 0, 0), 0.25, kPeriod);
    if (t < 600) continue;
    EXPECT_NEAR(slow.place.x(), 2 * t, 1e-6);
    EXPECT_NEAR(slow.drift.x(), 2, 1e-8);
  }
  slow = SlowPose::at(Vec3::Zero());
  for (int i = 1; i <= 4000; ++i) {
    const double t = 0.25 * i;
    slow = slow.after(Vec3(0, std::sin(2 * M_PI * t / 10), 0), 0.25, kPeriod);
    if (t > 600) most = std::max(most, std::abs(slow.place.y()));
  }
  EXPECT_NEAR(most, std::hypot(1, 30) / std::pow(std::hypot(1, 10), 3), 1e-3);
}

TEST(SlowPose, TurnsTheShorterWay) {
  SlowPose slow = SlowPose::at(Vec3(0, 0, 3.1));
  for (int i = 0; i < 10000; ++i) slow = slow.after(Vec3(0, 0, -3.1), 0.1, kPeriod);
  EXPECT_NEAR(slow.place.z(), 2 * M_PI - 3.1, 1e-9);
}

}  // namespace
}  // namespace hawser::slow_pose_test
