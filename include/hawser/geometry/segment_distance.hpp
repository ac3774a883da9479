// Closest points of two segments, for contact between lines.
//
// The size below is the largest of |a1 - a0|, |b1 - b0| and |a0 - b0|.
// - The distance is accurate to 1e-14 of the size for any input: parallel, nearly parallel (where solving the
//   normal equations fails), crossing, collinear, degenerate to points.
// - s and t are as accurate as the problem is conditioned: for lines at the angle theta to rounding / theta.
// For
//   lines that are parallel to rounding they are the middle of the stretch of equal distance.
// - Exchanging the segments exchanges the result exactly.
//
// Cases as in Eberly (2018), "Robust computation of distance between line segments", Geometric Tools (the
// minimum of a convex function over the unit square is inside it or on one of its edges). The inner solution
// is found differently: with r = a0 - b0 and n = u x v, s = -((r x v) n) / (n n), whose error moves the point
// across the other line by no more than rounding, then t by projection. The determinant of the normal
// equations, which loses twice the digits, is not formed.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

struct SegmentPair {
  double s = 0, t = 0;                            // in [0, 1], from a0 to a1 and from b0 to b1
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();  // m
  Vec3 difference = Vec3::Zero();                 // m, on_a - on_b, without the rounding of large coordinates
  double distance = 0;                            // m, >= 0
};

SegmentPair closest_points_of_segments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

}  // namespace hawser
