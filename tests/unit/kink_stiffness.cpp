// KinkStiffness: when Newton's iteration counts as stagnating or cycling.
#include "hawser/solve/kink_stiffness.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace hawser {
namespace {

// Number of iterations with these relative residuals after which the secants begin, 0 if they do not.
int iterations_until_active(KinkStiffness& kinks, const std::vector<double>& relative) {
  VecHandle r;
  check(VecCreateSeq(PETSC_COMM_SELF, 3, r.out()));
  check(VecSet(r.get(), 1));
  const double u[3] = {};
  for (size_t i = 0; i < relative.size(); ++i)
    if (kinks.observe(u, r.get(), relative[i])) return static_cast<int>(i) + 1;
  return 0;
}

TEST(KinkStiffness, CyclesOfTwoAndThreeIterates) {
  KinkStiffness kinks;
  kinks.clear(20);
  EXPECT_EQ(iterations_until_active(kinks, {1, 3e-3, 2.1e-3, 1.4e-3, 2.1e-3, 1.4e-3}), 6);
  EXPECT_EQ(kinks.smooth_iterations(), 2);
  kinks.clear(20);
  EXPECT_FALSE(kinks.active());
  EXPECT_EQ(iterations_until_active(kinks, {1, 2.1e-3, 1.4e-3, 3e-3, 2.1e-3, 1.4e-3, 3e-3, 2.1e-3}), 7);
  EXPECT_EQ(kinks.smooth_iterations(), 1);
  kinks.clear(20);
  EXPECT_EQ(iterations_until_active(kinks, {2e-3, 1.4e-3, 2.0002e-3, 1.4001e-3, 1.9998e-3}), 4);
  EXPECT_EQ(kinks.smooth_iterations(), 1);  // not 0, by which relaxation means a failed step
}

// Contact that sticks and slips: residuals are of one size for some iterations, and do not repeat.
TEST(KinkStiffness, ResidualsThatDoNotRepeatAreNoCycle) {
  KinkStiffness kinks;
  kinks.clear(20);
  EXPECT_EQ(iterations_until_active(kinks, {1, 9.9e-3, 9e-3, 9.7e-3, 9.2e-3, 9.6e-3, 1e-4, 1e-9}), 0);
  kinks.clear(20);
  EXPECT_EQ(iterations_until_active(kinks, {1, 2.1e-3, 1.4e-3, 2.1e-3, 1.3e-3, 2.1e-3, 1.4e-3}), 0);
}

TEST(KinkStiffness, CyclesFarFromEquilibriumAreLeftAlone) {
  KinkStiffness kinks;
  kinks.clear(20);
  EXPECT_EQ(iterations_until_active(kinks, {1, 0.3, 0.2, 0.3, 0.2, 0.3, 0.2}), 0);
}

TEST(KinkStiffness, StagnationCountsAfterThePatience) {
  const std::vector<double> stagnant{1, 1e-3, 9e-4, 8e-4, 7e-4, 6.5e-4, 6e-4, 5.5e-4};
  KinkStiffness kinks;
  kinks.clear();
  EXPECT_EQ(iterations_until_active(kinks, stagnant), 4);
  EXPECT_EQ(kinks.smooth_iterations(), 2);
  kinks.clear(6);
  EXPECT_EQ(iterations_until_active(kinks, stagnant), 7);
  kinks.clear(10);
  EXPECT_EQ(iterations_until_active(kinks, stagnant), 0);
}

}  // namespace
}  // namespace hawser
