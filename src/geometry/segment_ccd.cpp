// First time at which two moving segments are near each other, by conservative advancement.
#include "hawser/geometry/segment_ccd.hpp"

#include <algorithm>

#include "hawser/geometry/segment_distance.hpp"

namespace hawser {

double first_approach(const MovingSegment& a, const MovingSegment& b, double threshold, double tolerance) {
  constexpr int kMaxSteps = 500;
  const Vec3 ua[2] = {a.from1 - a.from0, a.to1 - a.to0};
  const Vec3 ub[2] = {b.from1 - b.from0, b.to1 - b.to0};
  double speed = 0;  // |u_a(s) - u_b(t)| is convex in s and t: largest at the ends
  for (const Vec3& u : ua)
    for (const Vec3& v : ub) speed = std::max(speed, (u - v).norm());
  double t = 0;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double d = closest_points_of_segments(a.from0 + t * ua[0], a.to0 + t * ua[1], b.from0 + t * ub[0],
                                                b.to0 + t * ub[1])
                         .distance;
    if (d <= threshold + tolerance) return t;
    if (!(speed > 0)) return 2;
    t += (d - threshold) / speed;
    if (t > 1) return 2;
  }
  return t;
}

}  // namespace hawser
