// Inertia of a rigid body as the change of its momenta over a step, so that a free body conserves them for
// any step length. See docs/theory/body-contact.md#momentum.
//
// In space axes, with U = R^T v and the mass matrix N = (A, B; B^T, D) about the centre of mass:
//   P = R (A U + B w),   L = R (B^T U + D w)
#pragma once

#include "hawser/kernels/rigid_body.hpp"
#include "hawser/math/alpha_coefficients.hpp"

namespace hawser {

// N: kg, kg m, kg m².
Mat6 momentum_matrix(const RigidBodyData& body);
// The body without the inertia in N.
RigidBodyData without_momentum(const RigidBodyData& body);

// Force [N] and moment [N m] about the centre of mass, or P [N s] and L [N m s]; space axes.
using Wrench = Vec6;
Wrench body_momentum(const Mat6& N, const RigidBodyState& s);
// Rates of P and L for the accelerations of s.
Wrench momentum_rate(const RigidBodyData& body, const RigidBodyState& s);

// State of the scheme between steps (MeanWeights); moments about the centre of mass at the time of the state.
struct MomentumForces {
  Wrench q = Wrench::Zero(), f = Wrench::Zero();
};
// Adds the inertia at the end of a step of h [s] from `start`, and its derivatives: force in space axes,
// moment in body axes.
void add_momentum(const Mat6& N, const MeanWeights& scheme, double h, const RigidBodyState& start,
                  const MomentumForces& from, const RigidBodyState& s, RigidBodyResidual& to);
// Advances q and f over an accepted step.
void advance_momentum(const Mat6& N, const MeanWeights& scheme, double h, const RigidBodyState& start,
                      const RigidBodyState& s, MomentumForces& forces);

}  // namespace hawser
