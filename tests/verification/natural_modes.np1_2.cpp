// Modes by shift and invert against closed forms; the displacements of ends tied to a body that moves.
#include "hawser/solve/natural_modes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/symmetric.hpp"
#include "support/rig.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::natural_modes_test {
namespace {

constexpr double kG = 9.81;

// Mode shape at a node, from its owner, on all ranks.
Vec3 shape_at(Simulation& s, const NaturalMode& mode, int node) {
  const int n = s.local().find(node);
  Vec3 x = n >= 0 && n < s.local().owned ? mode.shape[static_cast<size_t>(n)] : Vec3(Vec3::Zero());
  MPI_Allreduce(MPI_IN_PLACE, x.data(), 3, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}

// Zeros of J0: omega_n = j_n/2 sqrt(g/L), in two directions each.
TEST(NaturalModes, HangingChain) {
  const std::vector<double> exact{1.1909350769091904, 2.733692939922684, 4.285561621936849};
  model::Case c = one_line(cable_type(1e8, 1), 10, 200, anchor(Vec3::Zero()), {});
  c.environment.gravity = kG;
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  const auto modes = hawser::natural_modes(s.system(), s.state().at_rest(), 6);
  ASSERT_EQ(modes.size(), 6U);
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(std::sqrt(modes[i].squared), exact[i / 2], 5e-4 * exact[i / 2]) << i;
    // The displacement is largest at the free end.
    EXPECT_NEAR(shape_at(s, modes[i], 200).norm(), 1, 1e-9) << i;
    EXPECT_NEAR(shape_at(s, modes[i], 0).norm(), 0, 1e-12) << i;
  }
}

// Four equal chains have every natural frequency eight times. All are found, for any number of requested
// modes.
TEST(NaturalModes, OfEqualLinesAreAllThere) {
  const std::vector<double> exact{1.1909350769091904, 2.733692939922684, 4.285561621936849};
  model::Case c = one_line(cable_type(1e8, 1), 10, 60, anchor(Vec3::Zero()), {});
  c.environment.gravity = kG;
  for (const int i : {1, 2, 3}) {
    c.lines.push_back(c.lines[0]);
    c.lines.back().name += std::to_string(i);
    c.lines.back().end_a = anchor(Vec3(20 * i, 0, 0));
  }
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  for (const int count : {4, 7, 10, 16, 18}) {
    const auto modes = hawser::natural_modes(s.system(), s.state().at_rest(), count);
    ASSERT_EQ(modes.size(), static_cast<size_t>(count));
    for (size_t i = 0; i < modes.size(); ++i)
      EXPECT_NEAR(std::sqrt(modes[i].squared), exact[i / 8], 5e-3 * exact[i / 8]) << i << " of " << count;
  }
}

// Heave of a spar that is one vertical line through the surface: omega² = rho g A/m in closed form, for any
// position of the surface within an element.
TEST(NaturalModes, HeaveOfASparDoesNotGoByItsElements) {
  const double area = M_PI / 4 * 8 * 8;
  const double exact = std::sqrt(1025 * kG * area / (2.952e6 + 20000 * 110));
  for (const int elements : {37, 55, 110}) {
    const model::Case c = io::read_case_text(fmt::format(R"(hawser: 1
environment: {{water: {{depth: 320, density: 1025}}}}
line_types:
  hull: {{outer_diameter: 8, mass_per_length: 20000, EA: 1.0e11, EI: 1.0e13, GJ: 1.0e13, Cd_normal: 0.6, Ca_normal: 1.0}}
  rope: {{outer_diameter: 0.02, mass_per_length: 0.33, EA: 1.0e6, bending: false}}
joints: {{keel: {{start: [0, 0, -100]}}}}
lines:
  spar:
    sections: [{{type: hull, length: 110, elements: {}}}]
    end_a: {{joint: keel}}
    end_b: free
    start: {{points: [[0, 0, -100], [0, 0, 10]]}}
    masses: [{{at: end_a, mass: 2.952e6}}]
  r1: {{sections: [{{type: rope, length: 480, elements: 10}}], end_a: {{joint: keel}}, end_b: {{anchor: [500, 0, -100]}}}}
  r2: {{sections: [{{type: rope, length: 480, elements: 10}}], end_a: {{joint: keel}}, end_b: {{anchor: [-500, 0, -100]}}}}
  r3: {{sections: [{{type: rope, length: 480, elements: 10}}], end_a: {{joint: keel}}, end_b: {{anchor: [0, 500, -100]}}}}
  r4: {{sections: [{{type: rope, length: 480, elements: 10}}], end_a: {{joint: keel}}, end_b: {{anchor: [0, -500, -100]}}}}
contact: {{between_lines: false}}
)",
                                                         elements),
                                             "/nowhere/case.yaml");
    Simulation s(PETSC_COMM_WORLD, c);
    s.solve_statics();
    double nearest = HUGE_VAL;
    for (const auto& mode : hawser::natural_modes(s.system(), s.state().at_rest(), 5))
      nearest = std::min(nearest, std::abs(std::sqrt(std::max(mode.squared, 0.0)) / exact - 1));
    EXPECT_LT(nearest, 1e-3) << elements;
  }
}

// A load on one sling is a double pendulum in both planes: M = [m L², m L a; m L a, I + m a²], K = [m g L, m
// g a]. Its rotation about the sling has no stiffness.
TEST(NaturalModes, LoadOnASling) {
  const double m = 2000, L = 5, a = 1;
  const Vec3 inertia(3000, 4000, 5000);
  model::Case c;
  c.environment.gravity = kG;
  c.line_types = {cable_type(1e6 * m * kG, 1e-7 * m)};
  model::Body& b = c.bodies.emplace_back();
  b.name = "load";
  b.position = {0, 0, -L - a};
  b.mass.emplace();
  b.mass->mass = m;
  b.mass->inertia = inertia;
  b.mass->weight = true;
  model::End eye;
  eye.kind = model::EndKind::body;
  eye.carrier = "load";
  eye.at = {0, 0, a};
  model::Line line;
  line.name = "sling";
  line.sections.push_back({"cable", L, 2, 1});
  line.end_a = anchor(Vec3::Zero());
  line.end_b = eye;
  c.lines.push_back(line);
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  const auto modes = hawser::natural_modes(s.system(), s.state().at_rest(), 5);
  ASSERT_EQ(modes.size(), 5U);
  // The first mode is the free rotation of the load in place.
  EXPECT_LT(std::abs(modes[0].squared), kFreeMotion);
  EXPECT_EQ(shape_at(s, modes[0], s.mesh().body_node(0)).norm(), 0);
  const int load = s.local().find(s.mesh().body_node(0));
  if (load >= 0 && load < s.local().owned) {
    EXPECT_NEAR((modes[0].rotation[static_cast<size_t>(load)].cwiseAbs() - Vec3::UnitZ()).norm(), 0, 1e-6);
  }
  // There are nine modes: three components of the sling's inner node and six of the load.
  EXPECT_EQ(hawser::natural_modes(s.system(), s.state().at_rest(), 1000).size(), 9U);
  struct Exact {
    double squared, eye;  // displacement of the eye for 1 of the load's centre
    int axis;
  };
  std::vector<Exact> exact;
  for (int axis = 0; axis < 2; ++axis) {
    Eigen::Matrix2d M;
    M << m * L * L, m * L * a, m * L * a, inertia[1 - axis] + m * a * a;
    // With v = S u, S² the inverse of the diagonal stiffness: S M S u = u / squared.
    const Eigen::Vector2d S = Eigen::Vector2d(m * kG * L, m * kG * a).cwiseSqrt().cwiseInverse();
    const Eigenpairs pairs = eigenpairs(S.asDiagonal() * M * S.asDiagonal());
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d v = S.cwiseProduct(pairs.vectors.col(k));
      exact.push_back({1 / pairs.values[k], L * v[0] / (L * v[0] + a * v[1]), axis});
    }
  }
  std::sort(exact.begin(), exact.end(), [](const Exact& p, const Exact& q) { return p.squared < q.squared; });
  for (size_t i = 0; i < 4; ++i) {
    const NaturalMode& mode = modes[i + 1];
    EXPECT_NEAR(mode.squared, exact[i].squared, 1e-4 * exact[i].squared) << i;
    const double end = shape_at(s, mode, 2)[exact[i].axis];
    const double centre = shape_at(s, mode, s.mesh().body_node(0))[exact[i].axis];
    EXPECT_NEAR(end, exact[i].eye * centre, 1e-3) << i;
    EXPECT_GT(std::max(std::abs(end), std::abs(centre)), 0.999) << i;
  }
}

}  // namespace
}  // namespace hawser::test::natural_modes_test
