// Roll of a node about its line: known rotations, independence of bending, and derivatives against
// differences.
#include "hawser/kernels/axis_roll.hpp"

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"

namespace hawser::axis_roll_test {
namespace {

TEST(AxisRoll, KnownTurns) {
  const Quat q0 = exp_so3({0.4, -1.1, 0.3});
  const Vec3 c = Vec3(1, 2, -1).normalized();
  EXPECT_NEAR(axis_roll(q0, q0, c).angle, 0, 1e-15);
  for (const double angle : {-2.5, -0.3, 0.7, 2.9}) {
    EXPECT_NEAR(axis_roll(q0, q0 * exp_so3(angle * c), c).angle, angle, 1e-14);
    // A preceding rotation about an axis normal to the tangent does not change the roll.
    const Vec3 across = (q0 * c).cross(Vec3(0.3, 0.8, 1.2));
    EXPECT_NEAR(axis_roll(q0, exp_so3(across) * q0 * exp_so3(angle * c), c).angle, angle, 1e-14);
  }
}

TEST(AxisRoll, Derivatives) {
  const Quat q0 = exp_so3({0.4, -1.1, 0.3});
  const Quat q1 = exp_so3({0.9, -0.6, 0.1});
  const Vec3 c = Vec3(1, 2, -1).normalized();
  const Vec3 d(0.5, -0.7, 0.3);
  const auto at = [&](double e) { return axis_roll(q0, q1 * exp_so3(e * d), c); };
  const AxisRoll r = at(0);
  constexpr double e = 1e-3;
  const auto difference = [&](auto value) -> decltype(value(0.0)) {
    return ((8 * (value(e) - value(-e)) - (value(2 * e) - value(-2 * e))) / (12 * e));
  };
  EXPECT_NEAR(r.by_turn.dot(d), difference([&](double x) { return at(x).angle; }), 1e-11);
  const Vec3 second = difference([&](double x) -> Vec3 { return at(x).by_turn; });
  EXPECT_LT((r.by_turn_turn * d - second).norm(), 1e-10);
  EXPECT_GT(second.norm(), 0.01);
}

}  // namespace
}  // namespace hawser::axis_roll_test
