// Mooring lines on a seabed from the automatic start shape, against MAP++, MoorPy and closed forms of the
// elastic catenary with bed friction.
#include "hawser/terms/bed_contact.hpp"
#include "support/rig.hpp"

namespace hawser::test::mooring_statics_test {
namespace {

struct Part {
  double weight, length, EA;  // N/m under water, m, N
  int elements;
};

// A line of cables from an anchor on a bed at 1000 m to a fairlead at (x, 0, z) from it. The mass is that of
// the submerged weight. The bed is nearly rigid, and its friction is mobilised over a slip that is short
// beside the stretch of the line on the bed.
model::Case mooring(const std::vector<Part>& parts, double x, double z, double friction, double slip) {
  model::Case c;
  c.environment.water.present = true;
  c.environment.water.depth = 1000;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true;
  bed.depth = 1000;
  bed.basis = model::StiffnessBasis::per_length;
  bed.normal_stiffness = 1e6;
  bed.friction.axial = bed.friction.lateral = friction;
  bed.friction.mobilisation_length = slip * x;
  model::Line l;
  l.name = "mooring";
  for (const Part& p : parts) {
    model::LineType t = cable_type(p.EA, 0);
    t.name += std::to_string(c.line_types.size());
    t.outer_diameter = 0.1;
    t.contact_diameter = 1e-3;
    t.mass_per_length = p.weight / c.environment.gravity + 1025 * M_PI / 4 * 0.01;
    c.line_types.push_back(t);
    l.sections.push_back({t.name, p.length, p.elements, 1});
  }
  // The anchor is at the height where the line rests on the bed, so the bed is not lowered for it.
  bed.smoothing = 0.01 * parts[0].weight / bed.normal_stiffness;
  const double level = -1000 + 0.5e-3 - parts[0].weight / bed.normal_stiffness - 0.5 * *bed.smoothing;
  l.end_a = anchor({7, -4, level});
  l.end_b = anchor(Vec3(7 + 0.8 * x, -4 - 0.6 * x, z + level));
  c.lines.push_back(l);
  c.dynamics.enabled = false;
  return c;
}

struct Reference {
  const char* name;
  std::vector<Part> parts;
  double x, z, friction;
  double H, V, grounded, H_anchor;  // N, N, m, N
  double tolerance;
  int iterations = 40;
  double slip = 1e-8;       // slip that mobilises friction, over x
  double mobilisation = 0;  // m: with full friction; 0: friction as laid, with `slip`
  double at_anchor = 0;     // tolerance at the anchor, where it differs
};

// Grounded length: up to the last node on the bed, plus that node's share of carried weight.
double grounded_length(Simulation& sim, const Reference& r) {
  const Mesh& mesh = sim.mesh();
  const auto nodes = static_cast<size_t>(mesh.nodes());
  double at = 0, part = 0;
  const double w = r.parts[0].weight;
  for (std::size_t n = 1; n + 1 < nodes; ++n) {
    const double N = sim.system().find<BedContact>()->node_force(static_cast<int>(n)).z();
    if (N <= 0) continue;
    at = 0.5 * (mesh.node(n - 1).arc + mesh.node(n).arc);
    part = N / w;
  }
  return at + part;
}

void expect(const Reference& r) {
  model::Case c = mooring(r.parts, r.x, r.z, r.friction, r.slip);
  if (r.mobilisation > 0) {
    c.environment.seabed.full = true;
    c.environment.seabed.friction.mobilisation_length = r.mobilisation;
  }
  Simulation sim(PETSC_COMM_SELF, c);
  const StaticsReport report = sim.solve_statics();
  const auto& reactions = sim.system().reactions();
  const auto pull = [&](int node) {
    return Vec3(Eigen::Map<const Vec3>(reactions.data() + 3 * sim.local().block[static_cast<size_t>(node)]));
  };
  const int last = sim.local().owned - 1;
  const double H = pull(last).head<2>().norm();
  const double V = pull(last).z();
  const double T = std::hypot(H, V);
  const double A = pull(0).head<2>().norm();
  const double grounded = grounded_length(sim, r);
  const double true_T = std::hypot(r.H, r.V);
  // The tolerance of the anchor tension is relative to itself. It is relative to the fairlead tension where
  // friction has reduced the anchor tension to zero, and for full friction, where the anchor tension is a
  // small difference.
  const double anchor = r.H_anchor > 0 && !(r.mobilisation > 0) ? r.H_anchor : true_T;
  printf("  %-22s %2d iterations, T %+.4f %%, H %+.4f %%, V %+.4f %%, anchor %+.4f %%, grounded %+.2f m\n",
         r.name, report.iterations, 100 * (T / true_T - 1), 100 * (H / r.H - 1), 100 * (V / r.V - 1),
         100 * (A - r.H_anchor) / anchor, grounded - r.grounded);
  EXPECT_NEAR(T, true_T, r.tolerance * true_T) << r.name;
  EXPECT_NEAR(H, r.H, r.tolerance * r.H) << r.name;
  EXPECT_NEAR(V, r.V, r.tolerance * r.V) << r.name;
  EXPECT_NEAR(A, r.H_anchor, std::max(r.tolerance, r.at_anchor) * anchor) << r.name;
  EXPECT_NEAR(grounded, r.grounded, 1) << r.name;
  EXPECT_LT(report.iterations, r.iterations) << r.name;
  if (r.friction == 0) {
    EXPECT_LE(report.negative_eigenvalues, 0) << r.name;
  }
}

// A held node carries half of its element without friction. Where friction acts up to the anchor, elements
// are graded: ten of each length, from `first` on, each length ten times the last.
std::vector<Part> fine_at_anchor(const Part& line, double first) {
  std::vector<Part> out;
  double length = 0;
  for (double h = first; 10 * h < line.length / line.elements * 10; h *= 10) {
    out.push_back({line.weight, 10 * h, line.EA, 10});
    length += 10 * h;
  }
  out.push_back({line.weight, line.length - length, line.EA, line.elements});
  return out;
}

const double kOC4 = (113.35 - 1025 * M_PI / 4 * 0.0766 * 0.0766) * 9.80665;
const double kVolturn = (685 - 1025 * M_PI / 4 * 0.333 * 0.333) * 9.80665;

// OC3-Hywind: MAP++ 1.20.10 in OpenFAST/r-test, and radially moved fairleads.
TEST(MooringStatics, Oc3Hywind) {
  const std::vector<Part> line = {{698.0945369, 902.2, 384243000, 180}};
  expect({"OC3", line, 848.67, 250, 0.001, 736939.2901, 535727.9918, 134.7853255, 736845.1972, 1e-3});
  expect(
      {"OC3 without friction", line, 848.67, 250, 0, 736938.3235, 535727.4506, 134.7855, 736938.3235, 1e-3});
  expect({"OC3 20 m slacker", line, 828.67, 250, 0, 384523.85, 405507.2758, 321.3222446, 384523.85, 1e-3});
  expect({"OC3 10 m tighter", line, 858.67, 250, 0, 1080509.312, 637454.2196, 0, 1080509.312, 1e-3});
  expect({"OC3 20 m tighter", line, 868.67, 250, 0, 1998177.459, 894314.1133, 0, 1998177.459, 1e-3});
}

// OC4-DeepCwind (full friction) and VolturnUS-S, decks of OpenFAST and of the IEA 15 MW turbine, in closed
// form.
TEST(MooringStatics, Semisubmersibles) {
  const double x = std::hypot(418.8 - 20.434, 725.383 - 35.393);
  expect({"OC4", fine_at_anchor({kOC4, 835.35, 753600000, 160}, 0.1), x, 186, 1, 909408.4262, 631704.299,
          242.3459, 651246.7145, 1e-3});
  // The same line with the data of its report, 835.5 m and 108.63 kg/m under water.
  expect({"OC4, report", fine_at_anchor({108.63 * 9.80665, 835.5, 753600000, 160}, 0.1), x, 186, 1,
          902571.5347, 629573.6131, 244.5155385, 642090.0144, 1e-3});
  const std::vector<Part> line = {{kVolturn, 850, 3270000000, 170}};
  expect({"VolturnUS-S", line, 779.6, 186, 0, 1349553.498, 2027475.384, 502.955676, 1349553.498, 2e-3});
  expect({"VolturnUS-S, rough", line, 779.6, 186, 1, 1356980.752, 2031446.892, 502.2758703, 0, 2e-3, 150});
  expect({"VolturnUS-S, MAP deck", line, 779.8, 186, 1, 1366340.286, 2036440.576, 501.421098, 0, 2e-3, 150});
}

// Baseline of MAP++'s tests, nearly vertical, and MoorPy's test_catenary (almost inextensible).
TEST(MooringStatics, UnitTestsOfMapAndMoorPy) {
  // Friction leaves 0.67 kN of 17.4 kN at the anchor. A slip of nanometres mobilises it, the tolerance of
  // Newton's positions: the error is 0.5 % of the anchor tension.
  expect({"MAP++ base", fine_at_anchor({1327.647744, 125, 545000000, 800}, 5e-4), 50, 100, 1, 17449.66817,
          149176.9239, 12.63817471, 670.6240176, 1e-3, 40, 1e-10, 0, 5e-3});
  const std::vector<Part> line = fine_at_anchor({800, 500, 7.51e12, 200}, 0.05);
  expect(
      {"MoorPy, no friction", line, 400, 200, 0, 96643.45355, 237751.768, 202.81029, 96643.45355, 1e-3, 250});
  expect({"MoorPy, friction 0.1", line, 400, 200, 0.1, 96643.45416, 237751.7684, 202.8102894, 80418.631, 1e-3,
          40, 1e-11, 0, 5e-3});
  expect({"MoorPy, friction 5", line, 400, 200, 5, 96643.4604, 237751.7726, 202.8102842, 0, 1e-3, 100, 1e-9});
  // Full friction does not depend on the mobilisation length, although this is a million times the stretch.
  const std::vector<Part> map = fine_at_anchor({1327.647744, 125, 545000000, 800}, 5e-4);
  for (const double length : {1e-6, 1e-3, 0.1}) {
    printf("  mobilisation length %g m\n", length);
    expect({"MAP++ base", map, 50, 100, 1, 17449.66817, 149176.9239, 12.63817471, 670.6240176, 1e-3, 250, 0,
            length});
    expect({"MoorPy, C_B 0.1", line, 400, 200, 0.1, 96643.45416, 237751.7684, 202.8102894, 80418.631, 1e-3,
            250, 0, length});
    expect(
        {"MoorPy, C_B 5", line, 400, 200, 5, 96643.4604, 237751.7726, 202.8102842, 0, 1e-3, 250, 0, length});
  }
}

// Chain, chain and polyester: lines of Lozon et al. 2025, by closed form.
TEST(MooringStatics, SeveralSections) {
  expect({"Gulf of Mexico",
          {{4366.188626, 364.5, 2191000000, 100}},
          342,
          66,
          0,
          462368.9186,
          591102.0563,
          229.118296,
          462368.9186,
          3e-3});
  expect({"Gulf of Maine",
          {{4101.341951, 497.7, 2058000000, 100}, {56.61546721, 199.8, 142000000, 40}},
          642,
          186,
          0,
          944887.4574,
          746990.9908,
          318.3247542,
          944887.4574,
          3e-3});
  expect({"Humboldt",
          {{2455.981102, 80, 1232000000, 10},
           {59.5673446, 1378.9, 145000000, 60},
           {2455.981102, 80, 1232000000, 10}},
          1342,
          786,
          0,
          1509877.596,
          1122681.864,
          0,
          1509877.596,
          3e-3});
}

}  // namespace
}  // namespace hawser::test::mooring_statics_test
