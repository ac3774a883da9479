// The point of an element's axis that is nearest to a given point.
#pragma once

#include "hawser/kernels/axis_shape.hpp"

namespace hawser {

struct AxisProjection {
  double eta = 0;               // of the nearest point y
  bool inside = false;          // (x - y) . y' = 0 there; else it is an end of the element
  Vec3 away = Vec3::Zero();     // m, x - y
  Vec3 normal = Vec3::UnitZ();  // away, unit
  double distance = 0;          // m
};

// Of the whole element, its ends included. The nearest of five places is the start of a bracketed Newton
// iteration: right for elements that turn by less than about a right angle, and for points nearer than the
// element's radius of curvature.
AxisProjection closest_point_on(const AxisShape& axis, const Vec3& x);

// With the point eta given.
AxisProjection point_at(const AxisShape& axis, double eta, const Vec3& x);

// A chain of elements has one distance field: sum over its elements of phi(distance to the element) less
// phi(distance to the joint) for every joint. Beyond a joint both elements end there and the joint takes one
// of the two away; where both elements have a nearest point inside (the hollow side of a kink) the joint is
// the maximum between two minima and takes what is too much. The sum is phi of the nearest point and its
// gradient is continuous everywhere. Each element takes its share without knowing its neighbours: itself, and
// minus one half of each end that is a joint.
enum class ProjectOn { element, first_end, second_end };

inline AxisProjection projection(const AxisShape& axis, ProjectOn part, const Vec3& x) {
  if (part == ProjectOn::element) return closest_point_on(axis, x);
  return point_at(axis, part == ProjectOn::first_end ? 0 : 1, x);
}

}  // namespace hawser
