// Snap loads: lines that come taut, whose largest tension the steps resolve by default.
#include <algorithm>
#include <cmath>
#include <memory>

#include "hawser/terms/line_structure.hpp"
#include "support/rig.hpp"

namespace hawser::test::snap_loads_test {
namespace {

struct Snap {
  double largest = 0;  // N
  int steps = 0;
};

// Runs a case from rest or, with an initial velocity of its last node [m/s].
Snap snap(const model::Case& c, double velocity = 0) {
  Simulation sim(MPI_COMM_WORLD, c);
  State s = sim.state();
  const int last = sim.local().mesh->lines[0].end_node(LineEnd::B);
  for (size_t n = 0; n < s.v.size(); ++n)
    if (sim.local().global[n] == last) s.v[n].z() = -velocity;
  Snap out;
  sim.dynamics().start(s);
  sim.dynamics().run(
      c.dynamics.duration, [&](double) { return c.dynamics.duration; },
      [&](const StepInfo&) {
        LineTension line;
        sim.system().find<LineStructure>()->tensions(sim.dynamics().committed_kinematics(), {&line, 1});
        MPI_Allreduce(MPI_IN_PLACE, &line.tension, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
        out.largest = std::max(out.largest, line.tension);
        ++out.steps;
        return true;
      });
  return out;
}

// A mass of 100 kg on a light rope of 4 m that is straight and without tension.
model::Case falling(const model::LineType& type, double step) {
  model::Case c = one_line(type, 4, 8, anchor(Vec3::Zero()), {});
  c.environment.gravity = 9.81;
  c.lines[0].end_b.kind = model::EndKind::free;
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {Vec3::Zero(), Vec3(0, 0, -4)};
  model::PointMass mass;
  mass.at = 4;
  mass.mass = 100;
  c.lines[0].masses = {mass};
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 0.2;
  c.dynamics.step = step;
  c.contact.between_lines.enabled = false;
  return c;
}

// T = m g + sqrt((m g)² + m v² EA/L) of a mass m with the speed v on a spring. Steps of 100 ms miss
// the half wave of 63 ms.
TEST(SnapLoads, OfAFallingMassAreThoseOfASpring) {
  constexpr double kMass = 100;
  constexpr double kEA = 1e6;
  constexpr double kSpeed = 1;
  constexpr double kWeight = kMass * 9.81;
  const double exact = kWeight + std::sqrt(kWeight * kWeight + kMass * kSpeed * kSpeed * kEA / 4);
  for (const double step : {0.0, 0.1}) {
    model::Case c = falling(cable_type(kEA, 0.01), step);
    const Snap resolved = snap(c, kSpeed);
    c.dynamics.resolve_impacts = false;
    const Snap fixed = snap(c, kSpeed);
    printf("  step %g s: %.1f N in %d steps, fixed %.1f N in %d; exact %.1f N\n", step, resolved.largest,
           resolved.steps, fixed.largest, fixed.steps, exact);
    EXPECT_NEAR(resolved.largest, exact, 0.01 * exact);
    if (step > 0) {
      EXPECT_LT(resolved.steps, 200);
      EXPECT_GT(std::abs(fixed.largest / exact - 1), 0.05);
    }
  }
}

// A wire of 2.5 kg/m hangs 1 mm slack with 100 kg at its end, and comes taut after a fall of 1.3 mm. The
// bound is that of the mass alone.
TEST(SnapLoads, OfASlackWireConverge) {
  constexpr double kWeight = 981;
  constexpr double kEA = 5e7;
  constexpr double kLength = 3.8;
  constexpr double kFall = 1.3e-3;
  const double bound = kWeight + std::sqrt(kWeight * kWeight + 2 * kWeight * kFall * kEA / kLength);
  const auto run = [](double damping, double longest) {
    model::LineType type = cable_type(kEA, 2.5);
    type.outer_diameter = type.contact_diameter = 0.02;
    type.stiffness_damping = damping;
    model::Case c = falling(type, 0);
    c.lines[0].sections[0].length = kLength;
    c.lines[0].sections[0].elements = 76;
    c.lines[0].points = {Vec3::Zero(), Vec3(0.03, 0, -1.9), Vec3(0, 0, -3.7987)};
    c.lines[0].masses[0].at = kLength;
    c.dynamics.duration = 0.05;
    if (longest > 0) c.dynamics.max_step = longest;
    return snap(c);
  };
  const int undamped = run(0, 0).steps;
  for (const double damping : {1e-4, 1e-3}) {
    const Snap fine = run(damping, 5e-6);
    const Snap found = run(damping, 0);
    printf("  stiffness_damping %g s: %.0f N in %d steps, %.0f N in %d; bound %.0f N\n", damping,
           found.largest, found.steps, fine.largest, fine.steps, bound);
    // The damper's part jumps where the wire comes taut.
    EXPECT_NEAR(found.largest, fine.largest, 0.1 * fine.largest);
    EXPECT_LT(found.largest, bound);
    EXPECT_LT(found.steps, 1.5 * undamped);
  }
}

}  // namespace
}  // namespace hawser::test::snap_loads_test
