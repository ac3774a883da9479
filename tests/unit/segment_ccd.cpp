// Continuous collision of segments against distances at many times: no approach is missed, and each reported
// one is true.
#include "hawser/geometry/segment_ccd.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hawser/geometry/segment_distance.hpp"

namespace hawser::segment_ccd_test {
namespace {

TEST(SegmentCcd, NeverMissesAndNeverCriesWolf) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&](double size) {
    return Vec3(size * Vec3(unit(random), unit(random), unit(random)));
  };
  int met = 0, apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 push = vector(2);
    MovingSegment a{vector(1), vector(1), {}, {}};
    MovingSegment b{vector(1) + push, vector(1) + push, {}, {}};
    a.from1 = a.from0 + vector(1);
    a.to1 = a.to0 + vector(1);
    b.from1 = b.from0 + vector(1) - 2 * push;
    b.to1 = b.to0 + vector(1) - 2 * push;
    const double least = 0.05, tolerance = 0.002;
    const double found = first_approach(a, b, least, tolerance);
    const auto distance = [&](double t) {
      return closest_points_of_segments((1 - t) * a.from0 + t * a.from1, (1 - t) * a.to0 + t * a.to1,
                                        (1 - t) * b.from0 + t * b.from1, (1 - t) * b.to0 + t * b.to1)
          .distance;
    };
    for (int k = 0; k <= 500; ++k) {
      const double t = k / 500.0;
      if (t < found) {
        EXPECT_GE(distance(t), least) << i << " at " << t;
      }
    }
    if (found <= 1) {
      EXPECT_LE(distance(found), least + tolerance + 1e-12) << i;
    }
    ++(found <= 1 ? met : apart);
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(apart, 300);
}

TEST(SegmentCcd, AtRest) {
  const MovingSegment a{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  MovingSegment b = a;
  for (Vec3* p : {&b.from0, &b.to0, &b.from1, &b.to1}) p->z() += 0.1;
  EXPECT_EQ(first_approach(a, b, 0.05, 1e-3), 2);
  EXPECT_EQ(first_approach(a, b, 0.1, 1e-3), 0);
}

}  // namespace
}  // namespace hawser::segment_ccd_test
