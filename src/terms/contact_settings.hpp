// What the two contact methods, at nodes and along lines, make of the settings of a case in the same way.
#pragma once

#include <vector>

#include "hawser/kernels/volume_contact.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser {

// share: what turns the stiffness basis of the volume into the method's own (N/m a node, N/m² a length);
// diameter [m] of the line there; mass: effective, of the damping, in the same sense.
inline ContactLaw contact_law(const model::Volume& v, double share, double diameter, double mass) {
  ContactLaw law;
  law.normal.stiffness = v.normal_stiffness * share;
  // A fifth of the penetration the automatic stiffness allows: the ramp stays small beside it.
  law.normal.smoothing = v.smoothing > 0 ? v.smoothing : 0.001 * diameter;
  law.normal.damping = contact_damping(v.relative_damping, law.normal.stiffness, mass);
  law.friction.axial = v.friction.axial;
  law.friction.lateral = v.friction.lateral;
  law.friction.stiffness = v.friction.shear_stiffness * share;
  const double length = v.friction.mobilisation_length > 0 ? v.friction.mobilisation_length : 0.01 * diameter;
  law.friction.axial_length = law.friction.lateral_length = length;
  return law;
}

// Space first, then the bodies in their order.
inline void poses_at(const Bodies& bodies, double time, std::vector<RigidPose>& poses) {
  const int n = bodies.size();
  poses.resize(static_cast<size_t>(n) + 1);
  for (int b = 0; b < n; ++b) poses[static_cast<size_t>(b) + 1] = bodies.pose(b, time);
}

}  // namespace hawser
