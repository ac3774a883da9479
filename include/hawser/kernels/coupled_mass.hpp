// Inertia of a rigid body beyond mass and moments of inertia: another mass by direction, masses that couple
// ways and turns. By Kirchhoff's equations (Lamb 1932, Hydrodynamics, art. 124) in axes of the body, with
// U = R^T v of the centre of mass and N = (A, B; B^T, D) about it:
//   p = A U + B w,   L = B^T U + D w,   T = (U, w) . N (U, w)/2
//   f = R (p' + w x p),   t = L' + w x L + U x p
// Momentum R p, angular momentum and energy of a body on which nothing acts stay.
#pragma once

#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

// Adds f and t to what is there: the part by accelerations to `inertia`, the rest to `applied`, and their
// exact derivatives to K, C, M. N: kg, kg m, kg m², symmetric.
void add_coupled_mass(const Mat6& N, const RigidBodyState& s, RigidBodyResidual& to);
// J.
double coupled_kinetic(const Mat6& N, const RigidBodyState& s);

// The matrix of the same inertia about another point: M about a point that is s [m] away from there.
//   u_a = u_b - s x w   for s = a - b, so that M_b = T^T M_a T with T = (1, -s^; 0, 1)
Mat6 mass_about(const Mat6& M, const Vec3& s);
// Of a rigid body about its centre of mass.
Mat6 rigid_mass(double mass, const Mat3& inertia);

}  // namespace hawser
