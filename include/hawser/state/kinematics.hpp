// Input of force terms: trial or committed motion of this rank's nodes.
#pragma once

#include <span>

#include "hawser/math/so3.hpp"

namespace hawser {

// Weight of forces that are given as their mean over a step (docs/theory/time-integration.md#cables).
// `weight` is their factor in the residual at the end of a trial step, 4/3 to 2, because the scheme carries a
// part from earlier steps. With the weight 1 the forces are those of the state itself: in statics, at the
// start of the motion, and of an accepted state after which a feeder has moved a node. `filter`: fraction of
// EA with which a cable resists changes of its elongation from step to step.
struct StepMean {
  double weight = 1, filter = 0;

  bool over_step() const { return weight != 1; }  // the forces are means over a step
};

enum class Phase {
  statics,  // no velocities, waves or gusts
  start,    // start of the motion, or its continuation after an event, where forces may be discontinuous
  step      // end of a time step
};

// Arrays run over the local nodes (owned first, then ghosts). Cable nodes carry identity rotations.
struct Kinematics {
  double time = 0;                 // s, of this state
  double step = 0;                 // s, length of the step that led here; at the start of the motion that of
                                   // the step to come, in statics 0
  std::span<const Vec3> x, v, a;   // m, m/s, m/s², space axes
  std::span<const Quat> q;         // rotation: node (material) axes to space axes
  std::span<const Vec3> w, alpha;  // rad/s, rad/s², material axes

  // Accelerations of the columns of the rotation matrix R (directors), 1/s². The time integration computes
  // them from the rates R hat(w), so that momentum is conserved (docs/theory/time-integration.md). Empty: use
  // R (hat(alpha) + hat(w)²).
  std::span<const Mat3> directors = {};
  double director_weight = 0;  // 1/s, derivative of these accelerations by the rates in the trial
  StepMean mean = {};

  Phase phase = Phase::statics;

  // Forces of the motion act; false in statics.
  bool moves() const { return phase != Phase::statics; }
  // A step has led here; false in statics and at the start of the motion.
  bool ends_step() const { return phase == Phase::step; }
  // s, length of the step that led here; 0: none.
  double last_step() const { return ends_step() ? step : 0; }
};

// Acceleration of the directors of a rotation with the rates w and alpha.
inline Mat3 director_acceleration(const Quat& q, const Vec3& w, const Vec3& alpha) {
  const Mat3 W = hat(w);
  return q.toRotationMatrix() * (hat(alpha) + W * W);
}

}  // namespace hawser
