// Path of a ramp and stinger in a vertical plane: straight lengths and arcs that bend downwards.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct PathSegment {
  double length = 0;  // m, > 0
  double radius = 0;  // m, of a downward arc; 0: straight
};

struct PathPoint {
  Vec3 at = Vec3::Zero();                          // m
  Vec3 along = Vec3::UnitX(), up = Vec3::UnitZ();  // unit; up: normal to the path in its vertical plane
  double dip = 0;                                  // rad, inclination of `along` below the horizontal
};

// Unit vector normal to the unit vector `along` in its vertical plane, upwards; not for a vertical one.
Vec3 across(const Vec3& along);

// Unit direction at point i of a sequence of at least two: tangent of the parabola through it and its
// neighbours (at the ends: through the next two), with the distances between them as parameter.
Vec3 direction_at(const std::vector<Vec3>& points, size_t i);

class SupportPath {
 public:
  // direction: unit, not vertical.
  SupportPath(const Vec3& from, const Vec3& direction, std::vector<PathSegment> segments);
  double length() const;         // m
  PathPoint at(double s) const;  // s: arc length, from 0 to length(), m

 private:
  std::vector<PathSegment> segments_;
  std::vector<PathPoint> starts_;  // start points of the segments
};

}  // namespace hawser
