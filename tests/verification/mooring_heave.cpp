// Studless chain in 50, 200 and 600 m of water at rest, in a current, and with its fairlead heaving by 2 and
// 5 m: against collocation and OrcaFlex.
#include <cstdlib>

#include "hawser/terms/bed_contact.hpp"
#include "support/rig.hpp"

namespace hawser::test::mooring_heave_test {
namespace {

struct Place {
  double depth, x, length;  // m
};
constexpr Place k50{50, 400, 410}, k200{200, 700, 760}, k600{600, 1500, 1700};

// OrcaFlex's studless chain has an axial drag coefficient of 1.15 on the bar's diameter over pi (its manual,
// "Chain"). On the equivalent cylinder of 1.8 bar diameters this is 0.64, and 0.64/pi on the skin.
model::Case chain(const Place& at, int elements) {
  model::LineType t = cable_type(1.674e9, 390);
  t.outer_diameter = 0.252;
  t.Cd_normal = 1.37;
  t.Cd_axial = 0.64 / M_PI;
  model::Case c = one_line(t, at.length, elements, anchor({at.x, 0, -at.depth}), {});
  c.environment.gravity = 9.80665;
  c.environment.water.present = true;
  c.environment.water.depth = at.depth;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true;
  bed.depth = at.depth;
  bed.as_laid = false;
  model::Body b;
  b.name = "vessel";
  c.bodies.push_back(b);
  model::End e;
  e.kind = model::EndKind::body;
  e.carrier = "vessel";
  c.lines[0].end_b = e;
  c.dynamics.enabled = false;
  return c;
}

// Contact of the line's axis with the bed: contact diameter zero, bed stiffness 100 kN/m³ times 0.252 m.
model::Case on_axis(const Place& at, int elements) {
  model::Case c = chain(at, elements);
  c.line_types[0].contact_diameter = 1e-9;
  model::Seabed& bed = c.environment.seabed;
  bed.basis = model::StiffnessBasis::per_length;
  bed.normal_stiffness = 25200;
  return c;
}

// As in OrcaFlex: a given contact diameter, bed stiffness 100 kN/m³ normal and tangential.
model::Case on_diameter(const Place& at, int elements, double contact) {
  model::Case c = chain(at, elements);
  c.line_types[0].contact_diameter = contact;
  model::Seabed& bed = c.environment.seabed;
  bed.basis = model::StiffnessBasis::per_area;
  bed.normal_stiffness = 1e5;
  bed.damping = 1e4;
  bed.friction.axial = bed.friction.lateral = 0.5;
  bed.friction.shear_stiffness = 1e5;
  return c;
}
// Contact diameter of studless chain, 3.35 bar diameters (OrcaFlex manual, "Chain").
constexpr double kContact = 3.35 * 0.14;

double reaction(Simulation& sim, size_t node) {
  const auto& r = sim.system().reactions();
  return Eigen::Map<const Vec3>(r.data() + 3 * sim.local().block[node]).norm();
}

// Reference: converged collocation (1e-10) of the line without bending on the same springs.
TEST(MooringHeave, AtRest) {
  struct Row {
    const char* name;
    Place at;
    double fairlead, anchor;
    double speed = 0, direction = 0;
  };
  for (const Row& r : {Row{"50 m", k50, 1005345.107, 839274.1122},
                       {"200 m", k200, 2071847.015, 1407887.126},
                       {"600 m", k600, 5237544.67, 3248636.039},
                       {"50 m, current to -x", k50, 990307.3152, 925727.9955, 1, M_PI},
                       {"50 m, current to +y", k50, 1024630.826, 858563.9037, 1, M_PI / 2}}) {
    model::Case c = on_axis(r.at, 200);
    if (r.speed > 0) {
      c.environment.water.current.profile = {{0, r.speed, r.direction}};
      c.line_types[0].Cd_axial = 0.64;
    }
    Simulation sim(PETSC_COMM_SELF, c);
    const StaticsReport report = sim.solve_statics();
    const double T = reaction(sim, 200);
    const double A = reaction(sim, 0);
    printf("  %-20s %3d iterations, fairlead %+.4f %%, anchor %+.4f %%\n", r.name, report.iterations,
           100 * (T / r.fairlead - 1), 100 * (A / r.anchor - 1));
    EXPECT_NEAR(T, r.fairlead, 1e-3 * r.fairlead) << r.name;
    EXPECT_NEAR(A, r.anchor, 1e-3 * r.anchor) << r.name;
  }
}

// End forces at the start of the motions below (MoorDyn's tests, quasi_static_chain); and OrcaFlex 11.6c as
// published with CableDyn, with contact on 0.252 m and an axial drag of 0.64 on the skin.
TEST(MooringHeave, AtRestAsOrcaFlex) {
  struct Row {
    const char* name;
    Place at;
    double contact, fairlead, anchor;  // m, kN
    double direction = NAN;            // of a current of 1 m/s
  };
  for (const Row& r : {Row{"50 m", k50, kContact, 991.6, 826.2},
                       {"200 m", k200, kContact, 2065.4, 1402.2},
                       {"600 m", k600, kContact, 5232.6, 3244.2},
                       {"50 m, 11.6c", k50, 0.252, 998.1109, 832.2422},
                       {"50 m, 11.6c, current to -x", k50, 0.252, 983.6371, 919.1570, M_PI},
                       {"50 m, 11.6c, current to +y", k50, 0.252, 1018.8614, 852.9076, M_PI / 2}}) {
    model::Case c = on_diameter(r.at, 200, r.contact);
    if (!std::isnan(r.direction)) {
      c.environment.water.current.profile = {{0, 1, r.direction}};
      c.line_types[0].Cd_axial = 0.64;
    }
    Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    const double T = reaction(sim, 200) / 1e3;
    const double A = reaction(sim, 0) / 1e3;
    printf("  %-27s fairlead %.1f kN (%+.3f %%), anchor %.1f kN (%+.3f %%)\n", r.name, T,
           100 * (T / r.fairlead - 1), A, 100 * (A / r.anchor - 1));
    EXPECT_NEAR(T, r.fairlead, 2e-3 * r.fairlead) << r.name;
    EXPECT_NEAR(A, r.anchor, 2e-3 * r.anchor) << r.name;
  }
}

struct Range {
  double least = HUGE_VAL, most = -HUGE_VAL;
  void add(double v) {
    least = std::min(least, v);
    most = std::max(most, v);
  }
};

struct Heaved {
  Range fairlead, anchor;  // kN
  double deviation = 0;    // standard deviation of the fairlead's force
};

// Two periods of 10 s after one of ramp and one to settle; end forces.
Heaved heave(const Place& at, double amplitude, double element, double step) {
  const int elements = static_cast<int>(std::lround(at.length / element));
  model::Case c = on_diameter(at, elements, kContact);
  model::HarmonicMotion m;
  m.amplitude = Vec3(0, 0, amplitude);
  m.period = 10;
  c.bodies[0].motion = m;
  c.bodies[0].ramp = 10;
  c.dynamics.enabled = true;
  c.dynamics.duration = 40;
  c.dynamics.step = step;
  Simulation sim(PETSC_COMM_SELF, c);
  sim.solve_statics();
  sim.dynamics().start(sim.state());
  Heaved out;
  double sum = 0, squares = 0;
  int count = 0;
  sim.dynamics().run(
      40, [](double) { return 40.0; },
      [&](const StepInfo& info) {
        if (info.time < 20 - 1e-9) return true;
        const double T = reaction(sim, static_cast<size_t>(elements)) / 1e3;
        out.fairlead.add(T);
        out.anchor.add(reaction(sim, 0) / 1e3);
        sum += T;
        squares += T * T;
        ++count;
        return true;
      });
  out.deviation = std::sqrt(squares / count - sum * sum / count / count);
  return out;
}

// OrcaFlex (series in MoorDyn's tests, quasi_static_chain), 10 m segments. Friction of 0.5, but not in
// statics: its mean anchor tension in 200 m, 1400 kN, is that of the chain at rest without friction (1402 kN;
// with friction 900 kN).
struct HeaveRow {
  Place at;
  double heave, element, step;       // m, m, s
  double least, most, deviation;     // kN, fairlead
  double anchor_least, anchor_most;  // kN; NAN: not published
};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr HeaveRow kRows[] = {{k50, 2, 5, 0.1, 899.198, 1093.194, 58.93, 778.104, 877.743},
                              {k50, 5, 1.25, 0.05, 368.389, 1563.742, 376.786, 484.67, 1152.968},
                              {k200, 2, 10, 0.1, 1828.374, 2304.96, 177.933, 1319.76, 1482.163},
                              {k200, 5, 10, 0.1, 1027.836, 3070.45, 717.176, 867.055, 1984.592},
                              {k600, 2, 10, 0.1, 4466.209, 5970.503, 527.484, kNone, kNone},
                              {k600, 5, 10, 0.1, 2820.764, 7565.459, 1703.926, kNone, kNone}};

void compare(const HeaveRow& r, double element, double step) {
  const Heaved h = heave(r.at, r.heave, element, step);
  const auto off = [](double value, double of) { return 100 * (value / of - 1); };
  printf(
      "  %3g m, heave %g m, elements of %g m, step %g s: fairlead %.1f ... %.1f kN (%+.1f, %+.1f %%), "
      "deviation %+.1f %%, anchor %.1f ... %.1f kN",
      r.at.depth, r.heave, element, step, h.fairlead.least, h.fairlead.most, off(h.fairlead.least, r.least),
      off(h.fairlead.most, r.most), off(h.deviation, r.deviation), h.anchor.least, h.anchor.most);
  EXPECT_NEAR(h.fairlead.least, r.least, 0.05 * r.least);
  EXPECT_NEAR(h.fairlead.most, r.most, 0.05 * r.most);
  EXPECT_NEAR(h.deviation, r.deviation, 0.05 * r.deviation);
  if (!std::isnan(r.anchor_least)) {
    printf(" (%+.1f, %+.1f %%)", off(h.anchor.least, r.anchor_least), off(h.anchor.most, r.anchor_most));
    EXPECT_NEAR(h.anchor.least, r.anchor_least, 0.1 * r.anchor_least);
    EXPECT_NEAR(h.anchor.most, r.anchor_most, 0.1 * r.anchor_most);
  }
  printf("\n");
}

TEST(MooringHeave, FairleadMoves) {
  for (const HeaveRow& r : kRows) compare(r, r.element, r.step);
}

// A quarter of the step and half the element length, down to 1.25 m: the results are still within the bounds,
// so those above are converged.
TEST(MooringHeave, FairleadMovesFine) {
  if (!std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  for (const HeaveRow& r : kRows) compare(r, std::max(1.25, 0.5 * r.element), 0.25 * r.step);
}

// Touchdown of one element after the other must not cause oscillations: the extremes do not change with the
// step. If the bed acted at the nodes only, the smallest tension would fall by 9 % from the first step to the
// second.
TEST(MooringHeave, TouchdownDoesNotRing) {
  const Heaved coarse = heave(k50, 5, 2.5, 0.05);
  const Heaved fine = heave(k50, 5, 2.5, 0.025);
  printf("  fairlead's least %.1f kN at steps of 0.05 s, %.1f kN at 0.025 s\n", coarse.fairlead.least,
         fine.fairlead.least);
  EXPECT_NEAR(fine.fairlead.least, coarse.fairlead.least, 0.03 * coarse.fairlead.least);
  EXPECT_NEAR(fine.fairlead.most, coarse.fairlead.most, 0.01 * coarse.fairlead.most);
}

}  // namespace
}  // namespace hawser::test::mooring_heave_test
