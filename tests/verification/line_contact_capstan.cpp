// Case C01 with contact along the line, on a smooth drum with elements of an eighth of the radius (see
// capstan_rig.hpp): ratio of the end tensions.
#include "verification/capstan_rig.hpp"

namespace hawser::test::capstan::line_contact_capstan_test {
namespace {

void expect_exact(const Pull& p) {
  const Pulled o = run(p);
  report(p, o);
  const double exact = std::exp(p.mu * p.wrap);
  EXPECT_NEAR(o.ratio.mean(), exact, 0.005 * exact);
  EXPECT_LT(o.ratio.rms(), 0.005 * exact);
  // With two turns the program raises the contact stiffness 43 times; the energy of this is added in every
  // step.
  EXPECT_LT(std::abs(o.audit), p.wrap > 7 ? 5e-4 : 1e-4);
  EXPECT_GE(o.touching, 6.5 * p.wrap);
}

class LineCapstan : public ::testing::TestWithParam<std::tuple<Moving, bool, double, double>> {};

TEST_P(LineCapstan, EndTensions) {
  Pull p;
  std::tie(p.moving, p.beam, p.mu, p.wrap) = GetParam();
  if (between(p.mu, p.wrap)) GTEST_SKIP() << "long; set HAWSER_FULL";
  if (p.wrap > 7) p.EA = 1e8;
  expect_exact(p);
}
INSTANTIATE_TEST_SUITE_P(Line, LineCapstan,
                         ::testing::Combine(::testing::Values(Moving::line), ::testing::Values(true),
                                            ::testing::Values(0.1, 0.3, 0.5),
                                            ::testing::Values(M_PI / 2, M_PI, 2 * M_PI, 4 * M_PI)));
INSTANTIATE_TEST_SUITE_P(Cable, LineCapstan,
                         ::testing::Combine(::testing::Values(Moving::line), ::testing::Values(false),
                                            ::testing::Values(0.1, 0.3, 0.5), ::testing::Values(M_PI)));
INSTANTIATE_TEST_SUITE_P(Drum, LineCapstan,
                         ::testing::Combine(::testing::Values(Moving::drum), ::testing::Values(true),
                                            ::testing::Values(0.1, 0.3, 0.5), ::testing::Values(M_PI)));

}  // namespace
}  // namespace hawser::test::capstan::line_contact_capstan_test
