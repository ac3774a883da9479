// Motion of a rigid body in the axes of hydrodynamic coefficients, its derivatives, and forces with a
// potential.
#include "hawser/kernels/platform_frame.hpp"

#include <cmath>

#include "hawser/kernels/frame_point.hpp"
#include "hawser/math/heading.hpp"

namespace hawser {

namespace {

Vec6 platform_rate(const Mat3& H, const Mat3& J, const Vec3& r, const RigidBodyState& s) {
  Vec6 rate;
  rate << H.transpose() * (s.v + s.q * s.w.cross(r)), J.transpose() * (s.q * s.w);
  return rate;
}

// psi: angle of J. d(J^T y) = -e_z x J^T y dpsi at constant y.
PlatformMotion platform_motion(const Mat3& H, const Mat3& J, const Vec3& psi_by_turn, const Vec3& r,
                               const RigidBodyState& s) {
  PlatformMotion m;
  const Mat3 Ht = H.transpose();
  const Mat3 R = s.q.toRotationMatrix();
  m.Q = Ht * R;
  m.P = J.transpose() * R;
  m.heading_by_turn = psi_by_turn;
  const FramePoint point{r, m.Q, s.w};
  const Vec3 turning = s.w.cross(r);
  const Vec3 lift = s.alpha.cross(r) + s.w.cross(turning);
  const auto components_by_turn = [&m](const Vec3& y) -> Mat3 {
    return -m.P * hat(y) - Vec3::UnitZ().cross(m.P * y) * m.heading_by_turn.transpose();
  };
  m.rate = platform_rate(H, J, r, s);
  m.acceleration << Ht * s.a + m.Q * lift, m.P * s.alpha;
  m.G << Ht, point.by_turn(), Mat3::Zero(), m.P;
  m.rate_by_place << Mat3::Zero(), point.velocity_by_turn(), Mat3::Zero(), components_by_turn(s.w);
  m.acceleration_by_place << Mat3::Zero(), -m.Q * hat(lift), Mat3::Zero(), components_by_turn(s.alpha);
  m.acceleration_by_rate << Mat3::Zero(), -m.Q * (hat(turning) + hat(s.w) * hat(r)), Mat3::Zero(),
      Mat3::Zero();
  return m;
}

}  // namespace

PlatformMotion platform_motion(const Mat3& H, const Vec3& r, const RigidBodyState& s) {
  return platform_motion(H, H, Vec3::Zero(), r, s);
}

PlatformMotion platform_motion_by_heading(const Mat3& H, const Vec3& r, const RigidBodyState& s) {
  const Heading heading = heading_of(s.q);
  return platform_motion(H, heading_axes(heading.angle), heading.by_turn, r, s);
}

Vec6 platform_rate_by_heading(const Mat3& H, const Vec3& r, const RigidBodyState& s) {
  return platform_rate(H, heading_axes(heading_of(s.q).angle), r, s);
}

// G^T F = (H F_p, r x Q^T F_p + P^T F_t); d (Q^T y) = hat(Q^T y) d phi, d (P^T y) = hat(P^T y) d phi
// + P^T (e_z x y) d psi.
Mat6 platform_force_slope(const PlatformMotion& m, const Vec3& r, const Vec6& F) {
  Mat6 K = Mat6::Zero();
  const FramePoint point{r, m.Q};
  const Vec3 moment = F.tail<3>();
  K.bottomRightCorner<3, 3>() = point.moment_by_turn(F.head<3>()) +
                                FramePoint{r, m.P}.components_by_turn(moment) +
                                m.P.transpose() * Vec3::UnitZ().cross(moment) * m.heading_by_turn.transpose();
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
