// Place and heading of a body without its motion that is faster than a period: a low-pass filter of third
// order that follows even motion without lag, exact for steps in which the body moves evenly. See
// docs/theory/platforms.md.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// x, y [m] and heading [rad] in one vector.
struct SlowPose {
  Vec3 place = Vec3::Zero();                          // the slow one
  Vec3 drift = Vec3::Zero();                          // its velocity
  Vec3 filtered = Vec3::Zero(), rate = Vec3::Zero();  // the state of the filter
  Vec3 last = Vec3::Zero();                           // where the body itself was

  // The derivative of `place` by time; without lag in even motion, as `drift` is not in motion that grows.
  Vec3 speed() const { return 3 * rate - 2 * drift; }

  // Of a body at rest there.
  static SlowPose at(const Vec3& pose);
  // After a step of h [s] to there; the heading goes the shorter way round. period [s].
  SlowPose after(const Vec3& pose, double h, double period) const;
  // The derivatives of its `place` and `speed()` by that pose: 1 and 1/s.
  struct Share {
    double place = 0, speed = 0;
  };
  static Share share(double h, double period);
};

}  // namespace hawser
