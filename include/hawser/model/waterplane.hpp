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
// that of the point plus x theta_y - y theta_x, in heave, roll and pitch, and in all degrees of freedom.
inline Mat3 upright_from_point(const Eigen::Vector2d& point) {
  Mat3 T = Mat3::Identity();
  T(0, 1) = -point.y();
  T(0, 2) = point.x();
  return T;
}
inline Mat6 motion_from_point(const Eigen::Vector2d& point) {
  Mat6 T = Mat6::Identity();
  T(0, 5) = point.y();
  T(1, 5) = -point.x();
  T(2, 3) = -point.y();
  T(2, 4) = point.x();
  return T;
}

// Metacentric heights of roll and pitch, m: of rotations about the centre of the waterplane, which do not
// change the displaced volume.
Eigen::Vector2d metacentric_heights(const BodyMass& body, const PlatformHydrostatics& calm, double gravity);

}  // namespace hawser::model
