// Work and energies of contact with volumes by the trapezoidal rule over the accepted steps.
#pragma once

#include "hawser/kernels/contact_point.hpp"
#include "hawser/kernels/motion.hpp"

namespace hawser {

struct Penetration {
  double depth = 0;  // m
  int node = -1;     // mesh node; -1: none
  int volume = -1;
  double time = 0;  // s
};

// Motion of a volume's body over a step, for the work of contact forces by the trapezoidal rule. A point
// moves from y0 to y1 in the body frame. Its displacement splits exactly into that of the body's material and
// that relative to the body:
//   x1 - x0 = [p1 - p0 + (R1 - R0)(y0 + y1)/2] + (R0 + R1)/2 (y1 - y0).
struct StepOfBody {
  Mat3 R0, R1;
  Vec3 shift;
  bool prescribed;  // the body's motion is prescribed; for a floating body the work on line and body cancels
  StepOfBody(const RigidPose& before, const RigidPose& after, bool prescribes);
};

// Sums of an element over the accepted steps.
struct ContactWork {
  double friction = 0, damping = 0, work = 0;  // J
  double depth = 0, time = 0;                  // largest penetration, m, and its time, s
  int volume = -1, end = 0;  // volume of the largest penetration; the nearer end of the element

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
  // Adds half of the work of the point's forces on its path from y0 to y1. touching: fraction of the path
  // along the normal in which the point is in contact; normal forces act on it only, friction on the whole
  // path.
  void add(const StepOfBody& b, const ContactPoint& p, const Mat3& R, const Vec3& y0, const Vec3& y1,
           double touching);
};

}  // namespace hawser
