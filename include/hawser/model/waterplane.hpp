// Centre of the waterplane of a platform, about which heave is uncoupled from roll and pitch.
#pragma once

#include "hawser/math/types.hpp"
#include "hawser/model/platform.hpp"

namespace hawser::model {

// From the body's origin, m, of C of heave, roll and pitch about it; the origin itself without a waterplane:
//   C33 = rho g int dS,   C34 = rho g int y dS,   C35 = -rho g int x dS
inline Eigen::Vector2d waterplane_centre(const Mat3& C) {
  return C(0, 0) > 0 ? Eigen::Vector2d(-C(0, 2) / C(0, 0), C(0, 1) / C(0, 0)) : Eigen::Vector2d::Zero();
}

// Motion of the origin by one of a point at this horizontal distance from it: the heave of the origin is
// that of the point plus x theta_y - y theta_x.
inline Mat6 motion_from_point(const Eigen::Vector2d& point) {
  Mat6 T = Mat6::Identity();
  T(0, 5) = point.y();
  T(1, 5) = -point.x();
  T(2, 3) = -point.y();
  T(2, 4) = point.x();
  return T;
}

// Stiffness C of heave, roll and pitch about the body's origin, transferred to the centre of the waterplane.
inline Mat3 about_waterplane_centre(const Mat3& C) {
  const Mat3 T = motion_from_point(waterplane_centre(C)).block<3, 3>(2, 2);
  return T.transpose() * C * T;
}

// Metacentric heights of roll and pitch, m, of a body with this stiffness of heave, roll and pitch, weight
// included: of rotations about the centre of the waterplane, which do not change the displaced volume.
// weight: N.
Eigen::Vector2d metacentric_heights(const Mat3& C, double weight);

}  // namespace hawser::model
