// How far the axis of an element is from a surface, along it.
#pragma once

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/contact_stretches.hpp"
#include "hawser/kernels/motion.hpp"

namespace hawser {

// Less `most` [m]: contact_stretches() finds where it is nearer than that, or deeper inside than -most. The
// surface, its pose and the axis outlive the function.
inline AxisGapFunction axis_distance(const Surface& surface, const RigidPose& pose, const AxisShape& shape,
                                     double most = 0) {
  return [&, most, hint = -1](double xi, double within) mutable -> AxisGap {
    const auto p = surface.query(pose.to_body(shape.point(xi)), within + most, hint);
    if (!p) return {within, 0};
    hint = p->triangle;
    return {p->distance - most, (pose.rotation * p->normal).dot(shape.slope(xi))};
  };
}

}  // namespace hawser
