// The axis of an element as a cubic Bézier curve, the form in which it is bounded, halved and compared with
// where it was.
#pragma once

#include <array>

#include "hawser/geometry/box.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// b(z), z in [0, 1], of four points [m]; of a cable on its chord. It lies in their hull, and no point of an
// axis is farther from that of another than the farthest of these from its own.
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
  Vec3 slope(double z) const;                               // db/dz, m
  Vec3 bend(double z) const;                                // d²b/dz², m
  double slope_bound() const;                               // a bound of |db/dz|, m
  double sagitta() const;                                   // a bound of how far it is from its chord, m
  double farthest_distance(const BezierAxis& other) const;  // the farthest of its points from the other's, m
  Box box() const;                                          // holds it
  std::array<BezierAxis, 2> halves() const;
  BezierAxis part(double from, double to) const;
};

// Half way from one to the other.
BezierAxis between(const BezierAxis& from, const BezierAxis& to);

}  // namespace hawser
