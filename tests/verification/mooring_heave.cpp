// Studless chain in 50, 200 and 600 m of water: at rest, in a current, its fairlead heaving by 2 and 5 m.
#include "hawser/terms/seabed.hpp"
#include "support/rig.hpp"

namespace hawser::test {
namespace {

// The line's axis touches the bed: its contact diameter is nothing, its bed 100 kN/m³ of its 0.252 m.
// OrcaFlex's studless chain has an axial drag of 1.15 on the bar's diameter over pi (its manual, "Chain"): on
// that of the equivalent cylinder, 1.8 bars, 0.64, and 0.64/pi on the skin.
model::Case chain(double depth, double x, double length, int elements) {
  model::LineType t = cable_type(1.674e9, 390);
  t.outer_diameter = 0.252, t.contact_diameter = 1e-9;
  t.Cd_normal = 1.37, t.Cd_axial = 0.64 / M_PI;
  model::Case c = one_line(t, length, elements, anchor({x, 0, -depth}), {});
  c.environment.gravity = 9.80665;
  c.environment.water.present = true, c.environment.water.depth = depth;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true, bed.depth = depth;
  bed.basis = model::StiffnessBasis::per_length, bed.normal_stiffness = 25200;
  bed.as_laid = false;
  model::Body b;
  b.name = "vessel";
  c.bodies.push_back(b);
  model::End e;
  e.kind = model::EndKind::body, e.body = "vessel";
  c.lines[0].end_b = e;
  c.dynamics.enabled = false;
  return c;
}

double reaction(Simulation& sim, int node) {
  const auto& r = sim.system().reactions();
  return Eigen::Map<const Vec3>(r.data() + 3 * sim.local().block[static_cast<size_t>(node)]).norm();
}

// Converged solution of the line without bending on the same springs (collocation, 1e-10).
TEST(MooringHeave, AtRest) {
  struct Row {
    const char* name;
    double depth, x, length, fairlead, anchor;
    double speed = 0, direction = 0;
  };
  for (const Row& r : {Row{"50 m", 50, 400, 410, 1005345.107, 839274.1122},
                       {"200 m", 200, 700, 760, 2071847.015, 1407887.126},
                       {"600 m", 600, 1500, 1700, 5237544.67, 3248636.039},
                       {"50 m, current to -x", 50, 400, 410, 990307.3152, 925727.9955, 1, M_PI},
                       {"50 m, current to +y", 50, 400, 410, 1024630.826, 858563.9037, 1, M_PI / 2}}) {
    model::Case c = chain(r.depth, r.x, r.length, 200);
    if (r.speed > 0) {
      c.environment.water.current.profile = {{0, r.speed, r.direction}};
      c.line_types[0].Cd_axial = 0.64;
    }
    Simulation sim(PETSC_COMM_SELF, c);
    const StaticsReport report = sim.solve_statics();
    const double T = reaction(sim, 200), A = reaction(sim, 0);
    printf("  %-20s %3d iterations, fairlead %+.4f %%, anchor %+.4f %%\n", r.name, report.iterations,
           100 * (T / r.fairlead - 1), 100 * (A / r.anchor - 1));
    EXPECT_NEAR(T, r.fairlead, 1e-3 * r.fairlead) << r.name;
    EXPECT_NEAR(A, r.anchor, 1e-3 * r.anchor) << r.name;
  }
}

// OrcaFlex (series in MoorDyn's tests, quasi_static_chain): tension of the last half segment, 5 m from the
// ends, over a heave of 10 s; friction 0.5, not in statics: the mean of its anchor's tension, 1400 kN, is
// that of the chain at rest without friction (1408 kN; with it 900 kN).
TEST(MooringHeave, FairleadMoves) {
  struct Row {
    double heave, most, least, deviation, anchor_most, anchor_least;  // m, kN
  };
  for (const Row& r : {Row{2, 2304.96, 1828.374, 177.933, 1482.163, 1319.76},
                       {5, 3070.45, 1027.836, 717.176, 1984.592, 867.055}}) {
    model::Case c = chain(200, 700, 760, 76);
    model::Seabed& bed = c.environment.seabed;
    bed.damping = 1e4 * 0.252;
    bed.friction.axial = bed.friction.lateral = 0.5, bed.friction.mobilisation_length = 0.05;
    model::HarmonicMotion m;
    m.amplitude = Vec3(0, 0, r.heave), m.period = 10;
    c.bodies[0].motion = m, c.bodies[0].ramp = 10;
    c.dynamics.enabled = true;
    c.dynamics.duration = 50, c.dynamics.step = 0.1;
    Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    sim.dynamics().start(sim.state());
    double most = 0, least = 1e9, a_most = 0, a_least = 1e9, sum = 0, squares = 0;
    int count = 0;
    sim.dynamics().run(
        50, [](double) { return 50.0; },
        [&](const StepInfo& info) {
          if (info.time < 30 - 1e-9) return true;
          const Kinematics k = sim.dynamics().kinematics();
          const auto tension = [&](size_t i) {
            return 1.674e6 * ((k.x[i + 1] - k.x[i]).norm() / 10 - 1);
          };  // kN
          const double T = tension(75), A = tension(0);
          most = std::max(most, T), least = std::min(least, T), a_most = std::max(a_most, A),
          a_least = std::min(a_least, A);
          sum += T, squares += T * T, ++count;
          return true;
        });
    const double deviation = std::sqrt(squares / count - sum * sum / count / count);
    printf(
        "  heave %g m: fairlead %.1f ... %.1f kN (%+.1f, %+.1f %%), deviation %.1f (%+.1f %%), anchor %.1f "
        "... %.1f kN "
        "(%+.1f, %+.1f %%)\n",
        r.heave, least, most, 100 * (least / r.least - 1), 100 * (most / r.most - 1), deviation,
        100 * (deviation / r.deviation - 1), a_least, a_most, 100 * (a_least / r.anchor_least - 1),
        100 * (a_most / r.anchor_most - 1));
    EXPECT_NEAR(most, r.most, 0.05 * r.most);
    EXPECT_NEAR(least, r.least, 0.05 * r.least);
    EXPECT_NEAR(deviation, r.deviation, 0.05 * r.deviation);
    EXPECT_NEAR(a_most, r.anchor_most, 0.1 * r.anchor_most);
    EXPECT_NEAR(a_least, r.anchor_least, 0.1 * r.anchor_least);
  }
}

}  // namespace
}  // namespace hawser::test
