// A value without the rounding error that depends on the number of ranks: equal for values that differ by
// rounding, and near to the original.
#include "hawser/base/rank_independent.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace hawser::steady_test {
namespace {

TEST(RankIndependent, KeepsSizeAndLosesRounding) {
  std::mt19937 gen(7);
  std::uniform_real_distribution<double> exponent(-300, 300), rounding(-4e-16, 4e-16);
  int apart = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = (i % 2 ? 1 : -1) * std::pow(10, exponent(gen));
    EXPECT_NEAR(rank_independent(x) / x, 1, 1e-9);
    EXPECT_EQ(rank_independent(rank_independent(x)), rank_independent(x));
    apart += rank_independent(x) != rank_independent(x * (1 + rounding(gen)));
  }
  EXPECT_LE(apart, 3);  // values beside a limit of rounding
}

TEST(RankIndependent, LeavesWhatIsNoSize) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(rank_independent(0), 0);
  EXPECT_EQ(rank_independent(inf), inf);
  EXPECT_EQ(rank_independent(-inf), -inf);
  EXPECT_TRUE(std::isnan(rank_independent(std::nan(""))));
}

}  // namespace
}  // namespace hawser::steady_test
