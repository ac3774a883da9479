// Motion of a point fixed to a frame with the position X, the rotation R and the angular velocity w
// (docs/theory/frames.md#the-map-of-a-point):
//   x = X + R y,   v = V + R (w x y)
//   dx = dX + E theta,   dv = dV + E dw + E' theta,   E = -R hat(y),   E' = -R hat(w x y)
// with material increments theta of R. A force f at the point has the moment y x R'f on the frame.
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
  // Derivative of the moment by theta.
  Mat3 moment_by_turn(const Vec3& f) const { return hat(y) * hat(R.transpose() * f); }
  // Positive semidefinite part of this derivative for a residual f along the arm.
  Mat3 convex_moment_by_turn(const Vec3& f) const {
    const double square = std::max(y.squaredNorm(), 1e-300);
    return std::max(-y.dot(R.transpose() * f), 0.0) * (Mat3::Identity() - y * y.transpose() / square);
  }
};

}  // namespace hawser
