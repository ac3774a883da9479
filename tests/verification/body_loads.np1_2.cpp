// Forces on bodies by tables of time: displacement and work of a free body, statics and its stability.
#include <fmt/format.h>

#include <algorithm>

#include "../regression/runs.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/solve/natural_modes.hpp"
#include "verification/platform_rig.hpp"

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

// A moment M about a fixed axis heels a barge. Pitch and yaw about it have the stiffness [[C, M], [0, k]], so
// that only the sign of the yaw stiffness k decides on stability. The symmetric part would be positive
// for k > M²/(4 C) = 2.5e4 N m/rad only. Modes are judged likewise. Slack chains, on one rank or two, change
// none of this.
TEST(BodyLoads, MomentAboutAFixedAxisIsStable) {
  if (ranks_of(MPI_COMM_WORLD) > 1 && !std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  struct Found {
    StaticsReport report;
    std::vector<NaturalMode> modes;
  };
  const auto found = [&](double k, bool chains) {
    std::string text =
        platform_rig::barge("hawser_body_loads/barge", 1e3, k) + "      loads: [{moment: [1e6, 0, 0]}]\n";
    if (chains)
      text += R"(
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 100, EA: 1e8, bending: false}
lines:
  port: {sections: [{type: chain, length: 130, elements: 20}], end_a: {anchor: [-80, 0, -99]}, end_b: {body: barge, at: [-0.1, 0, 0]}}
  starboard: {sections: [{type: chain, length: 130, elements: 20}], end_a: {anchor: [80, 0, -99]}, end_b: {body: barge, at: [0.1, 0, 0]}}
)";
    Simulation sim(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "barge.yaml"));
    Found out;
    out.report = sim.solve_statics();
    out.modes = natural_modes(sim.system(), sim.state().at_rest(), 6);
    return out;
  };
  for (const bool chains : {false, true}) {
    for (const double k : {4e4, 1e4, 1e3}) {
      const auto [report, modes] = found(k, chains);
      EXPECT_EQ(report.negative_eigenvalues, 0) << k;
      EXPECT_EQ(report.escapes, 0) << k;
      EXPECT_GT(modes[0].squared, 0) << k;
      if (chains) continue;
      // Yaw and pitch. At a heel of 0.1 rad omega² differ by 0.33 % and -0.33 % from k/I and C/I.
      std::vector<double> yaw, pitch;
      for (const NaturalMode& mode : modes) {
        yaw.push_back(std::abs(mode.squared / (k / 1e7) - 1));
        pitch.push_back(std::abs(mode.squared - 0.99667));
      }
      EXPECT_LT(std::ranges::min(yaw), 5e-3) << k;
      EXPECT_LT(std::ranges::min(pitch), 1e-4) << k;
    }
    const auto [report, modes] = found(-1e5, chains);
    EXPECT_EQ(report.negative_eigenvalues, 1);
    EXPECT_EQ(report.escapes, 0);
    EXPECT_LT(modes[0].squared, -kFreeMotion);
  }
}

}  // namespace
}  // namespace hawser::test::body_loads
