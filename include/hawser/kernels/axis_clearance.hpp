// How near the axis of an element comes to that of another, and to a surface. Pure.
#pragma once

#include <optional>

#include "hawser/kernels/bezier_axis.hpp"
#include "hawser/math/function_ref.hpp"

namespace hawser {

struct AxisApproach {
  double distance = 0;     // m
  double xi = 0, eta = 0;  // on the two axes
};

// The nearest points of two axes, when these are nearer than `within` [m]; else nothing. Pieces whose bounds
// exclude it are excluded until the rest is straight to `resolution` [m]; the best of them is the start of a
// Newton iteration, so that the answer is right to rounding unless two places differ by less than the
// resolution.
std::optional<AxisApproach> nearest_of(const BezierAxis& a, const BezierAxis& b, double within,
                                       double resolution);

struct AxisToSurface {
  double distance = 0;  // m, signed
  double xi = 0;
};
// Signed distance to a surface at a point, its gradient in `normal`; nothing when it is larger than `within`.
using DistanceField = FunctionRef<std::optional<double>(const Vec3& x, double within, Vec3& normal)>;

// The point of an axis with the smallest signed distance to a surface, when that is smaller than `within`
// [m]; else nothing. One minimum is looked for in each piece of 2^-levels of the axis.
std::optional<AxisToSurface> nearest_to(DistanceField field, const BezierAxis& axis, double within,
                                        int levels);

}  // namespace hawser
