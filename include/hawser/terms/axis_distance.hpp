// Distance from a surface to the points of an axis and to any point.
#pragma once

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/axis_clearance.hpp"
#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/contact_intervals.hpp"
#include "hawser/kernels/motion.hpp"

namespace hawser {

// Gap function of an axis for contact_intervals(): distance to the surface minus `offset` [m], and its slope
// along the axis. It is negative where the axis is nearer than `offset` or, for a negative `offset`, deeper
// than -most. The surface, its pose and the axis must outlive the function.
inline auto axis_distance(const Surface& surface, const RigidPose& pose, const AxisShape& shape,
                          double offset = 0) {
  return [&, offset, hint = -1](double xi, double within) mutable -> AxisGap {
    const auto p = surface.query(pose.to_body(shape.point(xi)), within + offset, hint);
    if (!p) return {within, 0};
    hint = p->triangle;
    return {p->distance - offset, (pose.rotation * p->normal).dot(shape.slope(xi))};
  };
}

// Distance to the whole surface, regardless of its facet groups. The surface must outlive the function.
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
