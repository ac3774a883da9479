// The twist angle between two attitudes of a node by swing-twist decomposition, with its first and second
// derivatives for the tangent of friction with volumes.
#include "hawser/kernels/axis_roll.hpp"

#include <cmath>

#include "hawser/math/so3.hpp"

namespace hawser {

// With q = q1 q0^-1 = (w, v) and the tangents t0, t1: angle = 2 atan(v.t0 / w), the twist of the swing-twist
// decomposition. Its derivative is g.dtheta, g = (t0 + t1)/(1 + t0.t1), for a small rotation dtheta in fixed
// axes.
AxisRoll axis_roll(const Quat& q0, const Quat& q1, const Vec3& c) {
  const Vec3 t0 = q0 * c;
  const Vec3 t1 = q1 * c;
  const Quat q = q1 * q0.conjugate();
  AxisRoll r;
  const double sign = q.w() < 0 ? -1 : 1;
  r.angle = 2 * std::atan2(sign * q.vec().dot(t0), sign * q.w());
  const double opening = 1 + t0.dot(t1);
  const Vec3 g = (t0 + t1) / opening;
  const Mat3 g_by_turn = (-hat(t1) - g * t1.cross(t0).transpose()) / opening;
  const Mat3 R = q1.toRotationMatrix();
  r.by_turn = R.transpose() * g;
  r.by_turn_turn = hat(r.by_turn) + R.transpose() * g_by_turn * R;
  return r;
}

}  // namespace hawser
