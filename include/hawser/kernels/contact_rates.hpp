// How the force of contact changes along a line: its derivative by the place on the axis, exact, through
// position, velocity, gap and normal of the trial and through what the step started from.
#pragma once

#include "hawser/kernels/surface_contact_law.hpp"

namespace hawser {

// Derivatives of ContactTrial and ContactStart by the place xi on the axis, body frame.
struct ContactRates {
  Vec3 point = Vec3::Zero(), velocity = Vec3::Zero();  // m, m/s a unit of xi; the trial's
  Vec3 start_point = Vec3::Zero(), start_tangent = Vec3::Zero();
  Vec3 start_slip = Vec3::Zero(), start_normal = Vec3::Zero();
  double start_gap = 0, roll = 0;
};

// d force / d xi [N or N/m]. Gap and normal of the trial follow its point by normal and curvature. Zero where
// nothing touches.
Vec3 contact_force_along(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                         const ContactRates& by_xi);
// The same of a ball_contact() whose `turn` is that of all places.
Vec3 ball_force_along(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                      const Vec3& turn, const ContactRates& by_xi);

// Slip and normal between two places a and b of the line at which they are known, and their derivatives by
// the share t (0 at a, 1 at b): the normal in between, each slip turned to it.
struct SlipBetween {
  Vec3 slip, normal, slip_by_t, normal_by_t;
};
SlipBetween slip_between(const Vec3& slip_a, const Vec3& normal_a, const Vec3& slip_b, const Vec3& normal_b,
                         double t, bool derivatives);

}  // namespace hawser
