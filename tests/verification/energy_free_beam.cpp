#include "verification/energy_free_beam.hpp"

namespace hawser::test {
namespace {

void show(const char* what, int n, int per, double rho, const Tumble& t) {
  printf(
      "%s, %d elements, %d steps a period, rho = %.1f, %ld steps: relative change of energy %.1e (drift "
      "%+.1e), "
      "momentum %.1e, angular momentum %.1e; strain energy up to %.2f of all\n",
      what, n, per, rho, t.steps, t.energy, t.drift, t.linear, t.angular, t.strain);
}

TEST(Energy, FreeFlyingBeam) {
  const Tumble coarse = tumble(true, 20, 100, 1, 50), fine = tumble(true, 20, 200, 1, 50);
  show("free beam", 20, 100, 1, coarse);
  show("free beam", 20, 200, 1, fine);
  EXPECT_GT(coarse.strain, 0.3);  // it does bend
  for (const Tumble& t : {coarse, fine}) {
    EXPECT_LT(t.energy, 1e-3);
    EXPECT_LT(std::abs(t.drift), 1e-4);
  }
  // All three come and go with the square of the step.
  EXPECT_LT(fine.energy, 0.3 * coarse.energy);
  EXPECT_LT(fine.angular, 0.3 * coarse.angular);
  EXPECT_LT(fine.linear, 0.32 * coarse.linear);
  EXPECT_LT(fine.linear, 1e-6);
  EXPECT_LT(fine.angular, 5e-5);
}

// How fine the step must be for nine digits of momentum; 50 periods of it are in energy_momentum.full.cpp.
TEST(Energy, MomentumOfAFreeBeam) {
  const Tumble t = tumble(true, 40, 2400, 1, 5);
  show("free beam", 40, 2400, 1, t);
  EXPECT_LT(t.linear, 1e-9);
  EXPECT_LT(t.angular, 1e-6);
  EXPECT_LT(t.energy, 1e-5);
}

// The mass matrix of cables is constant, so momentum is kept to round-off at any step.
TEST(Energy, FreeFlyingCable) {
  const Tumble t = tumble(false, 20, 200, 1, 50);
  show("free cable", 20, 200, 1, t);
  EXPECT_LT(t.linear, 1e-11);
  // Its elements go slack and snap taut: a chaotic motion, of which round-off makes 0.7 to 1.3 % in 50
  // periods.
  EXPECT_LT(t.energy, 0.02);
}

}  // namespace
}  // namespace hawser::test
