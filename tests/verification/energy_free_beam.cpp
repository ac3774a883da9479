#include "verification/energy_free_beam.hpp"

namespace hawser::test::energy_free_beam_test {
namespace {

TEST(Energy, FreeFlyingBeam) {
  const Tumble coarse = tumble(true, 20, 100, 1, 50);
  const Tumble fine = tumble(true, 20, 200, 1, 50);
  show("free beam, 100 steps a period", 1, coarse);
  show("free beam, 200 steps a period", 1, fine);
  EXPECT_GT(coarse.strain, 0.3);  // the beam bends
  for (const Tumble& t : {coarse, fine}) {
    EXPECT_LT(t.energy, 1e-3);
    EXPECT_LT(std::abs(t.drift), 1e-4);
    EXPECT_LT(t.linear, 1e-11);
    // At rho = 1 a difference of the directors' acceleration is not damped; it must not increase.
    EXPECT_LT(t.apart[1], 2 * t.apart[0]);
  }
  // These errors fall with the square of the step.
  EXPECT_LT(fine.energy, 0.3 * coarse.energy);
  EXPECT_LT(fine.angular, 0.3 * coarse.angular);
  EXPECT_LT(fine.angular, 5e-5);
}

// Momentum is constant within Newton's tolerance at any step: coarse steps, a damped scheme, automatic steps
// with rejections, and a bent line with graded elements and masses at nodes.
TEST(Energy, MomentumOfAFreeBeam) {
  const Tumble coarse = tumble(true, 20, 50, 1, 50);
  show("free beam, 50 steps a period", 1, coarse);
  EXPECT_LT(coarse.linear, 1e-11);
  EXPECT_LT(coarse.energy, 3e-3);

  const Tumble damped = tumble(true, 20, 100, 0.8, 50);
  show("free beam, 100 steps a period", 0.8, damped);
  EXPECT_LT(damped.linear, 1e-11);
  EXPECT_LT(damped.energy, 1e-3);

  model::Case c = free_line(true, 12);
  c.lines[0].sections[0].grading = 4;
  c.lines[0].masses = {{0, 2}, {6, 5}};
  c.lines[0].points.clear();
  for (int i = -20; i <= 20; ++i) {  // an arc of radius 15 m
    const double angle = i / 20. / 3;
    c.lines[0].points.push_back(15 * Vec3(std::sin(angle), 1 - std::cos(angle), 0));
  }
  for (const double rho : {1.0, 0.8}) {
    const Tumble t = tumble(c, true, 100, rho, 10);
    show("bent, graded, with masses, 100 steps a period", rho, t);
    EXPECT_LT(t.linear, 1e-11);
    EXPECT_GT(t.strain, 0.1);
  }
  c.dynamics.error_tolerance = 1e-4;
  const Tumble automatic = tumble(c, true, 0, 0.8, 10);
  show("the same in automatic steps", 0.8, automatic);
  // The residual that Newton's iteration leaves acts as a force on the whole line. Short steps end at the
  // round-off of their accelerations, and 4600 of them add up.
  EXPECT_LT(automatic.linear, 1e-9);
}

// The default tolerance of Newton's iteration does not consider momentum.
TEST(Energy, MomentumWithTheDefaultTolerance) {
  const Tumble t = tumble(true, 20, 100, 1, 50, DynamicsSettings{}.tolerance);
  show("free beam, 100 steps a period, default tolerance", 1, t);
  EXPECT_LT(t.linear, 1e-9);
}

// The mass matrix of cables is constant.
TEST(Energy, FreeFlyingCable) {
  const Tumble t = tumble(false, 20, 200, 1, 50);
  show("free cable, 200 steps a period", 1, t);
  EXPECT_LT(t.linear, 1e-11);
  // Its elements slacken and snap taut: in this chaotic motion round-off changes the energy error between 0.7
  // and 1.3 % in 50 periods.
  EXPECT_LT(t.energy, 0.02);
}

}  // namespace
}  // namespace hawser::test::energy_free_beam_test
