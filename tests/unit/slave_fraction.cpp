// Shares of the contact pressure between two lines on the two sides.
#include <gtest/gtest.h>

#include "hawser/kernels/line_pair.hpp"

namespace hawser::slave_fraction_test {
namespace {

// The shares sum to 1; the thinner line has all of the pressure if the other is 1.6 times as thick.
TEST(SlaveShare, AddsUp) {
  double last = 0.5;
  for (double ratio = 1; ratio < 3; ratio *= 1.02) {
    const double thin = slave_fraction(0.1, 0.1 * ratio);
    const double thick = slave_fraction(0.1 * ratio, 0.1);
    EXPECT_NEAR(thin + thick, 1, 1e-15) << ratio;
    EXPECT_GE(thin, last) << ratio;
    EXPECT_LT(thin, last + 0.04) << ratio;
    last = thin;
  }
  EXPECT_EQ(slave_fraction(0.1, 0.1), 0.5);
  EXPECT_EQ(slave_fraction(0.1, 0.16), 1);
  EXPECT_EQ(slave_fraction(0.16, 0.1), 0);
}

}  // namespace
}  // namespace hawser::slave_fraction_test
