// Platforms at other headings and positions, their forces by component, and a restart.
#include <fmt/format.h>

#include <complex>
#include <filesystem>
#include <fstream>

#include "hawser/io/case_reader.hpp"
#include "hawser/kernels/platform_frame.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "verification/platform_rig.hpp"

namespace hawser::test::platform_motions {
namespace {

using platform_rig::coefficients;
using platform_rig::motion;
using run::Simulation;

// Wind and current coefficients of a ship.
constexpr const char* kWind =
    "[[0, 0.8, 0, 0], [60, 0.4, 0.6, 0.1], [120, -0.4, 0.6, -0.1], [180, -0.8, 0, 0]]";
constexpr const char* kCurrent =
    "[[0, 0.08, 0, 0], [60, 0.04, 0.6, 0.1], [120, -0.04, 0.6, -0.1], [180, -0.08, 0, 0]]";

// Coefficients of a ship by formulas: wave forces and mean drift for directions every 30 deg.
std::string ship_files(const std::string& name) {
  const std::string stem = testing::TempDir() + name;
  if (rank_of(PETSC_COMM_WORLD) == 0) {
    std::filesystem::create_directories(std::filesystem::path(stem).parent_path());
    std::ofstream radiation(stem + ".1");
    std::ofstream waves(stem + ".3");
    std::ofstream drift(stem + ".8");
    std::ofstream(stem + ".hst") << "3 3 200\n4 4 900\n5 5 20000\n";
    const double added[] = {80, 500, 900, 2e3, 9e4, 6e4};
    for (int k = 0; k < 6; ++k) {
      radiation << fmt::format("0 {0} {0} {1}\n", k + 1, added[k]);
      for (int i = 1; i <= 12; ++i)
        radiation << fmt::format("{:.17g} {} {} {} {:.17g}\n", 2 * M_PI / (0.2 * i), k + 1, k + 1, added[k],
                                 0.3 * added[k] * std::exp(-std::pow(0.2 * i - 1, 2) * 4) * 0.2 * i);
    }
    for (int i = 3; i <= 12; ++i)
      for (int b = 0; b < 12; ++b) {
        const double T = 2 * M_PI / (0.2 * i);
        const double beta = 30 * b * M_PI / 180;
        const double c = std::cos(beta);
        const double n = std::sin(beta);
        const double force[] = {-3 * c, -9 * n, 20, 30 * n, 200 * c, 40 * n * c};
        for (int k = 0; k < 6; ++k)
          waves << fmt::format("{:.17g} {} {} 0 0 {:.17g} {:.17g}\n", T, 30 * b, k + 1, k == 2 ? force[k] : 0,
                               k == 2 ? 0 : force[k]);
        const double mean[] = {0.5 * c, 2 * n, -8 * n * c};
        for (int k = 0; k < 3; ++k)
          drift << fmt::format("{:.17g} {} {} {} 0 0 {:.17g} 0\n", T, 30 * b, 30 * b, k < 2 ? k + 1 : 6,
                               mean[k]);
      }
  }
  MPI_Barrier(PETSC_COMM_WORLD);
  return stem;
}

// That ship in a wave, a current and wind, on springs about a place; all rotated by an angle and moved.
std::vector<Vec3> turned_ship(const std::string& stem, double turn_deg, double away, double follow) {
  const double turn = turn_deg * M_PI / 180;
  const double k = 0.64 / 10;
  const Mat3 R = exp_so3(turn * Vec3::UnitZ()).toRotationMatrix();
  const Vec3 place(away, -away, 0);
  const Vec3 at = place + R * Vec3(3, 1, 0);
  const double phase =
      -k * (std::cos(turn + 0.4) * place.x() + std::sin(turn + 0.4) * place.y()) * 180 / M_PI;
  const std::string text = fmt::format(
      R"(hawser: 1
environment:
  gravity: 10
  water: {{density: 1000}}
  current: {{speed: 0.8, direction_deg: {7:.17g}}}
  wind: {{speed: 20, direction_deg: {8:.17g}}}
  waves: {{regular: {{height: 2, period: {1:.17g}, direction_deg: {2:.17g}, phase_deg: {3:.17g}}}, ramp: 5}}
bodies:
  ship:
    position: [{4:.17g}, {5:.17g}, 0]
    rotation_deg: [0, 0, {6:.17g}]
    floating:
      mass: 1e6
      centre_of_mass: [2, 0, 2]
      inertia: [1e8, 1e9, 1e9]
      wind: {{frontal_area: 100, lateral_area: 900, length: 100, rows: {13}}}
      current: {{draught: 5, length: 100, rows: {14}}}
      hydrodynamics:
        wamit: {0}
        second_order: newman
        place: [{9:.17g}, {10:.17g}, 0]
        heading_deg: {11:.17g}
        follow_period: {12}
        stiffness: [[2e4, 0, 0, 0, 0, 0], [0, 3e4, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 4e7]]
statics: false
dynamics: {{duration: 20, step: 0.1}}
)",
      stem, 2 * M_PI / 0.8, turn_deg + 0.4 * 180 / M_PI, phase, at.x(), at.y(), turn_deg + 15, turn_deg - 70,
      turn_deg + 130, place.x(), place.y(), turn_deg, follow, kWind, kCurrent);
  const auto found = motion(io::read_case_text(text, testing::TempDir() + "turned.yaml"), 20, 5);
  std::vector<Vec3> out;
  for (const auto& row : found) out.push_back(R.transpose() * (row[0] - place));
  return out;
}

TEST(Platforms, TurnedAndMovedShipsMoveEqually) {
  const std::string stem = ship_files("hawser_platform_turned/ship");
  for (const double follow : {0.0, 100.0}) {
    const auto first = turned_ship(stem, 0, 0, follow);
    double moved = 0;
    for (const Vec3& x : first) moved = std::max(moved, (x - first[0]).norm());
    EXPECT_GT(moved, 0.5);
    for (const auto& [turn, away] :
         {std::pair(90.0, 0.0), {180.0, 0.0}, {-37.0, 0.0}, {0.0, 1e5}, {90.0, 1e5}}) {
      const auto other = turned_ship(stem, turn, away, follow);
      ASSERT_EQ(other.size(), first.size());
      double off = 0;
      for (size_t i = 0; i < first.size(); ++i) off = std::max(off, (other[i] - first[i]).norm());
      printf("ship turned by %g deg and %g m away, follow_period %g s: off by %.1e of %.3g m\n", turn, away,
             follow, off, moved);
      EXPECT_LT(off, 1e-8 * moved + 4e-16 * away * 100) << turn << " " << away;
    }
  }
}

// Without first-order forces the drift is the same: at rest 0.5 a² rho g over the stiffness, and the mean in
// dynamics.
TEST(Platforms, DriftActsWithoutFirstOrderForces) {
  const std::string stem = ship_files("hawser_platform_drift_only/ship");
  for (const bool excitation : {true, false}) {
    const std::string text = fmt::format(
        R"(hawser: 1
environment:
  gravity: 10
  water: {{density: 1000}}
  waves: {{regular: {{height: 4, period: 8}}, ramp: 0.5}}
bodies:
  ship:
    floating:
      mass: 1e6
      inertia: [1e8, 1e9, 1e9]
      hydrodynamics:
        wamit: {}
        second_order: newman
        excitation: {}
        place: [0, 0, 0]
        stiffness: [[2e4, 0, 0, 0, 0, 0], [0, 2e4, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1e8]]
dynamics: {{duration: 1, step: 0.1}}
)",
        stem, excitation);
    Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "drift_only.yaml"));
    s.solve_statics();
    EXPECT_NEAR(from_owner(s, [&](size_t n) { return s.state().x[n].x(); }), 1, 1e-6) << excitation;
    Dynamics& d = s.dynamics();
    d.start(s.state());
    integrate(d, 1, 1, [](const StepInfo&) {});
    std::vector<double> force(2, 0);  // of first order, drift
    if (s.local().owns(s.local().find(s.mesh().body_node(0))))
      for (const ReportsBodyForces* term : s.system().with<ReportsBodyForces>())
        for (size_t i = 0; i < term->load_components(0).size(); ++i)
          for (const auto& [name, at] : {std::pair("wave", 0), {"drift", 1}})
            if (term->load_components(0)[i] == name)
              force[static_cast<size_t>(at)] += term->forces_on(0, d.committed_kinematics())[i].force.x();
    all_reduce(PETSC_COMM_WORLD, MPI_SUM, force);
    EXPECT_EQ(std::abs(force[0]) > 1, excitation) << force[0];
    EXPECT_NEAR(force[1], 2e4, 1) << excitation;
  }
}

// A free ship with the mean drift moment -8 sin b cos b in waves to b comes to rest along the waves. The
// surge force at rest is that of waves to 0, and the displacement is 0.5 a² rho g over the stiffness.
TEST(Platforms, WavesTurnAShipAtRest) {
  const std::string stem = ship_files("hawser_platform_rest/ship");
  const std::string text = fmt::format(
      R"(hawser: 1
environment:
  gravity: 10
  water: {{density: 1000}}
  waves: {{regular: {{height: 4, period: 8, direction_deg: 100}}}}
bodies:
  ship:
    rotation_deg: [0, 0, 75]
    floating:
      mass: 1e6
      centre_of_mass: [0, 0, 0]
      inertia: [1e8, 1e9, 1e9]
      hydrodynamics:
        wamit: {}
        second_order: mean
        heading_deg: 0
        stiffness: [[2e4, 0, 0, 0, 0, 0], [0, 2e4, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]]
)",
      stem);
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "rest.yaml"));
  s.solve_statics();
  const double way = 0.5 * 4 * 1000 * 10 / 2e4, angle = 100 * M_PI / 180;
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return heading_of(s.state().q[n]).angle; }), angle, 1e-6);
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return s.state().x[n].x(); }), way * std::cos(angle), 1e-5);
  EXPECT_NEAR(from_owner(s, [&](size_t n) { return s.state().x[n].y(); }), way * std::sin(angle), 1e-5);
}

// A ship with heading 90 deg is pushed along its bow: its added mass is that of surge, 80 t beside 1000 t, or
// that of sway, 500 t, if the coefficients stay at heading 0. K(t) has little effect within half a second.
TEST(Platforms, AddedMassTurnsWithTheHeading) {
  const std::string stem = ship_files("hawser_platform_pushed/ship");
  for (const double follow : {100.0, 0.0}) {
    const std::string text = fmt::format(
        R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}}}
bodies:
  ship:
    rotation_deg: [0, 0, 90]
    floating:
      mass: 1e6
      inertia: [1e8, 1e9, 1e9]
      loads: [{{force: [1e6, 0, 0], axes: body}}]
      hydrodynamics: {{wamit: {}, heading_deg: 0, follow_period: {}}}
statics: false
dynamics: {{duration: 0.5, step: 0.01, rho_infinity: 1}}
)",
        stem, follow);
    const auto found = motion(io::read_case_text(text, testing::TempDir() + "pushed.yaml"), 0.5, 0.5);
    const double exact = 0.5 * 1e6 / (follow > 0 ? 1.08e6 : 1.5e6) * 0.25;
    EXPECT_NEAR(found.back()[0].y(), exact, 0.03 * exact) << follow;
    EXPECT_NEAR(found.back()[0].x(), 0, 1e-9) << follow;
  }
}

// A ship 3 deg off the heading of its coefficients, in waves along that heading, whose files have no roll
// force: the moment of pitch, with the stiffness and inertia of pitch, turns with the ship and does not
// excite roll. In axes of the files roll would be half of pitch.
TEST(Platforms, PitchOfATurnedShipExcitesNoRoll) {
  const std::string stem = ship_files("hawser_platform_pitching/ship");
  const std::string text = fmt::format(
      R"(hawser: 1
environment:
  gravity: 10
  water: {{density: 1000}}
  waves: {{regular: {{height: 2, period: 7.85, direction_deg: 0}}, ramp: 5}}
bodies:
  ship:
    rotation_deg: [0, 0, 3]
    floating:
      mass: 1e6
      inertia: [1e8, 1e9, 1e9]
      hydrodynamics: {{wamit: {}, second_order: none, heading_deg: 0, follow_period: 0}}
statics: false
dynamics: {{duration: 30, step: 0.1}}
)",
      stem);
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "pitching.yaml"));
  s.dynamics().start(s.state());
  double roll = 0;
  double pitch = 0;
  integrate(s.dynamics(), 30, 1, [&](const StepInfo&) {
    const Kinematics state = s.dynamics().committed_kinematics();
    roll = std::max(roll, std::abs(from_owner(s, [&](size_t n) { return state.w[n].x(); })));
    pitch = std::max(pitch, std::abs(from_owner(s, [&](size_t n) { return state.w[n].y(); })));
  });
  EXPECT_GT(pitch, 1e-3);
  EXPECT_LT(roll, 1e-3 * pitch);
}

// A body that moves with the waves at 2 m/s has the encounter frequency w - k v: its heave has this frequency
// and the phase of its position.
TEST(Platforms, MovingBodyMeetsTheWaves) {
  const std::string stem = coefficients("hawser_platform_meets/barge", "3 3 200\n4 4 900\n5 5 4000\n");
  if (rank_of(PETSC_COMM_WORLD) == 0) {
    std::ofstream waves(stem + ".3");
    for (int i = 4; i <= 12; ++i)
      for (int b = 0; b < 360; b += 60)
        waves << fmt::format("{:.17g} {} 3 0 0 12 5\n", 2 * M_PI / (0.2 * i), b);
  }
  MPI_Barrier(PETSC_COMM_WORLD);
  const std::string text = fmt::format(
      R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}, waves: {{regular: {{height: 1, period: {}}}, ramp: 10}}}}
bodies:
  barge:
    floating:
      mass: 1e6
      inertia: [1e8, 1e8, 1e8]
      velocity: [2, 0, 0]
      hydrodynamics:
        wamit: {}
        damping: [[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 1e6, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]]
statics: false
dynamics: {{duration: 400, step: 0.1, rho_infinity: 1}}
)",
      2 * M_PI / 0.9, stem);
  const auto found = motion(io::read_case_text(text, testing::TempDir() + "meets.yaml"), 400, 1);
  const double k = 0.081;
  const double meets = 0.9 - k * 2;
  const std::complex<double> X = 0.5 * 1e4 * std::complex<double>(12, 5);
  const std::complex<double> heave = X / std::complex<double>(2e6 - meets * meets * (1e6 + 1e3), meets * 1e6);
  double off = 0;
  for (size_t i = 300; i < found.size(); ++i) {
    const double t = static_cast<double>(i);
    const double exact = (heave * std::polar(1.0, meets * t)).real();
    off = std::max(off, std::abs(found[i][0].z() - exact));
  }
  printf("heave of a body that moves with a wave: %.4f m, off by %.2e m\n", std::abs(heave), off);
  EXPECT_LT(off, 0.01 * std::abs(heave));
}

// A ship on a link in waves, wind and current: its forces by component sum up to the total force, except for
// the pull of the link.
TEST(Platforms, ForcesByComponentAddUp) {
  const std::string stem = ship_files("hawser_platform_components/ship");
  const std::string text = fmt::format(
      R"(hawser: 1
environment:
  gravity: 10
  water: {{density: 1000}}
  wind: {{speed: 20, direction_deg: 40}}
  waves: {{regular: {{height: 2, period: 8, direction_deg: 30}}, ramp: 5}}
bodies:
  ship:
    position: [2, 1, 0]
    rotation_deg: [0, 0, 15]
    floating:
      mass: 1e6
      centre_of_mass: [2, 0, 2]
      inertia: [1e8, 1e9, 1e9]
      wind: {{frontal_area: 100, lateral_area: 900, length: 100, at: [0, 0, 12], rows: {}}}
      hydrodynamics:
        wamit: {}
        second_order: newman
        quadratic_damping: [1e4, 1e5, 0, 0, 0, 0]
links:
  hawser: {{end_a: {{body: ship, at: [50, 0, 3]}}, end_b: {{anchor: [110, 20, 3]}}, stiffness: 5e4, damping: 1e4}}
statics: false
dynamics: {{duration: 13, step: 0.1}}
)",
      kWind, stem);
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "components.yaml"));
  Dynamics& d = s.dynamics();
  d.start(s.state());
  integrate(d, 13, 13, [](const StepInfo&) {});
  const Kinematics& at = d.committed_kinematics();
  std::vector<std::string> names;
  std::vector<double> forces;  // by component: force, moment; then of all, and of the link
  for (const ReportsBodyForces* term : s.system().with<ReportsBodyForces>())
    for (const std::string& name : term->load_components(0)) names.push_back(name);
  ASSERT_EQ(names, (std::vector<std::string>{"wind", "hydrostatic", "radiation", "added", "wave", "drift"}));
  const auto add = [&](const Vec3& force, const Vec3& moment) {
    forces.insert(forces.end(), force.begin(), force.end());
    forces.insert(forces.end(), moment.begin(), moment.end());
  };
  const bool here = s.local().owns(s.local().find(s.mesh().body_node(0)));
  if (here) {
    for (const ReportsBodyForces* term : s.system().with<ReportsBodyForces>())
      for (const BodyForce& f : term->forces_on(0, at)) add(f.force, f.moment);
    const auto all = s.system().find<RigidBodies>()->force_on(0, at);
    add(all[0], all[1]);
    const auto n = static_cast<size_t>(s.local().find(s.mesh().body_node(0)));
    const Vec3 arm = at.q[n] * Vec3(48, 0, 1);
    const Vec3 along = at.x[n] + arm - Vec3(110, 20, 3);
    const Vec3 start = exp_so3(Vec3(0, 0, M_PI / 12)) * Vec3(50, 0, 3) + Vec3(2, 1, 0) - Vec3(110, 20, 3);
    const Vec3 speed = at.v[n] + at.q[n] * at.w[n].cross(Vec3(48, 0, 1));
    const Vec3 unit = along.normalized();
    const double pull = 5e4 * (along.norm() - start.norm()) + 1e4 * speed.dot(unit);
    add(-pull * unit, arm.cross(-pull * unit));
  }
  forces.resize(6 * (names.size() + 2), 0);
  all_reduce(PETSC_COMM_WORLD, MPI_SUM, forces);
  const auto of = [&](size_t i) { return Eigen::Map<const Vec6>(&forces[6 * i]); };
  for (size_t i = 0; i < names.size(); ++i) {
    EXPECT_GT(of(i).norm(), 1e3) << names[i];
    if (rank_of(PETSC_COMM_WORLD) == 0)
      printf("force by %s: %.4g %.4g %.4g kN\n", names[i].c_str(), of(i)[0] / 1000, of(i)[1] / 1000,
             of(i)[2] / 1000);
  }
  Vec6 rest = of(names.size());
  for (size_t i = 0; i < names.size(); ++i) rest -= of(i);
  const Vec6 link = of(names.size() + 1);
  // The residual of a step contains means over the step of some terms, so the balance at its end holds within
  // the error of a step.
  EXPECT_LT((rest - link).head<3>().norm(), 0.01 * of(1).head<3>().norm());
  EXPECT_GT(link.norm(), 1e4);
  EXPECT_LT((rest - link).head<2>().norm(), 0.02 * of(4).head<2>().norm());
}

// A submerged body, 1000 m³ about a point 40 m ahead of the origin of its files, has a surge force of
// constant size and phase at that point: it is interpolated exactly between periods with the phases there, 40
// k. The little heave stiffness of the files is noise, whose centre would be 20 m ahead.
TEST(Platforms, WaveForcesOfASubmergedBodyHaveTheirPhasesAtTheCentreOfBuoyancy) {
  const std::string stem =
      coefficients("hawser_platform_submerged/body", "3 3 0.05\n3 5 -1\n4 4 5000\n5 5 5000\n4 6 -40000\n");
  const double arm = 40;
  const auto number = [](double omega) { return omega * omega / 10; };
  if (rank_of(PETSC_COMM_WORLD) == 0) {
    std::ofstream waves(stem + ".3");
    for (const double omega : {1.2, 0.8}) {
      const std::complex<double> X = 5.0 * std::polar(1.0, -number(omega) * arm);
      waves << fmt::format("{:.17g} 0 1 0 0 {:.17g} {:.17g}\n", 2 * M_PI / omega, X.real(), X.imag());
    }
  }
  MPI_Barrier(PETSC_COMM_WORLD);
  for (const double omega : {0.8, 0.9, 1.0, 1.1}) {
    const std::string text = fmt::format(R"(hawser: 1
environment:
  gravity: 10
  water: {{density: 1000}}
  waves: {{regular: {{height: 2, period: {:.17g}}}, ramp: 0}}
bodies:
  body: {{floating: {{mass: 1e6, inertia: [1e8, 1e8, 1e8], hydrodynamics: {{wamit: {}}}}}}}
statics: false
dynamics: {{duration: 1, step: 0.1}}
)",
                                         2 * M_PI / omega, stem);
    Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "submerged.yaml"));
    Dynamics& d = s.dynamics();
    d.start(s.state());
    std::vector<double> surge(1, 0);
    if (s.local().owns(s.local().find(s.mesh().body_node(0))))
      for (const ReportsBodyForces* term : s.system().with<ReportsBodyForces>())
        for (size_t i = 0; i < term->load_components(0).size(); ++i)
          if (term->load_components(0)[i] == "wave")
            surge[0] += term->forces_on(0, d.committed_kinematics())[i].force.x();
    all_reduce(PETSC_COMM_WORLD, MPI_SUM, surge);
    // amplitude 1 m, rho g = 1e4 N/m³
    EXPECT_NEAR(surge[0], 5e4 * std::cos(number(omega) * arm), 5e4 * 1e-5) << omega;
  }
}

// A ship that rotates in waves, wind and current: after a restart its slow heading, memory, loads and forces
// by component are exactly those of the uninterrupted run.
TEST(Platforms, RestartGoesOnWithTheSlowHeading) {
  const std::string path = runs::folder("platform_restart");
  const std::string stem = ship_files("hawser_platform_kept/ship");
  const std::string text = fmt::format(
      R"(hawser: 1
environment:
  gravity: 10
  water: {{density: 1000}}
  current: {{speed: 0.5, direction_deg: 60}}
  wind: {{speed: 20, direction_deg: 40, gusts: {{spectrum: api, ramp: 5}}}}
  waves: {{jonswap: {{hs: 2, tp: 8, components: 40}}, ramp: 5}}
bodies:
  ship:
    rotation_deg: [0, 0, 15]
    floating:
      mass: 1e6
      inertia: [1e8, 1e9, 1e9]
      angular_velocity: [0, 0, 0.02]
      wind: {{frontal_area: 100, lateral_area: 900, length: 100, rows: {}}}
      current: {{draught: 5, length: 100, rows: {}}}
      loads: [{{table: {{rows: [[0, 1e4, 0, 0], [20, 5e4, 2e4, 0]]}}}}]
      hydrodynamics: {{wamit: {}, second_order: newman, follow_period: 30}}
statics: false
dynamics: {{duration: 20, step: 0.1}}
output: {{every: 5, checkpoint_every: 10, history_every: 0.5, histories: [{{body: ship}}]}}
)",
      kWind, kCurrent, stem);
  const std::string input = path + "/ship.yaml";
  runs::write_case(input, text);
  runs::run_on_all({input, path + "/whole.h5", "", 20});
  runs::run_on_all({input, path + "/half.h5", "", 10});
  runs::run_on_all({input, path + "/rest.h5", path + "/half.h5", 20});
  if (rank_of(PETSC_COMM_WORLD) != 0) return;
  const runs::Results whole = runs::read(path + "/whole.h5");
  const runs::Results rest = runs::read(path + "/rest.h5");
  ASSERT_EQ(whole.columns.at("ship"), 27u + 6 * 8);  // motion, force, seven components, remainder
  for (size_t c = 0; c < whole.columns.at("ship"); ++c) {
    const auto there = rest.column("ship", c);
    const auto here = runs::tail(whole.column("ship", c), there);
    ASSERT_GT(there.size(), 10u);
    EXPECT_EQ(here, there) << c;
  }
}

}  // namespace
}  // namespace hawser::test::platform_motions
