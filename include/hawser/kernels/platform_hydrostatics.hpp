// Hydrostatic force on a rigid body as the gradient of a potential of its heave and tilt, independent of yaw.
// See docs/theory/platforms.md.
#pragma once

#include "hawser/kernels/platform_frame.hpp"

namespace hawser {

// With O the body's origin, n the upward vertical in body axes and alpha the angle between the body's z axis
// and n:
//   eta = (z_O - level, f n_y, -f n_x),   f = alpha/sin alpha
//   V = eta . C eta / 2 - buoyancy (z_O - level + n . (arm_x, arm_y, 0))
struct PlatformHydrostatics {
  Mat3 stiffness = Mat3::Zero();  // C of heave, roll and pitch, symmetric: N/m, N, N m/rad
  double level = 0;               // m, z of O where eta = 0
  double buoyancy = 0;            // N, upwards
  double arm_x = 0, arm_y = 0;    // m, from O to the centre of buoyancy, body axes
};
// r: from the centre of mass to O, m, body axes.
PotentialGradient hydrostatic_gradient(const PlatformHydrostatics& V, const Vec3& r, const RigidBodyState& s);

}  // namespace hawser
