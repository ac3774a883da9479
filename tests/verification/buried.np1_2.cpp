// Buried lines from case files: a pipe in a trench, an anchor below the bed, the shape of a chain that cuts
// through the soil.
#include <fmt/format.h>

#include <cmath>

#include "hawser/io/case_reader.hpp"
#include "support/mooring.hpp"

namespace hawser::test::buried {
namespace {

bool first_rank() {
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  return rank == 0;
}

model::Case read(const std::string& text) {
  return io::read_case_text(text, HAWSER_SOURCE_DIR "/tests/buried.yaml");
}

// Effective tensions at the nodes of a model on one rank.
std::vector<double> tensions(Simulation& sim) {
  std::vector<double> out(sim.state().x.size());
  const FieldRegistry fields = sim.system().fields();
  for (const FieldSource& f : fields.sources())
    if (f.name == "effective_tension") f.fill(sim.state().at_rest(), out);
  return out;
}

// Solves statics on one rank and on all; positions must be equal.
void settle(Simulation& all, Simulation& one) {
  all.solve_statics();
  one.solve_statics();
  expect_same_positions(all, all.state().at_rest(), one.state().at_rest(), 1e-7, "statics");
}

// 1.2 km of pipe buried 1 m deep and pulled at one end. Its depth does not change; axial soil resistance of
// 500 N/m, mobilised at 5 mm, acts as friction on the bed (closed form of displacement and tension).
TEST(Buried, PipeInATrench) {
  struct Row {
    const char* force;
    double u, tension;  // m; N, 50 m from the end
  };
  for (const Row& r : {Row{"17677.66953", 0.0025, 8716.305381908778},
                       {"50000", 0.0075, 26378.682326731465},
                       {"200000", 0.0825, 175000},
                       {"400000", 0.3225, 375000}}) {
    const model::Case c = read(std::string(R"(hawser: 1
environment: {gravity: 10, water: {depth: 50}, current: {speed: 1, direction_deg: 90}, seabed: {depth: 50, friction: 0.5}}
line_types: {pipe: {outer_diameter: 0.1, mass_per_length: 100, EA: 5e8, EI: 1e5, GJ: 1e5}}
lines:
  pipe:
    sections: [{type: pipe, length: 1200, elements: 1200}]
    end_a: {anchor: [0, 0, -51], clamped: true, direction: [1, 0, 0]}
    end_b: free
    start: straight
    buried: [{resistance: {axial: 500, normal: 5000}, mobilisation_length: {axial: 5 mm}}]
    loads: [{at: end_b, force: [)") +
                               r.force + ", 0, 0]}]\n");
    Simulation all(PETSC_COMM_WORLD, c);
    Simulation one(PETSC_COMM_SELF, c);
    settle(all, one);
    const State& s = one.state();
    const double u = s.x[1200].x() - 1200;
    const std::vector<double> tension = tensions(one);
    if (first_rank())
      printf("  F %s N: u %+.3f %%, tension %+.3f %%\n", r.force, 100 * (u / r.u - 1),
             100 * (tension[1150] / r.tension - 1));
    EXPECT_NEAR(u, r.u, 5e-3 * r.u);
    EXPECT_NEAR(tension[1150], r.tension, 5e-3 * r.tension);
    // Submerged weight over 5000 N/m mobilised at a tenth of the diameter; the current has no drag.
    const double down = (1000 - 1025 * 10 * M_PI / 4 * 0.01) * 0.01 / 5000;
    for (size_t n = 100; n <= 1100; ++n) {
      EXPECT_NEAR(s.x[n].z(), -51 - down, 1e-5);
      EXPECT_NEAR(s.x[n].y(), 0, 1e-9);
    }
  }
}

const std::string kNoBending = "bending: false";

// A neutrally buoyant pipe in a trench under waves, with free ends and a sudden lateral load of 0.6 of the
// soil's resistance. Closed form: it oscillates with its own mass on the springs of the soil, because buried
// lines have neither added mass nor wave forces; at Q the soil yields until the velocity changes sign. Also
// with a neutrally buoyant clump weight at every node.
void swing(const std::string& bending, double weight) {
  std::string masses;  // kg, m³
  for (int n = 0; n <= 60 && weight > 0; ++n) {
    const double kg = n % 60 == 0 ? weight / 2 : weight;
    masses += fmt::format("{{at: {}, mass: {}, volume: {:.17g}, drag_area: 1, Ca: 1}}, ", n, kg, kg / 1025);
  }
  const model::Case c = read(R"(hawser: 1
environment: {gravity: 10, water: {depth: 20}, waves: {regular: {height: 3, period: 8}}, seabed: {depth: 20}}
line_types: {pipe: {outer_diameter: 0.3, mass_per_length: 72.4529805734, EA: 5e8, )" +
                             bending + R"(}}
lines:
  pipe:
    sections: [{type: pipe, length: 60, elements: 60}]
    end_a: free
    end_b: free
    start: {points: [[0, 0, -21], [60, 0, -21]]}
    buried: [{resistance: {axial: 500, normal: 5000}, mobilisation_length: {axial: 5 mm, normal: 10 mm}}]
    loads: [{per_length: [0, 3000, 0], ramp: 1e-6}]
    masses: [)" + masses + R"(]
statics: false
dynamics: {duration: 0.25, step: 5e-4, rho_infinity: 1}
)");
  Simulation all(PETSC_COMM_WORLD, c);
  Simulation one(PETSC_COMM_SELF, c);
  const double m = 1025 * M_PI / 4 * 0.09 + weight;
  const double Q = 5000;
  const double k = Q / 0.01;
  const double q = 3000;
  const double w = std::sqrt(k / m);
  const double yields = std::acos(1 - Q / q) / w;
  const double speed = q / k * w * std::sin(w * yields);
  const double turns = yields + speed * m / (Q - q);
  const double most = Q / k + 0.5 * speed * speed * m / (Q - q);
  const double step = 5e-4;
  const bool beam = bending != kNoBending;
  const auto swings = [&](double t) {
    const double s = t - yields;
    return t < yields  ? q / k * (1 - std::cos(w * t))
           : t < turns ? Q / k + speed * s - 0.5 * (Q - q) / m * s * s
                       : most - (Q - q) / k * (1 - std::cos(w * (t - turns)));
  };
  double worst = 0, up = 0;
  one.dynamics().start(one.state());
  one.dynamics().run(
      0.25, [](double) { return 0.25; },
      [&](const StepInfo& info) {
        // The load rises within the first step, in the mean to half. The ends of a beam rotate, because its
        // load and inertia are distributed and the soil acts at nodes only.
        for (size_t n = beam ? 29 : 0; n <= (beam ? 31 : 60); ++n) {
          const Vec3& x = one.dynamics().committed_kinematics().x[n];
          worst = std::max(worst, std::abs(x.y() - swings(info.time - 0.5 * step)));
          up = std::max(up, std::abs(x.z() + 21));
        }
        return true;
      });
  const double taken = one.system().energy(one.dynamics().committed_kinematics()).friction;
  const double yielding = 60 * Q * (most - Q / k);  // J
  if (first_rank())
    printf(
        "  %s, %g kg a node: off its swing by %.1e of %.1e m, up and down %.1e m; yielding took %+.2f %%\n",
        bending.c_str(), weight, worst, most, up, 100 * (taken / yielding - 1));
  EXPECT_LT(worst, 2e-3 * most);
  EXPECT_LT(up, 1e-8);
  if (!beam) {
    EXPECT_NEAR(taken, yielding, 0.01 * yielding);
  }
  run(all, 0.25);
  expect_same_positions(all, all.dynamics().committed_kinematics(), one.dynamics().committed_kinematics(),
                        1e-9, "in the end");
}

TEST(Buried, SwingsWithoutWaterAndYields) {
  swing("EI: 1e4, GJ: 1e4", 0);
  swing(kNoBending, 0);
  swing(kNoBending, 50);
}

// A weightless chain lies straight in the soil, 30° up from its anchor. A horizontal pull at its upper end
// makes it cut through the soil everywhere: dT/ds = Q_a, T dtheta/ds = Q_n (Neubecker and Randolph 1995), in
// closed form theta = Q_n/Q_a ln(F/T) from the end.
TEST(Buried, ChainCutsThroughTheSoil) {
  const double F = 1e5, axial = 500, normal = 1000, length = 20;
  const model::Case c = read(R"(hawser: 1
environment: {gravity: 0, seabed: {depth: 10}}
line_types: {chain: {outer_diameter: 0.1, mass_per_length: 100, EA: 1e7, bending: false}}
lines:
  chain:
    sections: [{type: chain, length: 20, elements: 200}]
    end_a: {anchor: [0, 0, -20]}
    end_b: free
    start: {points: [[0, 0, -20], [17.32050808, 0, -10]]}
    buried: [{resistance: {axial: 500, normal: 1000}, mobilisation_length: {axial: 0.1 mm, normal: 0.1 mm}}]
    loads: [{at: end_b, force: [1e5, 0, 0]}]
)");
  Simulation all(PETSC_COMM_WORLD, c);
  Simulation one(PETSC_COMM_SELF, c);
  settle(all, one);
  const State& s = one.state();
  double most = 0;
  for (size_t n = 20; n < 200; ++n) {
    const Vec3 d = s.x[n + 1] - s.x[n];
    const double back = length - 0.1 * (static_cast<double>(n) + 0.5);
    const double angle = normal / axial * std::log(F / (F - axial * back));
    most = std::max(most, std::abs(std::atan2(d.z(), d.x()) - angle));
    const double tension = 1e7 * (d.norm() / 0.1 - 1);
    EXPECT_NEAR(tension, F - axial * back, 1e-3 * F) << n;
  }
  if (first_rank()) printf("  direction within %.2e of %.4f rad\n", most, 2 * std::log(1 / 0.9));
  EXPECT_LT(most, 1e-3);
}

// An anchor with its padeye 15 m below the bed and the automatic start shape: the buried part moves by less
// than 0.5 m, and the rest has the tensions of a line that starts at the exit point on the bed. Statics and 4
// s of motion are the same on all ranks.
TEST(Buried, AnchorBelowTheBed) {
  const std::string text = R"(hawser: 1
environment: {water: {depth: 200}, seabed: {depth: 200, friction: 0.6}}
line_types: {chain: {outer_diameter: 0.216, mass_per_length: 286, EA: 1.2e9, bending: false}}
bodies: {ship: {position: [760, 0, -14], motion: {harmonic: {amplitude: [1, 2, 2], period: 8}, ramp: 4}}}
lines:
  chain:
    sections: [{type: chain, length: 850, elements: 170}]
    end_a: {anchor: ANCHOR}
    end_b: {body: ship, at: [0, 0, 0]}
    BURIED
dynamics: {duration: 4, step: 0.1}
)";
  const auto with = [&](const std::string& at, const std::string& buried) {
    std::string t = text;
    t.replace(t.find("ANCHOR"), 6, at);
    t.replace(t.find("BURIED"), 6, buried);
    return read(t);
  };
  const model::Case c =
      with("[-20, 0, -215]", "buried: [{to: 25, resistance: {axial: 10 kN/m, normal: 60 kN/m}}]");
  Simulation all(PETSC_COMM_WORLD, c);
  Simulation one(PETSC_COMM_SELF, c);
  const std::vector<Vec3> laid = one.state().x;
  EXPECT_NEAR(laid[5].x(), 0, 1e-9);  // 25 m of arc length from the anchor, 15 m higher
  EXPECT_NEAR(laid[5].z(), -200, 1e-9);
  settle(all, one);
  for (size_t n = 1; n < 5; ++n) {
    const double away = (one.state().x[n] - laid[n]).norm();
    if (first_rank())
      printf("  node %zu, %.1f m deep: %.3f m from where it was laid\n", n, -200 - laid[n].z(), away);
    EXPECT_LT(away, 0.5);
  }
  // The same line from its exit point on.
  model::Case rest = with("[0, 0, -200]", "start: auto");
  rest.lines[0].sections[0].length = 825;
  rest.lines[0].sections[0].elements = 165;
  Simulation open(PETSC_COMM_SELF, rest);
  open.solve_statics();
  const auto pull = [](Simulation& s) {
    const auto& r = s.system().reactions();
    return Vec3(
        Eigen::Map<const Vec3>(r.data() + 3 * s.local().block[static_cast<size_t>(s.local().owned - 1)]));
  };
  const double T = pull(one).norm();
  const double T0 = pull(open).norm();
  if (first_rank()) printf("  fairlead %.1f kN, of the line from the bed on %.1f kN\n", T / 1e3, T0 / 1e3);
  EXPECT_NEAR(T, T0, 0.02 * T0);  // the exit point moves a little
  // The chain was laid from the anchor through the soil, so friction holds the part beyond the moving exit
  // point.
  const double here = tensions(one)[30];
  const double there = tensions(open)[25];
  if (first_rank())
    printf("  125 m on along the bed %.1f kN, of that line %.1f kN\n", here / 1e3, there / 1e3);
  EXPECT_NEAR(here, there, 0.02 * T0);
  run(all, 4);
  run(one, 4);
  expect_same_positions(all, all.dynamics().committed_kinematics(), one.dynamics().committed_kinematics(),
                        1e-7, "after 4 s");
  EXPECT_LT((one.dynamics().committed_kinematics().x[3] - laid[3]).norm(), 0.5);
}

}  // namespace
}  // namespace hawser::test::buried
