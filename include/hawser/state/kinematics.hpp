// What a force term may look at: the trial (or committed) motion of this rank's nodes.
#pragma once

#include <span>

#include "hawser/math/so3.hpp"

namespace hawser {

// Of forces that are given as their mean over the step that led to a trial state
// (docs/theory/time-integration.md#cables): what they count in the residual, more than 1, and the filter of
// the cables. A weight of 1 is that of a state that is not the end of a trial step: its own forces act.
struct StepMean {
  double weight = 1, filter = 0;
};

// Arrays run over the local nodes (owned first, then ghosts). Cable nodes carry identity rotations.
struct Kinematics {
  double time = 0;                 // s, of this state
  double step = 0;                 // s, length of the step that led here; 0 in statics
  std::span<const Vec3> x, v, a;   // m, m/s, m/s², space axes
  std::span<const Quat> q;         // rotation: node (material) axes to space axes
  std::span<const Vec3> w, alpha;  // rad/s, rad/s², material axes

  // Accelerations of the columns of the rotation matrix R, 1/s², as the time integration makes them of their
  // rates R hat(w), so that what they carry of momentum is kept (docs/theory/time-integration.md). Empty:
  // those that belong to w and alpha, R (hat(alpha) + hat(w)²).
  std::span<const Mat3> directors = {};
  double director_weight = 0;  // 1/s, their change in the trial per change of the rates
  StepMean mean = {};
};

// What the directors' acceleration is of a rotation that follows w and alpha.
inline Mat3 director_acceleration(const Quat& q, const Vec3& w, const Vec3& alpha) {
  const Mat3 W = hat(w);
  return q.toRotationMatrix() * (hat(alpha) + W * W);
}

}  // namespace hawser
