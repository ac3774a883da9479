// Three of the thirty circles of chain_circles.full.cpp on a coarser mesh: the fastest, a middle one (with
// HAWSER_FULL), and the slowest with the largest radius. Errors of the mean peak tension are below 10 %.
#include "verification/chain_circles.hpp"

namespace hawser::test::chain_circles_test {
namespace {

TEST(ChainCircles, ThreeOfThem) {
  for (const size_t i : {4u, 14u, 29u}) {
    if (i == 14 && !std::getenv("HAWSER_FULL")) continue;
    const CircleCase& of = circle_cases()[i];
    EXPECT_NEAR(report(of, circle(of, 41, 1e-3, 1, 1)), 0, 10);
  }
}

// With steps that do not resolve the axial waves of a snapping chain (a twentieth of these would), the
// default rho_infinity of 0.8 gives twice the measured tension. More numerical damping (0.4) brings it within
// 10 %.
TEST(ChainCircles, LargeStepsWithDamping) {
  const CircleCase& of = circle_cases()[4];
  EXPECT_NEAR(report(of, circle(of, 165, 5e-3, 1, 1, 0.4)), 0, 10);
}

}  // namespace
}  // namespace hawser::test::chain_circles_test
