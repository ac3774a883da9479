// Point of an element's axis that is nearest to a given point.
#pragma once

#include "hawser/kernels/axis_shape.hpp"

namespace hawser {

struct AxisProjection {
  double eta = 0;               // position of the nearest point y
  bool inside = false;          // (x - y) . y' = 0 at y; else y is an end of the element
  Vec3 away = Vec3::Zero();     // m, x - y
  Vec3 normal = Vec3::UnitZ();  // unit vector along `away`
  double distance = 0;          // m
};

// Nearest point of the whole element including its ends. The nearest of five points is the start of a
// bracketed Newton iteration. Correct for elements that turn by less than about a right angle, and for points
// nearer than the element's radius of curvature.
AxisProjection closest_point_on(const AxisShape& axis, const Vec3& x);

// The same quantities for a given position eta.
AxisProjection point_at(const AxisShape& axis, double eta, const Vec3& x);

// A chain of elements has one distance field: the sum over its elements of phi(distance to the element) minus
// the sum over its joints of phi(distance to the joint). For a point beyond a joint, both elements have the
// joint as their nearest point, and the joint term removes one of the two. Where both elements have a nearest
// point inside (the concave side of a kink), the joint is the maximum between two minima and its term removes
// the excess. The sum is phi of the nearest point, with a continuous gradient. Each element adds its share
// without knowledge of its neighbours: itself, and minus one half of each end that is a joint.
enum class ProjectOn { element, first_end, second_end };

inline AxisProjection projection(const AxisShape& axis, ProjectOn target, const Vec3& x) {
  if (target == ProjectOn::element) return closest_point_on(axis, x);
  return point_at(axis, target == ProjectOn::first_end ? 0 : 1, x);
}

}  // namespace hawser
