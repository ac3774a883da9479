// Exact derivative of the contact force by the position along a line, through position, velocity, gap and
// normal of the trial and through the state at the start of the step.
#pragma once

#include "hawser/kernels/surface_contact_law.hpp"

namespace hawser {

// Derivatives of ContactTrial and ContactStart by the place xi on the axis (without unit), body frame.
struct ContactRates {
  Vec3 point = Vec3::Zero(), velocity = Vec3::Zero();             // of the trial: m, m/s
  Vec3 start_point = Vec3::Zero(), start_tangent = Vec3::Zero();  // m; of a unit vector
  Vec3 start_slip = Vec3::Zero(), start_normal = Vec3::Zero();    // m; of a unit vector
  double start_gap = 0, start_peak = 0, roll = 0;                 // m, N or N/m, rad
};

// d force / d xi [N or N/m]. Gap and normal follow the trial's point by normal and curvature. 0 without
// contact.
Vec3 contact_force_along(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                         const ContactRates& by_xi);
// The same for ball_contact(), with the same `turn` for all xi.
Vec3 ball_force_along(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                      const Vec3& turn, const ContactRates& by_xi);

// Slip and normal between two points a and b of the line, and their derivatives by the fraction t (0 at a, 1
// at b). The normal is interpolated, and each slip is rotated to it.
struct SlipBetween {
  Vec3 slip, normal, slip_by_t, normal_by_t;
};
SlipBetween slip_between(const Vec3& slip_a, const Vec3& normal_a, const Vec3& slip_b, const Vec3& normal_b,
                         double t, bool derivatives);

}  // namespace hawser
