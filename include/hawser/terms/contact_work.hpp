// Work and energies of contact with volumes, by the trapezoidal rule over the accepted steps.
#pragma once

#include "hawser/kernels/contact_point.hpp"
#include "hawser/kernels/motion.hpp"

namespace hawser {

struct Penetration {
  double depth = 0;  // m
  int node = -1;     // mesh node, -1: none yet
  int volume = -1;
  double time = 0;  // s
};

// One end of a step of the trapezoid: forces of the history p, which act with the body turned by R, on the
// way y0 -> y1 (body frame). The motion splits exactly into that of the body's material and that relative to
// it: x1 - x0 = [p1 - p0 + (R1 - R0)(y0 + y1)/2] + (R0 + R1)/2 (y1 - y0).
struct StepOfBody {
  Mat3 R0, R1;
  Vec3 shift;
  bool prescribed;  // its motion is; a floating body loses the work that it does, so that the sum is zero
  StepOfBody(const RigidPose& before, const RigidPose& after, bool prescribes);
};

// Sums of an element over the accepted steps.
struct ContactWork {
  double friction = 0, damping = 0, work = 0;  // J
  double depth = 0, time = 0;                  // m, s: largest penetration
  int volume = -1, end = 0;                    // of that; which end of the element is nearer

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("friction", "J", self.friction);
    each("damping", "J", self.damping);
    each("work", "J", self.work);
    each("largest penetration", "m", self.depth);
    each("time of it", "s", self.time);
    each("volume", "", self.volume);
    each("end", "", self.end);
  }

  bool empty() const { return !(depth > 0 || friction != 0 || damping != 0 || work != 0); }
  void reaches(double deep, double at, int into, int near) {
    if (deep > depth) {
      depth = deep;
      time = at;
      volume = into;
      end = near;
    }
  }
  // Half of the work of the point's forces on the way y0 -> y1. touching: part of the way along the normal on
  // which it touches; normal forces act there alone, friction by the trapezoidal rule on all of the way.
  void add(const StepOfBody& b, const ContactPoint& p, const Mat3& R, const Vec3& y0, const Vec3& y1,
           double touching);
};

}  // namespace hawser
