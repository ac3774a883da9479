// Potential, force and derivative of friction under a given normal force.
#include "hawser/kernels/pressed_friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser {
namespace {

// Unit directions along and across the line in the plane of `normal`.
std::array<Vec3, 2> directions(const Vec3& normal, const Vec3& tangent) {
  Vec3 along = tangent - normal * normal.dot(tangent);
  if (!(along.squaredNorm() > 1e-12)) {  // the line is normal to the surface
    along = Vec3::Unit(std::abs(normal.x()) < 0.9 ? 0 : 1);
    along -= normal * normal.dot(along);
  }
  along.normalize();
  return {along, normal.cross(along)};
}

// Slip [m] at which friction is fully mobilised along (0) or across (1) the line.
double mobilisation(const FrictionLaw& law, double N, int i) {
  const double mu = i == 0 ? law.axial : law.lateral;
  if (law.stiffness > 0) return mu * N / law.stiffness;
  return i == 0 ? law.axial_length : law.lateral_length;
}

}  // namespace

// q = k_a s_a² + k_l s_l², rho = (s_a/d_a)² + (s_l/d_l)², k_i = mu_i N/d_i; the potential is q h(rho) with
// h = 1/2 for rho <= 1 and rho^(-1/2) - rho^(-1)/2 beyond (docs/theory/seabed.md).
PressedFriction pressed_friction(const FrictionLaw& law, double N, const Vec3& slip, const Vec3& normal,
                                 const Vec3& tangent, double min_length) {
  PressedFriction r;
  if (!(N > 0)) return r;
  const std::array<Vec3, 2> axes = directions(normal, tangent);
  const double mu[2] = {law.axial, law.lateral};
  Mat3 A = Mat3::Zero();
  Mat3 B = Mat3::Zero();
  for (int i = 0; i < 2; ++i) {
    if (!(mu[i] > 0)) continue;
    const double d = std::max(min_length, mobilisation(law, N, i));
    const Mat3 outer = axes[i] * axes[i].transpose();
    A += mu[i] * N / d * outer;
    B += outer / (d * d);
  }
  const Vec3 As = A * slip;
  const Vec3 Bs = B * slip;
  const double q = slip.dot(As);
  const double rho = slip.dot(Bs);
  double h = 0.5;
  double h1 = 0;
  double h2 = 0;
  if (rho > 1) {
    const double root = 1 / std::sqrt(rho);
    h = root - 0.5 / rho;
    h1 = -0.5 * root / rho + 0.5 / (rho * rho);
    h2 = 0.75 * root / (rho * rho) - 1 / (rho * rho * rho);
  }
  r.potential = q * h;
  r.secant = -2 * h * A - 2 * q * h1 * B;
  r.force = r.secant * slip;
  r.by_slip =
      r.secant - 4 * h1 * (As * Bs.transpose() + Bs * As.transpose()) - 4 * q * h2 * Bs * Bs.transpose();
  return r;
}

Vec3 slip_of_force(const FrictionLaw& law, double N, const Vec3& force, const Vec3& normal,
                   const Vec3& tangent) {
  Vec3 slip = Vec3::Zero();
  if (!(N > 0)) return slip;
  const std::array<Vec3, 2> axes = directions(normal, tangent);
  const double mu[2] = {law.axial, law.lateral};
  for (int i = 0; i < 2; ++i)
    if (mu[i] > 0) slip -= force.dot(axes[i]) * mobilisation(law, N, i) / (mu[i] * N) * axes[i];
  return slip;
}

}  // namespace hawser
