// Kirchhoff's equations of a body with a full mass matrix: forces, exact matrices, kinetic energy.
#include "hawser/kernels/coupled_mass.hpp"

#include "hawser/math/so3.hpp"

namespace hawser {

// U' = R^T a - w x U. With a material increment phi, d(R^T y) = (R^T y)^ phi and d(R y) = -R y^ phi.
void add_coupled_mass(const Mat6& N, const RigidBodyState& s, RigidBodyResidual& to) {
  const Mat3 R = s.q.toRotationMatrix();
  const Mat3 Rt = R.transpose();
  const Vec3 U = Rt * s.v;
  const Vec3 A = Rt * s.a;
  const Vec3 U1 = A - s.w.cross(U);
  Vec6 rate, change, accelerations;
  rate << U, s.w;
  change << U1, s.alpha;
  accelerations << A, s.alpha;
  const Vec6 P = N * rate;
  const Vec3 p = P.head<3>();
  const Vec3 L = P.tail<3>();
  Vec6 turning;
  turning << s.w.cross(p), s.w.cross(L) + U.cross(p);
  const Vec6 by_acceleration = N * accelerations;
  const Vec6 F = N * change + turning;
  const Vec6 other = F - by_acceleration;
  to.inertia.head<3>() += R * by_acceleration.head<3>();
  to.inertia.tail<3>() += by_acceleration.tail<3>();
  to.applied.head<3>() += R * other.head<3>();
  to.applied.tail<3>() += other.tail<3>();

  // Derivatives by (U, w) at fixed accelerations, and by (U', alpha).
  Mat6 by_rate;
  const Mat3 w = hat(s.w);
  by_rate << w * N.topRows<3>(), w * N.bottomRows<3>() + hat(U) * N.topRows<3>();
  by_rate.topRightCorner<3, 3>() -= hat(p);
  by_rate.bottomRightCorner<3, 3>() -= hat(L);
  by_rate.bottomLeftCorner<3, 3>() -= hat(p);
  // dU' = dA - w x dU + U x dw.
  by_rate.leftCols<3>() -= N.leftCols<3>() * w;
  by_rate.rightCols<3>() += N.leftCols<3>() * hat(U);
  Mat6 turn = Mat6::Identity();  // rotates forces to space axes
  turn.topLeftCorner<3, 3>() = R;
  Mat6 K = Mat6::Zero();
  K.rightCols<3>() = by_rate.leftCols<3>() * hat(U) + N.leftCols<3>() * hat(A);
  K.topRightCorner<3, 3>() -= hat(Vec3(F.head<3>()));
  to.K += turn * K;
  Mat6 C = by_rate;
  Mat6 M = N;
  C.leftCols<3>() = by_rate.leftCols<3>() * Rt;
  M.leftCols<3>() = N.leftCols<3>() * Rt;
  to.C += turn * C;
  to.M += turn * M;
}

double coupled_kinetic(const Mat6& N, const RigidBodyState& s) {
  Vec6 rate;
  rate << s.q.conjugate() * s.v, s.w;
  return 0.5 * rate.dot(N * rate);
}

Mat6 mass_about(const Mat6& M, const Vec3& s) {
  Mat6 T = Mat6::Identity();
  T.topRightCorner<3, 3>() = -hat(s);
  return T.transpose() * M * T;
}

Mat6 rigid_mass(double mass, const Mat3& inertia) {
  Mat6 M = Mat6::Zero();
  M.topLeftCorner<3, 3>() = mass * Mat3::Identity();
  M.bottomRightCorner<3, 3>() = inertia;
  return M;
}

}  // namespace hawser
