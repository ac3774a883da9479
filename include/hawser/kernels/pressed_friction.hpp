// Friction of a point pressed onto a surface by a given normal force, as the gradient of a potential. Statics
// minimises this potential before the normal force depends on the trial ("Tresca's friction"; Kikuchi & Oden
// 1988, Contact Problems in Elasticity, chapter 10).
#pragma once

#include "hawser/kernels/friction_law.hpp"

namespace hawser {

struct PressedFriction {
  double potential = 0;         // J
  Vec3 force = Vec3::Zero();    // N, on the point
  Mat3 by_slip = Mat3::Zero();  // N/m, derivative of the force by the slip
  Mat3 secant = Mat3::Zero();   // N/m, secant stiffness: force = secant * slip
};

// The slip s [m, space axes] has the components s_a along the line and s_l across it in the plane of
// `normal`. N [N] is the normal force, d_i the mobilisation length (mu_i N divided by the shear stiffness),
// at least `min_length` [m], and k_i = mu_i N / d_i:
//   q = k_a s_a² + k_l s_l²,  rho = (s_a/d_a)² + (s_l/d_l)²,
//   potential = q/2 for rho <= 1,  q (rho^(-1/2) - rho^(-1)/2) beyond;  force = -d potential / d s.
// The force is continuous; its derivative jumps at rho = 1. For equal coefficients and lengths it is that of
// friction_law.hpp. tangent: direction of the line, unit vector, need not lie in the plane. Coefficients are
// those at rest.
PressedFriction pressed_friction(const FrictionLaw& law, double N, const Vec3& slip, const Vec3& normal,
                                 const Vec3& tangent, double min_length = 0);

// Slip [m] at which friction_law.hpp gives this force [N] under the normal force N, in the plane of `normal`:
// (s_a, s_l) = -(f_a d_a/(mu_a N), f_l d_l/(mu_l N)).
Vec3 slip_of_force(const FrictionLaw& law, double N, const Vec3& force, const Vec3& normal,
                   const Vec3& tangent);

}  // namespace hawser
