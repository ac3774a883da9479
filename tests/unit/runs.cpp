// A list with runs of equal values.
#include "hawser/base/runs.hpp"

#include <gtest/gtest.h>

namespace hawser::runs_test {
namespace {

TEST(Runs, EqualNeighboursAreOneRun) {
  const Runs<int> values = {7, 7, 7, -1, 7, 7};
  ASSERT_EQ(values.size(), 6u);
  const int expected[] = {7, 7, 7, -1, 7, 7};
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(values[i], expected[i]) << i;
  EXPECT_EQ(Runs<int>().size(), 0u);
}

}  // namespace
}  // namespace hawser::runs_test
