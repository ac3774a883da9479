// Case C01 with contact at the nodes, on a drum of 96 flat facets and on a smooth one (see capstan_rig.hpp):
// ratio of the end tensions.
#include "verification/capstan_rig.hpp"

namespace hawser::test::capstan::contact_capstan_test {
namespace {

// 26 elements a radian. On a faceted drum some nodes are lifted off.
Pull at_nodes() {
  Pull p;
  p.method = model::ContactMethod::nodes;
  p.elements_a_radian = 26;
  p.faceted = true;
  return p;
}

class Capstan : public ::testing::TestWithParam<std::tuple<Moving, double, double>> {};

// Required are 1.5 % at steps of 5 ms or more.
TEST_P(Capstan, EndTensions) {
  Pull p = at_nodes();
  std::tie(p.moving, p.mu, p.wrap) = GetParam();
  if (between(p.mu, p.wrap)) GTEST_SKIP() << "long; set HAWSER_FULL";
  const Pulled o = run(p);
  report(p, o);
  const double exact = std::exp(p.mu * p.wrap);
  EXPECT_NEAR(o.ratio.mean(), exact, 0.003 * exact);
  EXPECT_LT(o.ratio.rms(), 0.01 * exact);
  EXPECT_GE(o.touching, 13 * p.wrap);
  EXPECT_LE(o.steps, 820);
}
INSTANTIATE_TEST_SUITE_P(Line, Capstan,
                         ::testing::Combine(::testing::Values(Moving::line), ::testing::Values(0.1, 0.3, 0.5),
                                            ::testing::Values(M_PI / 2, M_PI, 2 * M_PI)));
INSTANTIATE_TEST_SUITE_P(Drum, Capstan,
                         ::testing::Combine(::testing::Values(Moving::drum), ::testing::Values(0.1, 0.3, 0.5),
                                            ::testing::Values(M_PI)));

// Automatic steps, up to ten times longer.
TEST(CapstanSteps, Automatic) {
  Pull p = at_nodes();
  p.step = 0;
  p.longest = 0.05;
  p.duration = 6;
  const Pulled o = run(p);
  report(p, o);
  EXPECT_NEAR(o.ratio.mean(), std::exp(0.3 * M_PI), 0.003 * std::exp(0.3 * M_PI));
  // The program raises the stiffness until the nodes on the edges of facets are outside: 602 steps, 2.7e-5 m
  // of penetration.
  EXPECT_LT(o.steps, 650);
}

// A smooth drum: the error is that of the polygon of the line, and the ratio is constant in time.
TEST(CapstanSmooth, CableAndBeam) {
  for (const bool beam : {false, true}) {
    Pull p = at_nodes();
    p.beam = beam;
    p.faceted = false;
    const Pulled o = run(p);
    report(p, o);
    EXPECT_NEAR(o.ratio.mean(), std::exp(0.3 * M_PI), 5e-4 * std::exp(0.3 * M_PI)) << beam;
    EXPECT_LT(o.ratio.rms(), 5e-4 * std::exp(0.3 * M_PI)) << beam;
  }
}

}  // namespace
}  // namespace hawser::test::capstan::contact_capstan_test
