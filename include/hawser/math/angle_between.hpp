// Angle between two vectors.
#pragma once

#include <cmath>

#include "hawser/math/types.hpp"

namespace hawser {

// Angle between two vectors, 0 to pi rad, accurate at both ends; 0 if one of them is zero.
inline double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace hawser
