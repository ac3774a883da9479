// A thousand periods of the free beam without damping in 100 000 steps: momentum is constant within 2e-9, and
// the acceleration that the scheme carries beside the state stays near that of the state.
#include "verification/energy_free_beam.hpp"

namespace hawser::test {
namespace {

TEST(Energy, MomentumOfAFreeBeamForAThousandPeriods) {
  const Tumble t = tumble(true, 20, 100, 1, 1000);
  show("free beam, 100 steps a period", 1, t);
  EXPECT_LT(t.linear, 2e-9);  // residuals of Newton's iteration add up over 10⁵ steps
  EXPECT_LT(t.energy, 2e-3);
  EXPECT_LT(t.apart[1], 3 * t.apart[0]);
}

}  // namespace
}  // namespace hawser::test
