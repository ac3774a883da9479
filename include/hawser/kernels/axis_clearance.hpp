// Smallest distance of an element's axis from another axis and from a surface. Pure.
#pragma once

#include <optional>

#include "hawser/kernels/bezier_axis.hpp"
#include "hawser/math/function_ref.hpp"

namespace hawser {

struct AxisApproach {
  double distance = 0;     // m
  double xi = 0, eta = 0;  // positions on the two axes
};

// Nearest points of two axes if their distance is below `within` [m]; else nullopt. Pieces are excluded by
// their bounds and halved until the rest are straight to `resolution` [m]. The best piece is the start of a
// Newton iteration, so the result is exact to rounding unless two minima differ by less than the resolution.
std::optional<AxisApproach> nearest_of(const BezierAxis& a, const BezierAxis& b, double within,
                                       double resolution);

struct AxisToSurface {
  double distance = 0;  // m, signed
  double xi = 0;
};
// Signed distance to a surface at a point, with its gradient in `normal`; nullopt if it exceeds `within`.
using DistanceField = FunctionRef<std::optional<double>(const Vec3& x, double within, Vec3& normal)>;

// Point of an axis with the smallest signed distance to a surface if that is below `within` [m]; else
// nullopt. Searches for one minimum in each piece of 2^-levels of the axis.
std::optional<AxisToSurface> nearest_to(DistanceField field, const BezierAxis& axis, double within,
                                        int levels);

}  // namespace hawser
