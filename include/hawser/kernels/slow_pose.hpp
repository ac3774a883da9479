// Position and heading of a body without motion faster than a given period: a low-pass filter of third order
// without lag in uniform motion, exact for steps with uniform motion. See docs/theory/platforms.md.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Vectors contain x, y [m] and heading [rad].
struct SlowPose {
  Vec3 place = Vec3::Zero();                          // slow pose
  Vec3 drift = Vec3::Zero();                          // velocity of the slow pose
  Vec3 filtered = Vec3::Zero(), rate = Vec3::Zero();  // state of the filter
  Vec3 last = Vec3::Zero();                           // last pose of the body

  // Time derivative of `place`; without lag in uniform motion, where `drift` has none in accelerated motion.
  Vec3 speed() const { return 3 * rate - 2 * drift; }

  // State of a body at rest at `pose`.
  static SlowPose at(const Vec3& pose);
  // State after a step of h [s] to `pose`; the heading changes the shorter way round. period: s.
  SlowPose after(const Vec3& pose, double h, double period) const;
  // Derivatives of `place` and `speed()` by that pose: 1 and 1/s.
  struct Derivatives {
    double place = 0, speed = 0;
  };
  static Derivatives derivatives(double h, double period);
};

}  // namespace hawser
