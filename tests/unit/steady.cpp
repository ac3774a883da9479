#include "hawser/base/steady.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace hawser::steady_test {
namespace {

TEST(Steady, KeepsSizeAndLosesRounding) {
  std::mt19937 gen(7);
  std::uniform_real_distribution<double> exponent(-300, 300), rounding(-4e-16, 4e-16);
  int apart = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = (i % 2 ? 1 : -1) * std::pow(10, exponent(gen));
    EXPECT_NEAR(steady(x) / x, 1, 1e-9);
    EXPECT_EQ(steady(steady(x)), steady(x));
    apart += steady(x) != steady(x * (1 + rounding(gen)));
  }
  EXPECT_LE(apart, 3);  // of those that lie between two
}

TEST(Steady, LeavesWhatIsNoSize) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(steady(0), 0);
  EXPECT_EQ(steady(inf), inf);
  EXPECT_EQ(steady(-inf), -inf);
  EXPECT_TRUE(std::isnan(steady(std::nan(""))));
}

}  // namespace
}  // namespace hawser::steady_test
