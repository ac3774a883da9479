// Rotation of a node within a step: less than half a turn; otherwise the step is divided, or the run stops
// with an error.
#include "hawser/base/error.hpp"
#include "support/rig.hpp"

namespace hawser::test::dynamics_turns_test {
namespace {

// A free beam that spins about its own axis, with steps of 0.1 s if the rotation allows them.
model::Case spinning() {
  model::LineType type = beam_type(1e6, 1e3, 1e3, 5);
  type.rotary_inertia = Vec3(0.02, 0.01, 0.01);
  model::Case c = one_line(type, 2, 2, {}, {});
  c.environment.gravity = 0;
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {Vec3(0, 0, 0), Vec3(2, 0, 0)};
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.step = 0.1;
  c.dynamics.duration = 1;
  return c;
}

struct Spin {
  double turn = 0;  // rad, largest within a step
  int steps = 0, rejected = 0;
};

Spin spin(const model::Case& c, double rate) {
  Simulation s(PETSC_COMM_SELF, c);
  for (Vec3& w : s.state().w) w = Vec3(rate, 0, 0);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  Spin out;
  d.run(
      1, [](double) { return 1.0; },
      [&](const StepInfo& info) {
        out.turn = std::max(out.turn, rate * info.h);
        ++out.steps;
        out.rejected += info.rejected;
        return true;
      });
  EXPECT_NEAR(d.committed().s.w[1].x(), rate, 1e-6 * rate);
  return out;
}

TEST(Turns, OfAStepAreLessThanHalfATurn) {
  const Spin slow = spin(spinning(), 30);  // 3 rad
  EXPECT_EQ(slow.steps, 10);
  EXPECT_EQ(slow.rejected, 0);
  const Spin fast = spin(spinning(), 50);  // 5 rad
  EXPECT_LE(fast.turn, M_PI);
  EXPECT_GT(fast.rejected, 0);
  EXPECT_GE(fast.steps, 20);
}

TEST(Turns, TooFastForTheShortestStepAreReportedWithTheirPlace) {
  model::Case c = spinning();
  c.dynamics.min_step = 0.1;
  try {
    spin(c, 50);
    FAIL() << "a step of 5 rad";
  } catch (const SolveError& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("half a turn"), std::string::npos) << text;
    EXPECT_NE(text.find("line "), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace hawser::test::dynamics_turns_test
