// Rigid body in the coordinates of hydrodynamic coefficients: the velocity of one of its points in fixed axes
// H and its angular velocity in axes J, instead of the unknowns of its centre of mass. See
// docs/theory/platforms.md.
//
// With x, R of the centre of mass, r the point relative to it in body axes, Q = H^T R and P = J^T R:
//   nu = (H^T v + Q (w x r), P w),   nu' = (H^T a + Q (alpha x r + w x (w x r)), P alpha),   nu = G (v, w)
// A generalised force F conjugate to nu acts on the unknowns as G^T F.
#pragma once

#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

// Motion in a state, with derivatives by increments of position and material rotation (by_place) and by w.
struct PlatformMotion {
  Vec6 rate, acceleration;  // m/s, m/s²: in axes H; rad/s, rad/s²: in axes J
  Mat3 Q, P;
  Vec3 heading_by_turn;  // derivative of the angle of J by the material rotation
  Mat6 G;
  Mat6 rate_by_place, acceleration_by_place, acceleration_by_rate;
};
// J = H.
PlatformMotion platform_motion(const Mat3& H, const Vec3& r, const RigidBodyState& s);
// J: the horizontal axes of the body's heading. The derivative of nu by time is without that of J.
PlatformMotion platform_motion_by_heading(const Mat3& H, const Vec3& r, const RigidBodyState& s);
// Rate of platform_motion_by_heading() without derivatives.
Vec6 platform_rate_by_heading(const Mat3& H, const Vec3& r, const RigidBodyState& s);

// d (G^T F) by increments of position and rotation at constant F.
Mat6 platform_force_slope(const PlatformMotion& m, const Vec3& r, const Vec6& F);

// Angle [rad] of the body's x axis about the vertical from +x, and its derivative by the material rotation.
struct Heading {
  double angle = 0;
  Vec3 by_turn = Vec3::Zero();
};
Heading heading_of(const Quat& q);
// x and y [m] of the point r and the heading [rad].
Vec3 place_and_heading(const Vec3& r, const RigidBodyState& s);

// Load by a force and moment at the point r whose components are in axes that turn with the body's heading.
// Residual on the unknowns (minus the load), and its derivative by increments of position and rotation.
struct TurningForce {
  Vec6 force = Vec6::Zero(), by_heading = Vec6::Zero();  // N, N m, axes of the heading; derivative by it
};
struct PlatformLoad {
  Vec6 f = Vec6::Zero();
  Mat6 K = Mat6::Zero();
};
PlatformLoad turning_load(const TurningForce& F, const Vec3& r, const RigidBodyState& s);

// Forces with a potential of the displacement xi = (H^T (p - place), log(H^T R)):
//   V = xi . C xi / 2
// C: N/m, N, N m/rad, symmetric. On the unknowns they act as P^T C xi, with P = d xi / d (x, rotation).
struct PlatformPotential {
  Mat3 axes = Mat3::Identity();  // H
  Vec3 place = Vec3::Zero();     // m, position of the point where xi = 0
  Mat6 stiffness = Mat6::Zero();
};
struct PotentialGradient {
  double potential = 0;   // J
  Vec6 f = Vec6::Zero();  // gradient by the unknowns
  Mat6 K = Mat6::Zero();
};
PotentialGradient platform_gradient(const PlatformPotential& V, const Vec3& r, const RigidBodyState& s);

}  // namespace hawser
