// The force term of docs/how-to/add-a-force-term.md: its tangent equals finite differences, its force is the
// gradient of its potential, and its field has the expected values.
#include "../docs/how-to/constant_pull.hpp"

#include <gtest/gtest.h>

#include "support/taylor_model.hpp"

namespace hawser::test::constant_pull_test {
namespace {

const Vec3 kPoint(1, 7, 2);
constexpr double kTension = 1000;
constexpr int kNode = 2;

TEST(ConstantPull, Tangent) {
  SuiteModel m;
  m.system->add(std::make_unique<ConstantPull>(m.system->mesh(), kNode, kPoint, kTension));
  expect_tangent(*m.system, m.trial, "constant pull");
}

TEST(ConstantPull, ForceIsTheGradientOfItsPotential) {
  SuiteModel m;
  m.system->add(std::make_unique<ConstantPull>(m.system->mesh(), kNode, kPoint, kTension));
  const State s = state_of(m.system->mesh(), m.trial);
  const std::vector<double> r = residual(*m.system, s, m.trial.h);
  constexpr double kStep = 1e-4;
  for (int c = 0; c < 3; ++c) {
    const auto potential = [&](double step) {
      State moved = s;
      moved.x[kNode][c] += step;
      return m.system->energy(at_end(moved, m.trial.h)).potential;
    };
    const double slope = (potential(kStep) - potential(-kStep)) / (2 * kStep);
    EXPECT_NEAR(r[3 * static_cast<size_t>(m.system->mesh().block[kNode]) + static_cast<size_t>(c)], slope,
                1e-4);
  }
}

TEST(ConstantPull, Field) {
  SuiteModel m;
  m.system->add(std::make_unique<ConstantPull>(m.system->mesh(), kNode, kPoint, kTension));
  const State s = state_of(m.system->mesh(), m.trial);
  const FieldRegistry registry = m.system->fields();
  ASSERT_EQ(registry.sources().size(), 1u);
  EXPECT_EQ(registry.sources()[0].name, "pull");
  std::vector<double> values(24, 7.0);
  registry.sources()[0].fill(at_end(s, m.trial.h), values);
  for (int n = 0; n < 8; ++n) {
    const Vec3 pull(values.data() + 3 * n);
    const Vec3 way = kPoint - s.x[static_cast<size_t>(n)];
    EXPECT_LT((pull - (n == kNode ? kTension : 0) * way.normalized()).norm(), 1e-9) << n;
  }
}

}  // namespace
}  // namespace hawser::test::constant_pull_test
