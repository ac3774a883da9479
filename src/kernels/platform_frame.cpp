// Motion of a point of a rigid body in fixed axes, its derivatives, and forces with a potential.
#include "hawser/kernels/platform_frame.hpp"

#include <cmath>

#include "hawser/kernels/frame_point.hpp"
#include "hawser/math/heading.hpp"

namespace hawser {

Vec6 platform_rate(const Mat3& H, const Vec3& r, const RigidBodyState& s) {
  Vec6 rate;
  rate << H.transpose() * (s.v + s.q * s.w.cross(r)), H.transpose() * (s.q * s.w);
  return rate;
}

PlatformMotion platform_motion(const Mat3& H, const Vec3& r, const RigidBodyState& s) {
  PlatformMotion m;
  const Mat3 Ht = H.transpose();
  const Mat3 Q = Ht * s.q.toRotationMatrix();
  const FramePoint point{r, Q, s.w};
  const Vec3 turning = s.w.cross(r);
  const Vec3 lift = s.alpha.cross(r) + s.w.cross(turning);
  m.rate = platform_rate(H, r, s);
  m.acceleration << Ht * s.a + Q * lift, Q * s.alpha;
  m.G << Ht, point.by_turn(), Mat3::Zero(), Q;
  m.rate_by_place << Mat3::Zero(), point.velocity_by_turn(), Mat3::Zero(), -Q * hat(s.w);
  m.acceleration_by_place << Mat3::Zero(), -Q * hat(lift), Mat3::Zero(), -Q * hat(s.alpha);
  m.acceleration_by_rate << Mat3::Zero(), -Q * (hat(turning) + hat(s.w) * hat(r)), Mat3::Zero(), Mat3::Zero();
  return m;
}

// G^T F = (H F_p, r x Q^T F_p + Q^T F_t), and d (Q^T y) = hat(Q^T y) d phi.
Mat6 platform_force_slope(const PlatformMotion& m, const Vec3& r, const Vec6& F) {
  const Mat3 Q = m.G.bottomRightCorner<3, 3>();
  Mat6 K = Mat6::Zero();
  const FramePoint point{r, Q};
  K.bottomRightCorner<3, 3>() = point.moment_by_turn(F.head<3>()) + point.components_by_turn(F.tail<3>());
  return K;
}

Vec3 place_and_heading(const Vec3& r, const RigidBodyState& s) {
  const Vec3 at = s.x + s.q * r;
  return {at.x(), at.y(), heading_of(s.q).angle};
}

Heading heading_of(const Quat& q) {
  const Vec3 bow = q * Vec3::UnitX();
  Heading out;
  out.angle = std::atan2(bow.y(), bow.x());
  // d bow = R (dphi x e_x) = R (0, dphi_z, -dphi_y).
  const Vec3 by_z = q * Vec3::UnitY();
  const Vec3 by_y = -(q * Vec3::UnitZ());
  // A body whose bow points vertically has no heading; this bounds the derivative.
  const double square = std::max(bow.head<2>().squaredNorm(), 1e-6);
  const auto slope = [&](const Vec3& d) { return (bow.x() * d.y() - bow.y() * d.x()) / square; };
  out.by_turn = Vec3(0, slope(by_y), slope(by_z));
  return out;
}

PlatformLoad turning_load(const TurningForce& F, const Vec3& r, const RigidBodyState& s) {
  const Heading heading = heading_of(s.q);
  const Mat3 H = heading_axes(heading.angle);
  Vec6 in_space;
  Vec6 change = F.by_heading;
  change.head<3>() += Vec3::UnitZ().cross(F.force.head<3>());
  change.tail<3>() += Vec3::UnitZ().cross(F.force.tail<3>());
  in_space << H * F.force.head<3>(), H * F.force.tail<3>();
  change << H * change.head<3>().eval(), H * change.tail<3>().eval();
  const PlatformMotion m = platform_motion(Mat3::Identity(), r, s);
  PlatformLoad out;
  out.f = -m.G.transpose() * in_space;
  out.K = -platform_force_slope(m, r, in_space);
  out.K.rightCols<3>() -= m.G.transpose() * change * heading.by_turn.transpose();
  return out;
}

// P = [H^T, -Q hat(r); 0, T^-1(theta)] with T the right Jacobian: d theta = T^-1 d phi.
PotentialGradient platform_gradient(const PlatformPotential& V, const Vec3& r, const RigidBodyState& s) {
  PotentialGradient out;
  const Mat3 Ht = V.axes.transpose();
  const Mat3 Q = Ht * s.q.toRotationMatrix();
  const Vec3 theta = log_so3(Quat(V.axes).conjugate() * s.q);
  Vec6 displacement;
  displacement << Ht * (s.x + s.q * r - V.place), theta;
  const Vec6 F = V.stiffness * displacement;
  out.potential = 0.5 * displacement.dot(F);
  const Mat3 T = inverse_right_jacobian(theta);
  Mat6 P;
  const FramePoint point{r, Q};
  P << Ht, point.by_turn(), Mat3::Zero(), T;
  out.f = P.transpose() * F;
  out.K = P.transpose() * V.stiffness * P;
  out.K.bottomRightCorner<3, 3>() +=
      point.moment_by_turn(F.head<3>()) + inverse_jacobian_transposed_slope(theta, F.tail<3>()) * T;
  return out;
}

}  // namespace hawser
