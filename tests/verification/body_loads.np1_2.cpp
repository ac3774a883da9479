// Forces on bodies by tables of time: displacement and work of a free body, and statics.
#include "../regression/runs.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::body_loads {
namespace {

using run::Simulation;

// A force table from 0 to F over T, on a free mass: x' = F t²/(2 m T), x = F t³/(6 m T); afterwards F is
// constant. The axes of the second load rotate with the body, which is rotated by 90 deg, so that this force
// is along y.
TEST(BodyLoads, ByTables) {
  const std::string text = R"(hawser: 1
bodies:
  float:
    rotation_deg: [0, 0, 90]
    floating:
      mass: 1000
      inertia: [400, 400, 400]
      loads:
        - table: {rows: [[0, 0, 0, 0], [4, 800, 0, 0]]}
        - {table: {rows: [[0, 0, 0, 0, 0, 0, 0], [4, 400, 0, 0, 0, 0, 0]]}, axes: body}
statics: false
dynamics: {duration: 6, step: 0.01, rho_infinity: 1}
)";
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "float.yaml"));
  Dynamics& d = s.dynamics();
  d.start(s.state());
  integrate(d, 6, 6, [](const StepInfo&) {});
  const double exact = 800 * 64.0 / (6 * 4000) + 800 * 16.0 / 8000 * 2 + 0.5 * 0.8 * 4, speed = 1.6 + 1.6;
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return d.committed_kinematics().x[n].x(); }), exact,
              1e-5 * exact);
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return d.committed_kinematics().x[n].y(); }), 0.5 * exact,
              1e-5 * exact);
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return d.committed_kinematics().v[n].x(); }), speed,
              1e-6 * speed);
  const double kinetic = 0.5 * 1000 * speed * speed * 1.25;
  const auto energy = [&](double Energy::*part) {
    return from_owner(s, [&](size_t) { return s.system().energy(d.committed_kinematics()).*part; });
  };
  EXPECT_NEAR(energy(&Energy::work), kinetic, 1e-4 * kinetic);
  EXPECT_NEAR(energy(&Energy::kinetic), kinetic, 1e-4 * kinetic);
  EXPECT_EQ(energy(&Energy::potential), 0);
}

// Statics uses the value of a table at t = 0.
TEST(BodyLoads, StaticsHasTheStartOfATable) {
  const std::string text = R"(hawser: 1
bodies:
  float:
    floating:
      mass: 1000
      inertia: [400, 400, 400]
      stiffness: [1e4, 1e4, 1e4]
      turning_stiffness: [1e5, 1e5, 1e5]
      loads: [{force: [100, 0, 0], table: {rows: [[-1, 200, 300, 0, 0, 0, 0], [1, 400, 300, 0, 0, 0, 50]]}}]
)";
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "float.yaml"));
  s.solve_statics();
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return s.state().x[n].x(); }), 0.04, 1e-9);
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return s.state().x[n].y(); }), 0.03, 1e-9);
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return log_so3(s.state().q[n]).z(); }), 25e-5, 1e-10);
}

// A body on springs: displacement F/k, along the body's axes if the force rotates with it. A moment adds no
// potential energy.
TEST(BodyLoads, StaticsOfMomentsAndTurningForces) {
  const std::string text = R"(hawser: 1
bodies:
  float:
    rotation_deg: [0, 0, 30]
    floating:
      mass: 1000
      inertia: [400, 400, 400]
      stiffness: [1e4, 1e4, 1e4]
      turning_stiffness: [1e5, 1e5, 1e5]
      loads: [{force: [100, 0, 0], axes: body}, {moment: [0, 0, 2000]}]
)";
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "float.yaml"));
  s.solve_statics();
  const double angle = M_PI / 6 + 0.02;
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return s.state().x[n].x(); }), 0.01 * std::cos(angle), 1e-9);
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return s.state().x[n].y(); }), 0.01 * std::sin(angle), 1e-9);
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return log_so3(s.state().q[n]).z(); }), angle, 1e-9);
  EXPECT_NEAR(from_owner(s, [&](size_t) { return s.system().energy(s.state().at_rest()).potential; }), 0,
              1e-9);
}

}  // namespace
}  // namespace hawser::test::body_loads
