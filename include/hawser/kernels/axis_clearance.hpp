// How near the axis of an element comes to that of another, and to a surface. Pure.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "hawser/geometry/box.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// An axis as the four Bézier points of its cubic (of a cable on its chord): b(z), z in [0, 1].
struct BezierAxis {
  std::array<Vec3, 4> b;

  // Of a beam: unit tangents at the ends and the unstretched length (Hermite's cubic of axis_shape.hpp).
  static BezierAxis beam(const Vec3& x1, const Vec3& t1, const Vec3& x2, const Vec3& t2, double length) {
    return {{x1, x1 + length / 3 * t1, x2 - length / 3 * t2, x2}};
  }
  static BezierAxis straight(const Vec3& x1, const Vec3& x2) {
    return {{x1, (2 * x1 + x2) / 3, (x1 + 2 * x2) / 3, x2}};
  }

  Vec3 point(double z) const;
  Vec3 slope(double z) const;  // db/dz, m
  Vec3 bend(double z) const;   // d²b/dz², m
  double reach() const;        // a bound of |db/dz|, m
  double sagitta() const;      // a bound of how far it is from its chord, m
  Box box() const;             // holds it
  std::array<BezierAxis, 2> halves() const;
};

struct AxisApproach {
  double distance = 0;     // m
  double xi = 0, eta = 0;  // on the two axes
};

// The nearest points of two axes, when these are nearer than `within` [m]; else nothing. Pieces whose bounds
// exclude it are left out until the rest is straight to `resolution` [m]; the best of them is the start of a
// Newton iteration, so that the answer is right to rounding unless two places differ by less than the
// resolution.
std::optional<AxisApproach> nearest_of(const BezierAxis& a, const BezierAxis& b, double within,
                                       double resolution);

struct AxisToSurface {
  double distance = 0;  // m, signed
  double xi = 0;
};
// Signed distance to a surface at a point, its gradient in `normal`; nothing when it is larger than `within`.
using DistanceField = std::function<std::optional<double>(const Vec3& x, double within, Vec3& normal)>;

// The point of an axis with the smallest signed distance to a surface, when that is smaller than `within`
// [m]; else nothing. One minimum is looked for in each piece of 2^-levels of the axis.
std::optional<AxisToSurface> nearest_to(const DistanceField& field, const BezierAxis& axis, double within,
                                        int levels);

}  // namespace hawser
