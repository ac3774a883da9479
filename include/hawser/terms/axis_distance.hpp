// How far an axis is from a surface, along it and anywhere.
#pragma once

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/axis_clearance.hpp"
#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/contact_intervals.hpp"
#include "hawser/kernels/motion.hpp"

namespace hawser {

// Less `most` [m]: contact_intervals() finds where it is nearer than that, or deeper inside than -most. The
// surface, its pose and the axis outlive the function.
inline auto axis_distance(const Surface& surface, const RigidPose& pose, const AxisShape& shape,
                          double most = 0) {
  return [&, most, hint = -1](double xi, double within) mutable -> AxisGap {
    const auto p = surface.query(pose.to_body(shape.point(xi)), within + most, hint);
    if (!p) return {within, 0};
    hint = p->triangle;
    return {p->distance - most, (pose.rotation * p->normal).dot(shape.slope(xi))};
  };
}

// The distance to all of a surface, whatever its walls. The surface outlives the function.
inline auto distance_to(const Surface& surface) {
  return [&surface, hint = -1](const Vec3& x, double within, Vec3& normal) mutable -> std::optional<double> {
    const auto p = surface.query(x, within, hint);
    if (!p) return std::nullopt;
    hint = p->triangle;
    normal = p->normal;
    return p->distance;
  };
}

}  // namespace hawser
