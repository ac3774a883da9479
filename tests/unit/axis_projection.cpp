// The point of an element's axis nearest to a given point, against fine sampling.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hawser/kernels/line_pair.hpp"
#include "support/axis_elements.hpp"

namespace hawser::axis_projection_test {
namespace {

using namespace test::axis_elements;

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
