// Axis of an element as a cubic Bézier curve, which is easy to bound, halve and compare with another one.
#pragma once

#include <array>

#include "hawser/geometry/box.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// b(z), z in [0, 1], with four control points [m]; for a cable they lie on the chord. The curve lies in their
// convex hull, and no point of it is farther from that of another curve than the largest distance of
// corresponding control points.
struct BezierAxis {
  std::array<Vec3, 4> b;

  // Axis of a beam with unit end tangents and its unstretched length (Hermite's cubic of axis_shape.hpp).
  static BezierAxis beam(const Vec3& x1, const Vec3& t1, const Vec3& x2, const Vec3& t2, double length) {
    return {{x1, x1 + length / 3 * t1, x2 - length / 3 * t2, x2}};
  }
  static BezierAxis straight(const Vec3& x1, const Vec3& x2) {
    return {{x1, (2 * x1 + x2) / 3, (x1 + 2 * x2) / 3, x2}};
  }

  Vec3 point(double z) const;
  Vec3 slope(double z) const;                               // db/dz, m
  Vec3 bend(double z) const;                                // d²b/dz², m
  double slope_bound() const;                               // upper bound of |db/dz|, m
  double sagitta() const;                                   // upper bound of the distance from the chord, m
  double farthest_distance(const BezierAxis& other) const;  // largest distance of corresponding points, m
  Box box() const;                                          // bounding box
  std::array<BezierAxis, 2> halves() const;
  BezierAxis part(double from, double to) const;
};

// Mean of the two axes.
BezierAxis between(const BezierAxis& from, const BezierAxis& to);

}  // namespace hawser
