// The inertia of a rigid body as the change of its momenta over a step, which a body on which nothing acts
// then keeps at any step. See docs/theory/body-contact.md#momentum.
//
// Axes of space, U = R^T v and N = (A, B; B^T, D) about the centre of mass:
//   P = R (A U + B w),   L = R (B^T U + D w)
// Of a body with a mass only A = B = 0: m v is linear in the unknowns and P has nothing to add.
#pragma once

#include "hawser/kernels/rigid_body.hpp"
#include "hawser/math/alpha_coefficients.hpp"

namespace hawser {

// N: kg, kg m, kg m².
Mat6 momentum_matrix(const RigidBodyData& body);
// The body without what N has.
RigidBodyData without_momentum(const RigidBodyData& body);

// A force and the moment about the centre of mass, or P and L: axes of space.
using Wrench = Vec6;
Wrench body_momentum(const Mat6& N, const RigidBodyState& s);
// The rates of P and L at the accelerations of s.
Wrench momentum_rate(const RigidBodyData& body, const RigidBodyState& s);

// What the scheme carries from step to step (MeanWeights): moments about the centre of mass at its time.
struct MomentumForces {
  Wrench q = Wrench::Zero(), f = Wrench::Zero();
};
// Adds the inertia at the end of a step of h [s] from `start`, and its derivatives, to `to`: f in axes of
// space, the moment in those of the body.
void add_momentum(const Mat6& N, const MeanWeights& scheme, double h, const RigidBodyState& start,
                  const MomentumForces& from, const RigidBodyState& s, RigidBodyResidual& to);
// Advances q and f over an accepted step.
void advance_momentum(const Mat6& N, const MeanWeights& scheme, double h, const RigidBodyState& start,
                      const RigidBodyState& s, MomentumForces& forces);

}  // namespace hawser
