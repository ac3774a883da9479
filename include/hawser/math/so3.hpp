// The rotation group: exponential, logarithm and their right Jacobians, safe at zero angle.
// Conventions: rotations act on column vectors; increments are material (right): R <- R exp(u).
// Sources: Sonneville, Cardona, Brüls (2014) "Geometrically exact beam ... SE(3)", appendix;
// Chirikjian (2011) "Stochastic Models, Information Theory, and Lie Groups" vol. 2, section 10.
#pragma once

#include <cmath>

#include "hawser/math/types.hpp"

namespace hawser {

// hat(a) b = a x b.
inline Mat3 hat(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

// Rotation vector [rad] to unit quaternion.
inline Quat exp_so3(const Vec3& u) {
  const double t2 = u.squaredNorm();
  double c, s;  // cos(t/2), sin(t/2)/t
  if (t2 < 0.01) {
    c = 1 - t2 * (1.0 / 8 - t2 * (1.0 / 384 - t2 * (1.0 / 46080 - t2 * (1.0 / 10321920))));
    s = 0.5 - t2 * (1.0 / 48 - t2 * (1.0 / 3840 - t2 * (1.0 / 645120 - t2 * (1.0 / 185794560))));
  } else {
    const double t = std::sqrt(t2);
    c = std::cos(t / 2);
    s = std::sin(t / 2) / t;
  }
  return {c, s * u.x(), s * u.y(), s * u.z()};
}

// Unit quaternion to the rotation vector of length <= pi.
inline Vec3 log_so3(const Quat& q) {
  const double sign = q.w() < 0 ? -1 : 1;
  const Vec3 v = sign * q.vec();
  const double w = sign * q.w();
  const double n2 = v.squaredNorm();
  if (n2 < 0.0025 * w * w) {  // atan(n/w)/(n/w) to rounding
    const double x = n2 / (w * w);
    const double series = 1 - x * (1.0 / 3 - x * (1.0 / 5 - x * (1.0 / 7 - x * (1.0 / 9 - x * (1.0 / 11)))));
    return (2 / w) * series * v;
  }
  const double n = std::sqrt(n2);
  return (2 * std::atan2(n, w) / n) * v;
}

// Rotation by half the angle of q, the shorter way: exp(log(q)/2).
inline Quat half_rotation(const Quat& q) {
  const double sign = q.w() < 0 ? -1 : 1;
  const Vec3 v = sign * q.vec();
  return Quat(1 + sign * q.w(), v.x(), v.y(), v.z()).normalized();
}

// d exp(u): body-frame angular increment = right_jacobian(u) du.
inline Mat3 right_jacobian(const Vec3& u) {
  const double t2 = u.squaredNorm();
  double a, b;  // (1 - cos t)/t², (t - sin t)/t³
  if (t2 < 1e-4) {
    a = 0.5 - t2 / 24 * (1 - t2 / 30);
    b = 1.0 / 6 - t2 / 120 * (1 - t2 / 42);
  } else {
    const double t = std::sqrt(t2);
    a = (1 - std::cos(t)) / t2;
    b = (t - std::sin(t)) / (t2 * t);
  }
  const Mat3 h = hat(u);
  return Mat3::Identity() - a * h + b * h * h;
}

// Coefficient of hat(u)² in the inverse right Jacobian, J^-1 = I + hat/2 + eta hat², and its (d/dt)/t.
inline void inverse_jacobian_coefficient(double t2, double& eta, double& eta1) {
  if (t2 < 0.05) {
    eta = 1.0 / 12 + t2 * (1.0 / 720 + t2 * (1.0 / 30240 + t2 * (1.0 / 1209600 + t2 / 47900160)));
    eta1 = 1.0 / 360 + t2 * (1.0 / 7560 + t2 * (1.0 / 201600 + t2 * (1.0 / 5987520)));
  } else {
    const double t = std::sqrt(t2);
    const double h = t / 2;
    const double s = std::sin(h);
    const double cot = std::cos(h) / s;
    eta = (1 - h * cot) / t2;
    // eta = 1/t² - cot(h)/(2t)
    eta1 = (-2 / (t2 * t) + cot / (2 * t2) + 1 / (4 * t * s * s)) / t;
  }
}

inline Mat3 inverse_right_jacobian(const Vec3& u) {
  double eta, eta1;
  inverse_jacobian_coefficient(u.squaredNorm(), eta, eta1);
  const Mat3 h = hat(u);
  return Mat3::Identity() + 0.5 * h + eta * h * h;
}

// d (T^-T(phi) p) / d phi at fixed p, T the right Jacobian: T^-T p = p - phi x p / 2 + eta phi x (phi x p).
inline Mat3 inverse_jacobian_transposed_slope(const Vec3& phi, const Vec3& p) {
  double eta, eta1;
  inverse_jacobian_coefficient(phi.squaredNorm(), eta, eta1);
  const Vec3 c = phi.cross(p);
  return 0.5 * hat(p) - eta * (hat(c) + hat(phi) * hat(p)) + eta1 * phi.cross(c) * phi.transpose();
}

// The rotation about (from x to) that takes the unit vector `from` to the unit vector `to`.
Quat minimal_rotation(const Vec3& from, const Vec3& to);

}  // namespace hawser
