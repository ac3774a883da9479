// Soil around a buried piece of line: elastic-perfectly plastic springs along and across it. See
// docs/theory/seabed.md, "In the soil". A line whose springs all yield is the inverse catenary of Neubecker &
// Randolph (1995): dT/ds = Q_a, T dtheta/ds = Q_n, with the resistances Q per length.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

struct BuriedSoil {
  double axial = 0, normal = 0;                // N, resistances
  double axial_length = 0, normal_length = 0;  // m, slip at which the resistances are reached
};

struct BuriedForce {
  Vec3 force = Vec3::Zero();  // N, on the line
  Vec3 slip = Vec3::Zero();   // m, remaining elastic slip
  double stored = 0;          // J, in the springs
  double potential = 0;       // J, including plastic work from zero slip: convex, with the gradient -force
  Mat3 stiffness = Mat3::Zero();  // N/m, -d force / d slip; symmetric, never negative
};

// Force at the slip [m] of the trial; tangent: unit. Axial and transverse directions are independent: f_a =
// -k_a s_a, limited to the resistance, and f_n = -k_n s_n in the transverse plane, limited in magnitude.
inline BuriedForce buried_force(const BuriedSoil& soil, const Vec3& slip, const Vec3& tangent) {
  BuriedForce r;
  const Mat3 along = tangent * tangent.transpose();
  const Mat3 across = Mat3::Identity() - along;
  const auto add = [&r](double resistance, double length, const Vec3& part, const Mat3& plane) {
    const double k = resistance / length;
    const double s = part.norm();
    if (s <= length) {
      r.force -= k * part;
      r.slip += part;
      r.stored += 0.5 * k * s * s;
      r.potential += 0.5 * k * s * s;
      r.stiffness += k * plane;
      return;
    }
    const Vec3 direction = part / s;
    r.force -= resistance * direction;
    r.slip += length * direction;
    r.stored += 0.5 * resistance * length;
    r.potential += resistance * (s - 0.5 * length);
    r.stiffness += resistance / s * (plane - direction * direction.transpose());
  };
  add(soil.axial, soil.axial_length, tangent * tangent.dot(slip), along);
  add(soil.normal, soil.normal_length, across * slip, across);
  return r;
}

}  // namespace hawser
