// All thirty circles of chain_circles.hpp: the mean error of the peak tension is at most 6 %, the largest 10
// %.
#include "verification/chain_circles.hpp"

namespace hawser::test {
namespace {

TEST(ChainCircles, AllThirty) {
  ASSERT_EQ(circle_cases().size(), 30U);
  double sum = 0, worst = 0;
  for (const CircleCase& of : circle_cases()) {
    const double error = std::abs(report(of, circle(of, 82, 1e-3, 2, 3)));
    sum += error;
    worst = std::max(worst, error);
  }
  const double mean = sum / static_cast<double>(circle_cases().size());
  printf("  mean %.2f %%, worst %.2f %%\n", mean, worst);
  EXPECT_LE(mean, 6);
  EXPECT_LE(worst, 10);
}

}  // namespace
}  // namespace hawser::test
