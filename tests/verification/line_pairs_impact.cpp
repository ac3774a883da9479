// Two crossing beams collide at 2 m/s: the peak force is within 3 % of that with fine steps, and the energy
// does not increase, for steps of 1/12 to 20 contact periods and automatic ones.
#include <algorithm>

#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_impact_test {
namespace {

struct Impact {
  double peak = 0, gain = 0, kept = 0;  // N; largest and last energy over the first
  int steps = 0, rejected = 0;
};

constexpr double kStiffness = 2e6, kMass = 20;  // N/m², kg/m

// h <= 0: automatic steps.
Impact meet(double h, double friction) {
  model::Case c;
  c.environment.gravity = 0;
  model::LineType type = beam_type(1e7, 2e4, 2e4, kMass);
  type.outer_diameter = type.contact_diameter = 0.1;
  type.rotary_inertia = Vec3(1, 0.5, 0.5) * (kMass * 0.01 / 8);
  c.line_types = {type};
  for (int l = 0; l < 2; ++l) {
    model::Line line;
    line.name = l ? "second" : "first";
    line.sections.push_back({type.name, 2, 8, 1});
    line.start = model::Start::points;
    const Vec3 along = l ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 middle(l ? 0.2 : 0, 0, l ? 0.11 : 0);
    line.points = {middle - along, middle + along};
    c.lines.push_back(line);
  }
  touch(c, kStiffness, 1e-4, friction);
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.step = std::max(h, 0.0);
  c.dynamics.duration = 0.2;
  Simulation s(PETSC_COMM_WORLD, c);
  for (int n = 0; n < s.local().nodes(); ++n)
    if (s.mesh().node(static_cast<size_t>(n)).line == 1)
      s.state().v[static_cast<size_t>(n)] = Vec3(friction > 0 ? 0.7 : 0, 0, -2);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto total = [&] {
    const Energy e = s.system().energy(d.committed_kinematics());
    return e.kinetic + e.strain;
  };
  const double first = total();
  Impact out;
  d.run(
      0.2, [](double) { return 1e300; },
      [&](const StepInfo& info) {
        out.peak = std::max(out.peak, s.line_pairs()->normal_force());
        out.kept = total() / first;
        out.gain = std::max(out.gain, out.kept);
        ++out.steps;
        out.rejected += info.rejected;
        return true;
      });
  return out;
}

TEST(MeetingLines, ForceDoesNotDependOnTheStep) {
  const double period = 2 * M_PI * std::sqrt(0.5 * kMass / kStiffness);
  for (const double friction : {0.0, 0.3}) {
    const Impact fine = meet(period / 48, friction);
    for (const double steps : {0.05, 0.5, 3.0, 6.0, 12.0, 0.0}) {
      const Impact i = meet(steps > 0 ? period / steps : 0, friction);
      if (steps > 0)
        printf("  friction %.1f, step T/%.4g", friction, steps);
      else
        printf("  friction %.1f, automatic", friction);
      printf(": peak %.1f N (%.1f), energy at most %.5f, at last %.5f (%.5f); %d steps, %d rejected\n",
             i.peak, fine.peak, i.gain, i.kept, fine.kept, i.steps, i.rejected);
      EXPECT_NEAR(i.peak, fine.peak, 0.03 * fine.peak);
      EXPECT_LT(i.gain, 1 + 1e-3);
    }
    EXPECT_LT(fine.gain, 1 + 1e-5);
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs_impact_test
