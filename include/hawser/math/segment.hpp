// The point of a segment that is nearest to another point.
#pragma once

#include <algorithm>

#include "hawser/math/types.hpp"

namespace hawser {

// Fraction of the distance from a to b at which the segment is nearest to p; 0 if it has no length.
inline double nearest_fraction(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  return length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0;
}

// m²
inline double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (p - a - nearest_fraction(p, a, b) * (b - a)).squaredNorm();
}

}  // namespace hawser
