// Motion of a point fixed to a frame with the position X, the rotation R and the angular velocity w
// (docs/theory/frames.md#the-map-of-a-point):
//   x = X + R y,   v = V + R (w x y)
//   dx = dX + E theta,   dv = dV + E dw + E' theta,   E = -R hat(y),   E' = -R hat(w x y)
// with material increments theta of R. A force f at the point has the moment m = y x R'f on the frame. Of a
// vector a in space axes,
//   da = -hat(a) R theta if a turns with the frame,   d(R'a) = hat(R'a) theta if a is fixed in space.
#pragma once

#include <algorithm>

#include "hawser/math/so3.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct FramePoint {
  Vec3 y = Vec3::Zero();      // m, arm, frame axes
  Mat3 R = Mat3::Identity();  // frame axes to space axes
  Vec3 w = Vec3::Zero();      // rad/s, frame axes

  Vec3 arm() const { return R * y; }                              // x - X, m
  Vec3 velocity() const { return R * w.cross(y); }                // v - V, m/s
  Mat3 by_turn() const { return -R * hat(y); }                    // E
  Mat3 velocity_by_turn() const { return -R * hat(w.cross(y)); }  // E'
  // f in space axes; the moment in frame axes.
  Vec3 moment(const Vec3& f) const { return y.cross(R.transpose() * f); }
  // Derivative of the moment by theta, f fixed in space and y in the frame.
  Mat3 moment_by_turn(const Vec3& f) const { return hat(y) * hat(R.transpose() * f); }
  // Derivative of the moment by the position x of a point that moves relative to the frame: -R' hat(f).
  Mat3 moment_by_position(const Vec3& f) const { return -R.transpose() * hat(f); }
  // Derivatives by theta of a vector a, space axes, that turns with the frame (a force or a velocity relative
  // to the frame), and of the components R'a of one that is fixed in space.
  Mat3 vector_by_turn(const Vec3& a) const { return -hat(a) * R; }
  Mat3 components_by_turn(const Vec3& a) const { return hat(R.transpose() * a); }
  // Positive semidefinite part of this derivative for a residual f along the arm.
  Mat3 convex_moment_by_turn(const Vec3& f) const {
    const double square = std::max(y.squaredNorm(), 1e-300);
    return std::max(-y.dot(R.transpose() * f), 0.0) * (Mat3::Identity() - y * y.transpose() / square);
  }
};

}  // namespace hawser
