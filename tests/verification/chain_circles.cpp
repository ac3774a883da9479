// Three of the thirty circles of chain_circles.full.cpp, on a coarser mesh: the fastest, one between and the
// slowest, of the largest radius.
#include "verification/chain_circles.hpp"

namespace hawser::test::chain_circles_test {
namespace {

TEST(ChainCircles, ThreeOfThem) {
  for (const size_t i : {4u, 14u, 29u}) {
    const CircleCase& of = circle_cases()[i];
    EXPECT_NEAR(report(of, circle(of, 41, 1e-3, 1, 1)), 0, 10);
  }
}

// A chain that snaps generates energy at steps that do not resolve its waves along (a twentieth would), twice
// the tension at the default of 0.8; numerical damping of high frequencies takes it out.
TEST(ChainCircles, LargeStepsWithDamping) {
  const CircleCase& of = circle_cases()[4];
  EXPECT_NEAR(report(of, circle(of, 165, 5e-3, 1, 1, 0.4)), 0, 10);
}

}  // namespace
}  // namespace hawser::test::chain_circles_test
