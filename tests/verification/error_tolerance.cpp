// The tolerance of the local error is relative to the thickness of each line.
#include <gtest/gtest.h>

#include "support/rig.hpp"

namespace hawser::test::error_tolerance_test {
namespace {

// Number of automatic steps of a wire that is released from the horizontal and swings down.
int steps_of_a_wire(bool beside_a_pipe) {
  model::LineType wire = cable_type(1e5, 0.5);
  wire.outer_diameter = 0.004;
  model::Case c = one_line(wire, 2, 4, anchor({0, 0, 0}), {});
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {Vec3(0, 0, 0), Vec3(2, 0, 0)};
  if (beside_a_pipe) {
    model::LineType pipe = beam_type(1e9, 1e7, 1e7, 500);
    pipe.name = "pipe";
    pipe.outer_diameter = 1;
    c.line_types.push_back(pipe);
    model::Line line = c.lines[0];
    line.name = "pipe";
    line.sections[0].type = "pipe";
    line.end_a = anchor({0, 50, 0});
    line.end_b = anchor({2, 50, 0});
    line.points = {line.end_a.at, line.end_b.at};
    c.lines.push_back(line);
  }
  c.environment.gravity = 9.81;
  c.statics.enabled = false;
  c.contact.between_lines.enabled = false;
  c.dynamics.max_step = 0.2;
  Simulation s(PETSC_COMM_SELF, c);
  s.dynamics().start(s.state());
  int steps = 0;
  s.dynamics().run(
      1, [](double) { return 1.0; },
      [&](const StepInfo&) {
        ++steps;
        return true;
      });
  return steps;
}

// A nearly motionless pipe of 1 m, 50 m away, does not lengthen the steps of a wire of 4 mm.
TEST(ErrorTolerance, IsThatOfEachLine) {
  const int alone = steps_of_a_wire(false);
  const int beside = steps_of_a_wire(true);
  EXPECT_GT(alone, 50);
  EXPECT_GE(beside, 0.9 * alone);
}

}  // namespace
}  // namespace hawser::test::error_tolerance_test
