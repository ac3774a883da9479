// Three of the thirty circles of chain_circles.full.cpp, on a coarser mesh: the fastest, one between and the
// slowest, of the largest radius.
#include "verification/chain_circles.hpp"

namespace hawser::test {
namespace {

TEST(ChainCircles, ThreeOfThem) {
  for (const size_t i : {4u, 14u, 29u}) {
    const CircleCase& of = circle_cases()[i];
    EXPECT_NEAR(report(of, circle(of, 41, 1e-3, 1, 1)), 0, 10);
  }
}

}  // namespace
}  // namespace hawser::test
