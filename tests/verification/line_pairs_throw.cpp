// Crossing lines thrown at each other never pass through each other, whatever the step.
#include "verification/line_pairs_throw.hpp"

namespace hawser::test::line_pairs_throw_test {
namespace {

TEST(ThrownLines, NeverPassThrough) { expect_none_passes_through(120); }

// Beams tumble after their collision in steps that do not resolve it. There Newton's iteration can converge
// to positions a full turn away, with 15 to 270 times the energy. The energy must stay below 1.02 of the
// initial one.
TEST(ThrownLines, TumbleWithoutEnergyFromNowhere) {
  for (const unsigned seed : {1330U, 8900U, 142U, 8188U, 6900U, 484U, 4790U, 9916U, 3502U, 4086U}) {
    const Throw t = throw_of(seed);
    printf("  throw %u: largest energy %.4f of the first, %d steps, %d rejected\n", seed, t.gain, t.steps,
           t.rejected);
    EXPECT_TRUE(t.finished);
    EXPECT_LT(t.gain, 1.02) << seed;
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs_throw_test
