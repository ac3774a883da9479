// The place of an element's axis that is nearest to a point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hawser/kernels/line_pair.hpp"
#include "hawser/math/so3.hpp"

namespace hawser::axis_projection_test {
namespace {

double noise(int i, int purpose) {
  const double x = std::sin(12.9898 * (i + 1) + 78.233 * purpose) * 43758.5453;
  return 2 * (x - std::floor(x)) - 1;
}
Vec3 noise3(int i, int p) { return {noise(3 * i, p), noise(3 * i + 1, p), noise(3 * i + 2, p)}; }

// An element from a to b; its nodes' axes lean off the chord by up to `bend`.
AxisEnds element(bool beam, const Vec3& a, const Vec3& b, int seed, double bend = 0.05) {
  AxisEnds e;
  e.beam = beam;
  e.length = 1.01 * (b - a).norm();
  e.x1 = a, e.x2 = b;
  e.v1 = noise3(seed, 1), e.v2 = noise3(seed, 2);
  if (!beam) return e;
  e.tangent = Vec3(0.8, 0.6, 0);
  const Quat along = minimal_rotation(e.tangent, b - a);
  e.q1 = exp_so3(bend * noise3(seed, 3)) * along, e.q2 = exp_so3(bend * noise3(seed, 4)) * along;
  e.w1 = noise3(seed, 5), e.w2 = noise3(seed, 6);
  return e;
}

TEST(AxisProjection, NearestOfAll) {
  for (int seed = 0; seed < 200; ++seed) {
    const AxisEnds e =
        element(seed % 3 != 0, noise3(seed, 20), noise3(seed, 20) + Vec3(1, 0.2, 0.1), seed, 0.3);
    const AxisShape axis(e);
    const Vec3 x = axis.point(0.5 + 0.7 * noise(seed, 21)) + 0.2 * noise3(seed, 22);
    const AxisProjection f = closest_point_on(axis, x);
    double least = 1e300;
    for (int i = 0; i <= 4000; ++i) least = std::min(least, (x - axis.point(i / 4000.0)).norm());
    EXPECT_LE(f.distance, least + 1e-12) << seed;
    EXPECT_NEAR(f.distance, least, 1e-4) << seed;
    EXPECT_NEAR(f.inside ? f.away.dot(axis.slope(f.eta)) : 0.0, 0, 1e-12) << seed;
  }
}

}  // namespace
}  // namespace hawser::axis_projection_test
