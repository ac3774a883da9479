// Springs and dampers with full matrices between a point of a rigid body and its support, a rigid body that
// moves: the pose and the velocities at which they are at rest. See docs/theory/body-contact.md.
//
// With the point p and the rotation R of the body, the point p0, the rotation H and the angular velocity W0
// of the support, and the velocity v0 of the support at p:
//   xi = (H'(p - p0), log(H'R)),   nu = (H'(p' - v0), H'(R w - W0))
//   V = xi . C xi / 2,   f = P' C xi + G' B nu,   P = d xi / d (x, rotation),   G = d nu / d (v, w)
// They depend on the motion relative to the support alone.
#pragma once

#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

struct SpringMatrixForces {
  Vec6 f = Vec6::Zero();  // residual on the unknowns of the body
  Mat6 K = Mat6::Zero();
  Mat6 C = Mat6::Zero();
  double potential = 0;                 // J
  double dissipated = 0, supplied = 0;  // W, by the dampers and by the moving support
};
// support: pose and velocities of the body's centre of mass at rest, as for rigid_body().
SpringMatrixForces spring_matrix_forces(const SpringMatrices& m, const RigidBodyState& s,
                                        const RigidPose& support);

}  // namespace hawser
