// A point of one rigid body against the surface of another: normal force on both, exact derivatives.
//
// A point y of body A (its frame; a ball of `radius` around it) meets the signed distance d(z) of body B,
// z = R_B^T (x_A + R_A y - x_B). The gap g = d(z) - radius is a function of the twelve unknowns
// (x_A, theta_A, x_B, theta_B), positions in space axes and rotations as material increments; the force is
// phi'(g) dg/dq, so it keeps momentum and angular momentum, and energy when there is no damping.
#pragma once

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/contact_law.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

// Where a rigid body is and how fast: of the point its unknowns belong to.
struct BodyFrame {
  Vec3 x = Vec3::Zero();      // m
  Mat3 R = Mat3::Identity();  // body axes to space axes
  Vec3 v = Vec3::Zero();      // m/s, space axes
  Vec3 w = Vec3::Zero();      // rad/s, body axes

  Vec3 to_space(const Vec3& y) const { return x + R * y; }
  Vec3 to_body(const Vec3& p) const { return R.transpose() * (p - x); }
};

struct BodyContact {
  Vec12 f = Vec12::Zero();  // residual: minus the force on the bodies
  Mat12 K = Mat12::Zero(), C = Mat12::Zero();
};

struct BodyContactPoint {
  double gap = 0, rate = 0;     // m, m/s
  NormalForce law;              // per weight
  Vec3 normal = Vec3::UnitZ();  // out of B, space axes
  Vec12 gradient;               // of the gap
};

// surface: B's answer at z = B.to_body(A.to_space(y)). Adds `weight` times the law's force to `sum`, and the
// derivatives if `tangent`. No friction.
BodyContactPoint body_contact(const BodyFrame& A, const Vec3& y, double radius, const BodyFrame& B,
                              const SurfacePoint& surface, const NormalLaw& law, double weight, bool tangent,
                              BodyContact& sum);

// The gap by the motion of the two bodies.
Vec12 body_gap_gradient(const BodyFrame& A, const Vec3& y, const BodyFrame& B, const SurfacePoint& surface);

// The residual at y of a unit of weight, and how it changes when y goes on by dy.
struct BodyContactAlong {
  Vec12 f = Vec12::Zero(), slope = Vec12::Zero();
};
BodyContactAlong body_contact_along(const BodyFrame& A, const Vec3& y, const Vec3& dy, double radius,
                                    const BodyFrame& B, const SurfacePoint& surface, const NormalLaw& law);

}  // namespace hawser
