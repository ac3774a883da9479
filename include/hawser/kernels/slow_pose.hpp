// Position and heading of a body without motion faster than a given period: a low-pass filter without lag in
// uniform motion, exact for steps with uniform motion. See docs/theory/platforms.md, "Slow place and
// heading".
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Filter of order N for x and y. At high frequencies its gain decreases as omega^(1 - N); at low ones it is
// up to 1.5 (N = 5). The heading is filtered by third order: mean forces depend on it, and the lag of their
// moment acts as negative damping, which is larger for higher orders. Vectors contain x, y [m] and heading
// [rad].
template <int N>
struct SlowPose {
  Vec3 place = Vec3::Zero();  // slow pose
  Vec3 drift = Vec3::Zero();  // velocity of the filtered pose: in uniform motion that of `place`, smoother
  Vec3 speed = Vec3::Zero();  // time derivative of `place`
  Vec3 last = Vec3::Zero();   // last pose of the body
  Eigen::Vector<double, 3 * N> delayed = Eigen::Vector<double, 3 * N>::Zero();  // y_1 ... y_N

  // State of a body at rest at `pose`.
  static SlowPose at(const Vec3& pose);
  // State after a step of h [s] to `pose`; the heading changes the shorter way round. period: s.
  SlowPose after(const Vec3& pose, double h, double period) const;
  // Derivatives of `place` and `speed` by that pose: 1 and 1/s.
  struct Derivatives {
    double place = 0, speed = 0;
  };
  static Derivatives derivatives(double h, double period);

  // Entries of a checkpoint.
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("slow place and heading", "m, rad", self.place);
    each("their smooth velocity", "m/s, rad/s", self.drift);
    each("their velocity", "m/s, rad/s", self.speed);
    each("place and heading", "m, rad", self.last);
    each("filtered place and heading", "m, rad", self.delayed);
  }
};

using ControllerPose = SlowPose<3>;  // of dynamic positioning: little delay
using WavePose = SlowPose<5>;        // of wave forces: 0.05 % of motion with a tenth of the period

}  // namespace hawser
