// Inertia of a rigid body beyond mass and moments of inertia: masses that differ by direction, and coupling
// of translation and rotation. Kirchhoff's equations (Lamb 1932, Hydrodynamics, art. 124) in body axes, with
// U = R^T v of the centre of mass and N = (A, B; B^T, D) about it:
//   p = A U + B w,   L = B^T U + D w,   T = (U, w) . N (U, w)/2
//   f = R (p' + w x p),   t = L' + w x L + U x p
// Momentum R p, angular momentum and energy of a free body are conserved.
#pragma once

#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

// Adds f and t: the acceleration part to `inertia`, the rest to `applied`, and exact derivatives to K, C, M.
// N: kg, kg m, kg m², symmetric.
void add_coupled_mass(const Mat6& N, const RigidBodyState& s, RigidBodyResidual& to);
// Kinetic energy, J.
double coupled_kinetic(const Mat6& N, const RigidBodyState& s);

// Mass matrix about another point that is s [m] away from that of M:
//   u_a = u_b - s x w   for s = a - b, so that M_b = T^T M_a T with T = (1, -s^; 0, 1)
Mat6 mass_about(const Mat6& M, const Vec3& s);
// Mass matrix of a rigid body about its centre of mass.
Mat6 rigid_mass(double mass, const Mat3& inertia);

}  // namespace hawser
