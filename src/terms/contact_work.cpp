// Work of friction, damping and prescribed bodies at a contact point over a step, from the motion relative to
// the body and the motion of the body.
#include "hawser/terms/contact_work.hpp"

namespace hawser {

StepOfBody::StepOfBody(const RigidPose& before, const RigidPose& after, bool prescribes)
    : R0(before.rotation.toRotationMatrix()),
      R1(after.rotation.toRotationMatrix()),
      shift(after.position - before.position),
      prescribed(prescribes) {}

void ContactWork::add(const StepOfBody& b, const ContactPoint& p, const Mat3& R, const Vec3& y0,
                      const Vec3& y1, double touching) {
  const Vec3 relative = 0.5 * (b.R0 + b.R1) * (y1 - y0);
  const Vec3 carried = b.shift + 0.5 * (b.R1 - b.R0) * (y0 + y1);
  friction -= 0.5 * p.weight * (R * p.friction).dot(relative);
  damping -= 0.5 * touching * p.weight * p.damping_force * (R * p.normal).dot(relative);
  if (b.prescribed) work += 0.5 * p.weight * (R * p.force).dot(carried);
}

}  // namespace hawser
