// How fine the step must be for the momentum of a free beam to be kept to 1e-9.
#include "verification/energy_free_beam.hpp"

namespace hawser::test {
namespace {

TEST(Energy, MomentumOfAFreeBeamToNineDigits) {
  const Tumble t = tumble(true, 40, 2400, 1, 50);
  printf(
      "free beam, 40 elements, 2400 steps a period, rho = 1, %ld steps: relative change of momentum %.1e, "
      "angular momentum %.1e, energy %.1e\n",
      t.steps, t.linear, t.angular, t.energy);
  EXPECT_LT(t.linear, 1e-9);
  EXPECT_LT(t.angular, 1e-6);
  EXPECT_LT(t.energy, 1e-5);
}

}  // namespace
}  // namespace hawser::test
