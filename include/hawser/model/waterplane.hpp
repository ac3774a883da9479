// Centre of the waterplane of a platform, about which heave is uncoupled from roll and pitch.
#pragma once

#include "hawser/math/so3.hpp"
#include "hawser/math/types.hpp"
#include "hawser/model/platform.hpp"

namespace hawser::model {

// From the body's origin, m, of C of heave, roll and pitch about it; the origin itself without a waterplane:
//   C33 = rho g int dS,   C34 = rho g int y dS,   C35 = -rho g int x dS
inline Eigen::Vector2d waterplane_centre(const Mat3& C) {
  return C(0, 0) > 0 ? Eigen::Vector2d(-C(0, 2) / C(0, 0), C(0, 1) / C(0, 0)) : Eigen::Vector2d::Zero();
}

// Motion of the origin by one of a point at this place [m] from it: the displacement of the origin is that of
// the point plus point x theta.
inline Mat6 motion_from_point(const Vec3& point) {
  Mat6 T = Mat6::Identity();
  T.topRightCorner<3, 3>() = hat(point);
  return T;
}
inline Mat6 motion_from_point(const Eigen::Vector2d& point) {
  return motion_from_point(Vec3(point.x(), point.y(), 0));
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
