// Statics of floating bodies that are unstable where the search begins: the heel of a box with a negative
// metacentric height; stable and indifferent bodies, and motions that nothing stops. On one and two ranks.
#include <fmt/format.h>

#include "../regression/runs.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/volumes.hpp"
#include "verification/dynamics_rig.hpp"
#include "verification/platform_rig.hpp"

namespace hawser::test::body_stability {
namespace {

// Soft chains to the ends of the box.
constexpr char kChains[] = R"(
line_types: {chain: {outer_diameter: 0.1, mass_per_length: 20, EA: 1e8, bending: false}}
contact: {between_lines: false}
lines:
  aft: {sections: [{type: chain, length: 140, elements: 20}], end_a: {anchor: [-100, 0, -99]}, end_b: {body: box, at: [-20, 0, 0]}}
  fore: {sections: [{type: chain, length: 140, elements: 20}], end_a: {anchor: [100, 0, -99]}, end_b: {body: box, at: [20, 0, 0]}}
)";

struct Rest {
  StaticsReport report;
  Vec3 turn = Vec3::Zero();  // rad
};

// A box of 20 x 8 m and the given length with a draught of 4 m, its centre of mass at the given height above
// the water. BM = 25/3 m, GM = 19/3 m - height, for heel and for the trim of a box of 20 m.
Rest rest(double height, const std::string& more = "", const std::string& start = "", const char* lines = "",
          double length = 40) {
  model::Case c = io::read_case_text(fmt::format(R"(hawser: 1
environment: {{gravity: 9.81, water: {{density: 1000, depth: 100}}}}
bodies: {{box: {{{} floating: {{mass: {}, centre_of_mass: [0, 0, {}], inertia: [1.5e8, {}, {}], hull: {{volumes: [hull]}} {}}}}}}}
volumes: {{hull: {{shape: {{box: {{centre: [0, 0, 0], size: [{}, 20, 8]}}}}, body: box}}}}
{})",
                                                 start, 8e4 * length, height, length > 20 ? 4.5e8 : 1.5e8,
                                                 length > 20 ? 5e8 : 2e8, more, length, lines),
                                     testing::TempDir() + "box.yaml");
  const auto volumes = run::load_volumes(c, PETSC_COMM_WORLD);
  run::set_hydrostatics(c, volumes);
  Simulation s(PETSC_COMM_WORLD, c, run::surfaces(volumes), run::skeletons(c, volumes),
               run::volume_facets(volumes));
  Rest out;
  out.report = s.solve_statics();
  const int node = s.mesh().body_node(0);
  const int n = s.local().find(node);
  if (s.local().owns(n)) out.turn = log_so3(s.state().q[n]);
  all_reduce(PETSC_COMM_WORLD, MPI_SUM, out.turn);
  return out;
}

void expect_turn(const Rest& found, Vec3 turn, int escapes, double tolerance = 1e-7) {
  EXPECT_LT((found.turn - turn).norm(), tolerance) << found.turn.transpose();
  EXPECT_EQ(found.report.negative_eigenvalues, 0);
  EXPECT_EQ(found.report.escapes, escapes);
}

// A wall-sided hull with GM < 0 has its equilibrium at the heel with tan² = -2 GM/BM: 11.31 deg.
TEST(BodyStability, UnstableUprightBoxHeels) {
  const Vec3 heel(std::atan(0.2), 0, 0);
  expect_turn(rest(6.5), heel, 1);
  expect_turn(rest(6.5, ", stiffness: [1e4, 1e4, 0], turning_stiffness: [0, 0, 1e8]"), heel, 1);
  expect_turn(rest(6.5, "", "", kChains), heel, 1, 1e-5);  // rad, moment of the chains
  // All directions are equally unstable, and the first one is taken.
  expect_turn(rest(6.5, "", "", "", 20), heel, 1);
  // Towards the side of the start, also from the unstable equilibrium beyond the stable one, which the search
  // finds first, 1.6 deg from the edge of the deck in the water.
  const double GM = 19.0 / 3 - 6.9;
  const Vec3 more(std::atan(std::sqrt(-6 * GM / 25)), 0, 0);
  expect_turn(rest(6.9), more, 2);
  expect_turn(rest(6.9, "", "rotation_deg: [0.01, 0, 0],"), more, 2);
  expect_turn(rest(6.9, "", "rotation_deg: [-0.01, 0, 0],"), -more, 2);
}

// Moments about fixed axes have no potential: heel with weight (GM + BM/2 tan²) sin = moment.
TEST(BodyStability, UnstableBoxHeelsToTheSideOfAMoment) {
  for (const double moment : {1e5, -1e5}) {
    const Rest found = rest(6.5, fmt::format(", loads: [{{moment: [{}, 0, 0]}}]", moment));
    const double heel = found.turn.x();
    const double t = std::tan(heel);
    EXPECT_NEAR((-1.0 / 6 + 25.0 / 6 * t * t) * std::sin(heel), moment / (3.2e6 * 9.81), 1e-8);
    EXPECT_GT(heel * moment, 0);
    EXPECT_EQ(found.report.negative_eigenvalues, 0);
  }
}

// A stable body that is free to move and yaw is not pushed.
TEST(BodyStability, StableBoxStays) {
  EXPECT_EQ(rest(6).report.iterations, 0);
  expect_turn(rest(6), Vec3::Zero(), 0, 1e-12);
  expect_turn(rest(6, "", "", kChains), Vec3::Zero(), 0, 1e-7);
}

// Surge with a negative stiffness has no other equilibrium: the present one is kept and reported as unstable.
TEST(BodyStability, MotionThatNothingStopsIsReported) {
  const std::string text =
      platform_rig::barge("hawser_body_stability/barge", -1e3, 1e5) + "statics: {max_iterations: 50}\n";
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "barge.yaml"));
  const StaticsReport report = s.solve_statics();
  EXPECT_EQ(report.negative_eigenvalues, 1);
  EXPECT_EQ(report.escapes, 0);
  EXPECT_GT(report.iterations, 50);
  const int n = s.local().find(s.mesh().body_node(0));
  const double far = s.local().owns(n) ? s.state().x[n].norm() : 0;
  EXPECT_LT(far, 1e-9);
}

}  // namespace
}  // namespace hawser::test::body_stability
