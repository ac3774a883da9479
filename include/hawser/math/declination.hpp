// Angle of a direction from the vertical.
#pragma once

#include <cmath>

#include "hawser/math/types.hpp"

namespace hawser {

// rad, from 0 (straight up) to pi (straight down); `along`: any length > 0. Exact to rounding.
inline double declination(const Vec3& along) {
  return std::atan2(std::hypot(along.x(), along.y()), along.z());
}

inline double degrees(double radians) { return radians * 180 / M_PI; }

}  // namespace hawser
