// Contact of two elements at joints of their lines: joints do not affect the forces, and no contact is
// missed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "hawser/kernels/line_pair.hpp"
#include "hawser/math/so3.hpp"
#include "support/axis_elements.hpp"

namespace hawser::line_pair_joints_test {
namespace {

using namespace test::axis_elements;

constexpr double kRadius = 0.05, kStiffness = 1e5;

// A straight beam or cable consists of one element or several: the force of a line that moves along it is
// independent of the joints.
TEST(LinePairJoints, JointsDoNotShow) {
  for (const bool beam : {true, false})
    for (const double angle : {0.05, 0.4, 1.0, M_PI / 2}) {
      double worst = 0, mean = 0;
      int n = 0;
      for (double shift = -0.3; shift < 0.3; shift += 0.0137, ++n) {
        const auto total = [&](int pieces) {
          Vec3 sum = Vec3::Zero();
          const Vec3 along(std::cos(angle), std::sin(angle), 0);
          AxisEnds a;
          a.beam = beam;
          a.length = 1.6;
          a.x1 = Vec3(shift, 0, 0.095) - 0.8 * along;
          a.x2 = a.x1 + 1.6 * along;
          a.q1 = a.q2 = minimal_rotation(Vec3::UnitX(), along);
          for (int i = 0; i < pieces; ++i) {
            AxisEnds b;
            b.beam = beam;
            b.length = 4.0 / pieces;
            b.x1 = Vec3(-2 + i * b.length, 0, 0);
            b.x2 = Vec3(-2 + (i + 1) * b.length, 0, 0);
            const PairAxis A(a, a);
            const PairAxis B(b, b);
            LinePairPass::Settings set;
            set.law.radii = 2 * kRadius;
            set.law.normal = {kStiffness, 1e-5, 0};
            set.slave_radius = kRadius;
            set.moves = false;
            const std::vector<LinePairContactPoint> none;
            for (int k = 0; k < 6; ++k) {
              const ProjectOn target = static_cast<ProjectOn>(k % 3);
              // Joints of the chain of pieces; the other line is one element.
              if (target != ProjectOn::element && k >= 3) continue;
              if (target == ProjectOn::first_end && i == 0) continue;
              if (target == ProjectOn::second_end && i + 1 == pieces) continue;
              const LinePairPass pass(k < 3 ? A : B, k < 3 ? B : A, target, set, none);
              AttachedForces g = no_forces(A, A, false);
              pass.add(pass.panels(), false, g);
              const size_t step = beam ? 2 : 1;
              const size_t first = k < 3 ? 0 : static_cast<size_t>(A.now.count());
              sum += g.F[first] + g.F[first + step];
            }
          }
          return sum;
        };
        const Vec3 one = total(1);
        const Vec3 many = total(10);
        worst = std::max(worst, (one - many).norm());
        mean += one.norm();
      }
      mean /= n;
      printf("  %s at %.2f rad: joints show by %.1e of the force\n", beam ? "beam" : "cable", angle,
             worst / mean);
      EXPECT_LT(worst, 2e-3 * mean);
      EXPECT_GT(mean, 10);
    }
}

// Nearly parallel lines that separate beyond a joint of one of them: the gap decreases slowly until the
// nearest point passes the joint, and increases steeply beyond.
TEST(LinePairJoints, ContactAtAJointIsNotMissed) {
  int deep = 0, missed = 0;
  for (int seed = 0; seed < 4000; ++seed) {
    AxisEnds b = element(true, Vec3::Zero(), Vec3(0.1, 0, 0), seed, 0.02);
    const double over = 0.05 + 0.04 * noise(seed, 30);
    const double lean = 0.003 * (1 + noise(seed, 31));
    const double z = 2 * kRadius - 2e-5 * std::abs(noise(seed, 32));
    // A point above the end of b, at the distance `over` from the first node of a.
    const Vec3 along = Vec3(1, 0.1 * noise(seed, 33), -lean).normalized();
    const Vec3 at(b.x2 + Vec3(0, 0, z));
    const AxisEnds a = element(true, at - over * along, at + (0.1 - over) * along, seed + 4000, 0.02);
    const PairAxis A(a, a);
    const PairAxis B(b, b);
    LinePairPass::Settings set;
    set.law.radii = 2 * kRadius;
    set.law.normal = {kStiffness, 1e-6, 0};
    set.slave_radius = kRadius;
    set.moves = false;
    const std::vector<LinePairContactPoint> none;
    const auto panels = LinePairPass(A, B, ProjectOn::element, set, none).panels();
    double least = 1e300, place = 0;
    for (int i = 0; i <= 2000; ++i) {
      const double xi = i / 2000.0;
      const double d = closest_point_on(B.now, A.now.point(xi)).distance;
      if (d < least) {
        least = d;
        place = xi;
      }
    }
    if (!(least < 2 * kRadius - 1e-7)) continue;
    ++deep;
    missed += std::none_of(panels.begin(), panels.end(),
                           [&](const auto& p) { return p.from <= place && place <= p.to; });
  }
  printf("  %d of %d missed\n", missed, deep);
  EXPECT_GT(deep, 1000);
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace hawser::line_pair_joints_test
