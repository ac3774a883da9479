// Hydrostatic force on a rigid body from its heave and tilt, with its exact tangent.
#include "hawser/kernels/platform_hydrostatics.hpp"

#include <cmath>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// alpha/sin alpha with its derivatives by cos alpha.
struct AngleOverSine {
  double value = 1, first = 0, second = 0;
};

// With c = cos alpha, (1 - c²) f' = c f - 1 and (1 - c²) f'' = f + 3 c f'. For small alpha the series
//   f = 1 + u/3 (1 + 2 u/5 (1 + 3 u/7 (1 + ...))),   u = 1 - c
AngleOverSine angle_over_sine(double sine, double cosine) {
  constexpr double kSmall = 0.1;  // of u
  constexpr int kTerms = 14;
  AngleOverSine f;
  const double square = sine * sine;
  const double u = square / (1 + cosine);
  if (cosine > 1 - kSmall) {
    for (int k = kTerms; k > 0; --k) {
      const double ratio = k / (2.0 * k + 1);
      f.second = ratio * (2 * f.first + u * f.second);
      f.first = ratio * (f.value + u * f.first);
      f.value = 1 + ratio * u * f.value;
    }
    f.first = -f.first;
    return f;
  }
  f.value = std::atan2(sine, cosine) / sine;
  f.first = (cosine * f.value - 1) / square;
  f.second = (f.value + 3 * cosine * f.first) / square;
  return f;
}

}  // namespace

// Derivatives by y = (z_O, n), with d z_O = e_z . dx + (r x n) . phi and dn = n x phi for a material rotation
// phi:
//   U' = E^T C eta - buoyancy (1, arm_x, arm_y, 0),   E = d eta/dy
//   U'' = E^T C E + sum_k (C eta)_k eta_k''
//   f = L^T U',   K = L^T U'' L + (derivative of L^T at fixed U'),   L = dy/d (x, phi)
// The moment is g x n with g = U_z r + U_n, so the derivative of L^T is hat(g) hat(n) on the rotations.
PotentialGradient hydrostatic_gradient(const PlatformHydrostatics& V, const Vec3& r,
                                       const RigidBodyState& s) {
  const Vec3 n = s.q.conjugate() * Vec3::UnitZ();
  const AngleOverSine f = angle_over_sine(std::hypot(n.x(), n.y()), n.z());
  const double heave = s.x.z() + r.dot(n) - V.level;
  const Vec3 eta(heave, f.value * n.y(), -f.value * n.x());
  using Vec4 = Eigen::Vector4d;
  using Mat4 = Eigen::Matrix4d;
  Eigen::Matrix<double, 3, 4> E;
  E << 1, 0, 0, 0,                     //
      0, 0, f.value, f.first * n.y(),  //
      0, -f.value, 0, -f.first * n.x();
  const Vec3 restoring = V.stiffness * eta;
  const Vec4 up(1, V.arm_x, V.arm_y, 0);
  const Vec4 slope = E.transpose() * restoring - V.buoyancy * up;
  Mat4 curve = E.transpose() * V.stiffness * E;
  curve(1, 3) -= restoring[2] * f.first;
  curve(3, 1) -= restoring[2] * f.first;
  curve(2, 3) += restoring[1] * f.first;
  curve(3, 2) += restoring[1] * f.first;
  curve(3, 3) += (restoring[1] * n.y() - restoring[2] * n.x()) * f.second;
  Eigen::Matrix<double, 4, 6> L = Eigen::Matrix<double, 4, 6>::Zero();
  L(0, 2) = 1;
  L.topRightCorner<1, 3>() = r.cross(n).transpose();
  L.bottomRightCorner<3, 3>() = hat(n);
  const Vec3 g = slope[0] * r + slope.tail<3>();
  PotentialGradient out;
  out.potential = 0.5 * eta.dot(restoring) - V.buoyancy * (heave + V.arm_x * n.x() + V.arm_y * n.y());
  out.f = L.transpose() * slope;
  out.K = L.transpose() * curve * L;
  out.K.bottomRightCorner<3, 3>() += hat(g) * hat(n);
  return out;
}

}  // namespace hawser
