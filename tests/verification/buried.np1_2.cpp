// Lines in the soil, from case files: a pipe in a trench, an anchor below the bed, the shape that a chain
// cuts.
#include <cmath>

#include "hawser/io/case_reader.hpp"
#include "support/mooring.hpp"

namespace hawser::test {
namespace {

bool first_rank() {
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  return rank == 0;
}

model::Case read(const std::string& text) {
  return io::read_case_text(text, HAWSER_SOURCE_DIR "/tests/buried.yaml");
}

// At rest on one rank and on all, the same.
void settle(Simulation& all, Simulation& one) {
  all.solve_statics(), one.solve_statics();
  expect_same_positions(all, all.state().view(0), one.state().view(0), 1e-7, "statics");
}

// 1.2 km of pipe a metre deep, pulled at one end: it stays as deep, and 500 N/m after 5 mm hold it along as
// they hold a pipe on the bed. Closed form.
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
    Simulation all(PETSC_COMM_WORLD, c), one(PETSC_COMM_SELF, c);
    settle(all, one);
    const State& s = one.state();
    const double u = s.x[1200].x() - 1200;
    std::vector<double> tension(s.x.size());
    const FieldRegistry fields = one.system().fields();
    for (const FieldSource& f : fields.sources())
      if (f.name == "effective_tension") f.fill(s.view(0), tension);
    if (first_rank())
      printf("  F %s N: u %+.3f %%, tension %+.3f %%\n", r.force, 100 * (u / r.u - 1),
             100 * (tension[1150] / r.tension - 1));
    EXPECT_NEAR(u, r.u, 5e-3 * r.u);
    EXPECT_NEAR(tension[1150], r.tension, 5e-3 * r.tension);
    // What it weighs in water, over 5000 N/m after a tenth of the diameter; no drag.
    const double down = (1000 - 1025 * 10 * M_PI / 4 * 0.01) * 0.01 / 5000;
    for (size_t n = 100; n <= 1100; ++n) {
      EXPECT_NEAR(s.x[n].z(), -51 - down, 1e-5);
      EXPECT_NEAR(s.x[n].y(), 0, 1e-9);
    }
  }
}

// A weightless chain straight in the soil, 30° up from its anchor, pulled level at its upper end until it
// cuts through the soil everywhere: dT/ds = Q_a, T dtheta/ds = Q_n (Neubecker and Randolph 1995), in closed
// form theta = Q_n/Q_a ln(F/T) from the end on.
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
  Simulation all(PETSC_COMM_WORLD, c), one(PETSC_COMM_SELF, c);
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

// The usual anchor with its padeye 15 m below the bed: the line starts by itself, the soil keeps what is in
// it, and the rest is the line that begins where it comes out. At rest and after 4 s of motion.
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
    t.replace(t.find("ANCHOR"), 6, at), t.replace(t.find("BURIED"), 6, buried);
    return read(t);
  };
  const model::Case c =
      with("[-20, 0, -215]", "buried: [{to: 25, resistance: {axial: 10 kN/m, normal: 60 kN/m}}]");
  Simulation all(PETSC_COMM_WORLD, c), one(PETSC_COMM_SELF, c);
  const std::vector<Vec3> laid = one.state().x;
  EXPECT_NEAR(laid[5].x(), 0, 1e-9);  // 25 m on, 15 m up
  EXPECT_NEAR(laid[5].z(), -200, 1e-9);
  settle(all, one);
  for (size_t n = 1; n < 5; ++n) {
    const double away = (one.state().x[n] - laid[n]).norm();
    if (first_rank())
      printf("  node %zu, %.1f m deep: %.3f m from where it was laid\n", n, -200 - laid[n].z(), away);
    EXPECT_LT(away, 0.5);
  }
  // The same line from the place where it comes out.
  model::Case rest = with("[0, 0, -200]", "start: auto");
  rest.lines[0].sections[0].length = 825, rest.lines[0].sections[0].elements = 165;
  Simulation open(PETSC_COMM_SELF, rest);
  open.solve_statics();
  const auto pull = [](Simulation& s) {
    const auto& r = s.system().reactions();
    return Vec3(
        Eigen::Map<const Vec3>(r.data() + 3 * s.local().block[static_cast<size_t>(s.local().owned - 1)]));
  };
  const double T = pull(one).norm(), T0 = pull(open).norm();
  if (first_rank()) printf("  fairlead %.1f kN, of the line from the bed on %.1f kN\n", T / 1e3, T0 / 1e3);
  EXPECT_NEAR(T, T0, 0.02 * T0);  // where it comes out gives way a little
  run(all, 4), run(one, 4);
  expect_same_positions(all, all.dynamics().kinematics(), one.dynamics().kinematics(), 1e-7, "after 4 s");
  EXPECT_LT((one.dynamics().kinematics().x[3] - laid[3]).norm(), 0.5);
}

}  // namespace
}  // namespace hawser::test
