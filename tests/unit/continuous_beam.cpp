// Beams on supports that settle.
#include "hawser/kernels/continuous_beam.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::continuous_beam_test {
namespace {

// On two spans of lengths a and b the middle support is a point load on a simply supported beam: a force F
// raises it by F a² b²/(3 EI (a + b)), with the moment -F a b/(a + b).
TEST(ContinuousBeam, MiddleOfTwoSpans) {
  const double a = 4, b = 6, EI = 2e7, u = 1e-3;
  const std::vector<BeamSpan> spans{{a, EI}, {b, EI}};
  const std::vector<Vec3> raised{Vec3::Zero(), Vec3(0, 0, u), Vec3::Zero()};
  const std::vector<SettlementEffect> effects = settlement_effects(spans, raised);
  const double force = 3 * EI * (a + b) * u / (a * a * b * b);
  EXPECT_NEAR(effects[1].force.z(), force, 1e-9 * force);
  EXPECT_NEAR(effects[1].moment.z(), -force * a * b / (a + b), 1e-9 * force);
  EXPECT_NEAR(effects[0].force.z(), -force * b / (a + b), 1e-9 * force);
  EXPECT_NEAR(effects[2].force.z(), -force * a / (a + b), 1e-9 * force);
}

// Inside many equal spans: (6 EI/L³) times the mean of 4 (1 - cos t)²/(4 + 2 cos t) over a period is
// 12 (9/sqrt(3) - 4) EI/L³.
TEST(ContinuousBeam, OneOfManySpans) {
  const double L = 3, EI = 2e7;
  const std::vector<BeamSpan> spans(40, BeamSpan{L, EI});
  std::vector<Vec3> raised(41, Vec3::Zero());
  raised[20] = Vec3(0, 1, 0);
  const double stiffness = 12 * (9 / std::sqrt(3.0) - 4) * EI / (L * L * L);
  EXPECT_NEAR(settlement_effects(spans, raised)[20].force.y(), stiffness, 1e-9 * stiffness);
}

// A line through the supports, and a single span, have no effect.
TEST(ContinuousBeam, MovesAsARigidBody) {
  const std::vector<BeamSpan> spans{{2, 1e7}, {5, 2e7}, {3, 1e7}};
  const std::vector<Vec3> turned{Vec3(0, 0, 1), Vec3(0, 0, 3), Vec3(0, 0, 8), Vec3(0, 0, 11)};
  for (const SettlementEffect& e : settlement_effects(spans, turned)) EXPECT_LT(e.force.norm(), 1e-6);
  const std::vector<Vec3> of_two{Vec3::Zero(), Vec3(0, 0, 1)};
  for (const SettlementEffect& e : settlement_effects(std::span(spans).first(1), of_two))
    EXPECT_EQ(e.force, Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace hawser::continuous_beam_test
