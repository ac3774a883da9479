// The work of a moving body through its contact does not depend on the speed of the frame: the energy error
// of a step in which contact begins or ends is the same for a body at rest and for a body in motion.
#include "hawser/terms/contact_work.hpp"

#include <gtest/gtest.h>

namespace hawser {
namespace {

TEST(ContactWork, ErrorOfATouchIsTheSameInEachFrame) {
  ContactPoint p;
  p.weight = 0.2;  // m
  p.normal = Vec3(0, 0.6, 0.8);
  p.force = 500 * p.normal;  // N/m
  p.friction = Vec3::Zero();
  p.damping_force = 0;
  const Mat3 axes = Mat3::Identity();
  const Vec3 y0(0.1, 0.3, 0.5), y1(0.1, 0.28, 0.46);  // m, in the frame of the body
  const double touching = 0.25;                       // fraction of the step in contact, at its end
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.2, -0.1, 0.7)}) {
    RigidPose before, after;
    after.position = before.position + shift;
    ContactWork sum;
    sum.add(StepOfBody(before, after, true), p, axes, y0, y1, touching);
    // In the trapezoidal rule, the line absorbs half of the force times its displacement in space.
    const double taken_up = 0.5 * p.weight * p.force.dot(shift + y1 - y0);
    EXPECT_NEAR(taken_up - sum.work, 0.5 * p.weight * p.force.dot(y1 - y0), 1e-12);
  }
}

}  // namespace
}  // namespace hawser
