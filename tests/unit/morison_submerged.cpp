// Four submerged cables computed together, against one at a time.
#include "hawser/kernels/morison_submerged.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace hawser::morison_submerged_test {
namespace {

struct Four {
  WaterSection section[4];
  Vec3 x[4][2], v[4][2], a[4][2];
  Water water[4][2];
  WaterSections4 sections;
  CablesInWater4 motion;

  // Elements of different sections, lengths and directions; the last is at rest relative to calm water.
  Four(unsigned seed, double depth, bool moving) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto any = [&](double size) { return Vec3(size * Vec3(unit(random), unit(random), unit(random))); };
    for (int i = 0; i < 4; ++i) {
      WaterSection& s = section[i];
      s.length = 4 + unit(random);
      s.radius = 0.2 + 0.1 * unit(random);
      s.buoyancy = 300 + 50 * unit(random);
      s.displaced_mass = 40 + i;
      s.added_normal = 45 + 3 * i;
      s.added_axial = 5 + i;
      s.drag_normal = 90 + 10 * i;
      s.drag_axial = 30 + 5 * i;
      const Vec3 middle = any(20) - Vec3(0, 0, depth);
      const Vec3 half = any(3);
      for (int k = 0; k < 2; ++k) {
        x[i][k] = middle + (k ? half : Vec3(-half));
        v[i][k] = any(i == 3 ? 0 : 2);
        a[i][k] = any(1.5);
        water[i][k].surface = 0.1 * unit(random);
        if (!moving) continue;
        water[i][k].velocity = any(1);
        water[i][k].by_height = any(0.1);
        water[i][k].acceleration = any(1);
      }
      sections.set(i, s);
      for (int k = 0; k < 2; ++k)
        for (int c = 0; c < 3; ++c) {
          motion.x[k][c][i] = x[i][k][c];
          motion.v[k][c][i] = v[i][k][c];
          motion.a[k][c][i] = a[i][k][c];
          motion.velocity[k][c][i] = water[i][k].velocity[c];
          motion.by_height[k][c][i] = water[i][k].by_height[c];
          motion.acceleration[k][c][i] = water[i][k].acceleration[c];
          motion.surface[k][i] = water[i][k].surface;
        }
    }
  }
  CableInWater one(int i) const {
    return {x[i][0], x[i][1], v[i][0], v[i][1], a[i][0], a[i][1], water[i][0], water[i][1]};
  }
};

// Reference: the kernel of single elements, whose tangents have their own Taylor test.
TEST(SubmergedCables, AreWhatSingleOnesAre) {
  constexpr double wK = 1, wC = 7.5, wM = 31;
  for (const bool moving : {false, true})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Four q(seed, 60, moving);
      ASSERT_EQ(submerged(q.sections, q.motion), 15u);
      std::array<Vec6, 4> f, again;
      std::array<Mat6, 4> J;
      submerged_force(q.sections, q.motion, moving, f);
      submerged_tangent(q.sections, q.motion, moving, wK, wC, wM, again, J);
      for (int i = 0; i < 4; ++i) {
        Vec6 one;
        Mat6 K, C, M;
        cable_water_tangent(q.section[i], q.one(i), false, one, K, C, M);
        const Mat6 weighted = wK * K + wC * C + wM * M;
        const auto largest = [](const auto& m) { return m.cwiseAbs().maxCoeff(); };
        EXPECT_LT(largest(f[i] - one), 1e-14 * largest(one)) << "element " << i;
        EXPECT_EQ(f[i], again[i]) << "element " << i;
        EXPECT_LT(largest(J[i] - weighted), 1e-13 * largest(weighted))
            << "element " << i << (moving ? ", moving water" : "");
      }
    }
}

TEST(SubmergedCables, AreNotWhereOneGetsDry) {
  Four q(1, 60, false);
  EXPECT_EQ(submerged(q.sections, q.motion), 15u);
  // Level elements just below the surface: a depth of one radius is sufficient.
  for (int k = 0; k < 2; ++k) q.motion.surface[k][2] = 0;
  for (int k = 0; k < 2; ++k) q.motion.x[k][2][2] = -1.001 * q.section[2].radius;
  EXPECT_EQ(submerged(q.sections, q.motion), 15u);
  q.motion.x[1][2][2] = -0.999 * q.section[2].radius;
  EXPECT_EQ(submerged(q.sections, q.motion), 11u);
  // A steep element likewise, at its upper end.
  for (const double depth : {0.999, 1.001}) {
    q.motion.x[0][2][2] = -depth * q.section[2].radius;
    q.motion.x[1][2][2] = q.motion.x[0][2][2] - 4;
    EXPECT_EQ(submerged(q.sections, q.motion), depth > 1 ? 15u : 11u);
  }
  for (int k = 0; k < 2; ++k) q.motion.x[k][2][2] = 20;
  EXPECT_EQ(submerged(q.sections, q.motion), 11u);
}

}  // namespace
}  // namespace hawser::morison_submerged_test
