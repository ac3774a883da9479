// Friction with damped sticking: energy balance on a given path.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hawser/kernels/friction_law.hpp"

namespace hawser::damped_friction_test {
namespace {

// Spring and damper in series with the slider: on a path that reverses, sticks and slides under a varying
// force N, the energy put in equals that of the spring plus the dissipation of damper and slider, both
// positive; without damping it is the law of the spring.
TEST(DampedFriction, EnergyOfSticking) {
  FrictionLaw law;
  law.axial = law.lateral = 0.4;
  law.axial_length = law.lateral_length = 2e-3;
  const double h = 1e-3;
  for (const double k : {0.0, 3e5}) {
    law.stiffness = k;
    Vec3 slip = Vec3::Zero();
    bool stuck = false, slid = false;
    double most = 0;
    for (int i = 0; i < 400; ++i) {
      const double N = 1000 + 500 * std::sin(0.05 * i);
      const Vec3 moved = 1e-4 * Vec3(std::sin(0.07 * i), std::cos(0.031 * i), 0);
      const Coulomb<double> mu{0.4, 0.4};
      law.damping = 0;
      const Friction<double> plain = friction<double>(law, N, slip + moved, {0, 0, 1}, {1, 0, 0});
      const Friction<double> none = damped_friction<double>(law, mu, N, N, slip, moved, h);
      EXPECT_LT((plain.force - none.force).norm(), 1e-12 * N);
      EXPECT_LT((plain.slip - none.slip).norm(), 1e-15);

      law.damping = 5;
      const Friction<double> f = damped_friction<double>(law, mu, N, N, slip, moved, h);
      const double spring = k > 0 ? k : 0.4 * N / 2e-3;
      const double c = 5 * std::sqrt(spring);
      EXPECT_LE(f.force.norm(), 0.4 * N * (1 + 1e-12));
      const Vec3 stretch = f.slip - slip;
      EXPECT_LT((f.force + spring * f.slip + c / h * stretch).norm(), 1e-9 * N);
      const double by_slider = -f.force.dot(moved - stretch);
      EXPECT_GE(by_slider, -1e-15 * N);
      EXPECT_EQ(f.slides, by_slider > 1e-13 * N);
      most = std::max(most, c / h * stretch.squaredNorm());
      (f.slides ? slid : stuck) = true;
      slip = f.slip;
    }
    EXPECT_TRUE(stuck && slid);
    EXPECT_GT(most, 1e-4);
  }
}

}  // namespace
}  // namespace hawser::damped_friction_test
