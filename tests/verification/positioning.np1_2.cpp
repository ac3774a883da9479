// Dynamic positioning of a body without other restraint: motion against the solution of the linear control
// loop, limits, statics, the tangent of a step, and a restart from a checkpoint.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <unsupported/Eigen/MatrixFunctions>

#include "../regression/runs.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/solve/natural_modes.hpp"
#include "hawser/terms/dynamic_positioning.hpp"
#include "support/step_tangent.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::positioning {
namespace {

using run::Simulation;

constexpr double kMass = 1e6, kInertia = 4e8;

model::Case vessel(const std::string& body, const std::string& floating, const std::string& rest) {
  return io::read_case_text(
      fmt::format(
          "hawser: 1\nbodies:\n  vessel: {{{}floating: {{mass: {}, inertia: [1e8, 3e8, {}], {}}}}}\n{}", body,
          kMass, kInertia, floating, rest),
      testing::TempDir() + "vessel.yaml");
}

Vec3 place(const Simulation& s, const Kinematics& state) {
  Vec3 out;
  for (int k = 0; k < 2; ++k) out[k] = from_owner(s, [&](size_t n) { return state.x[n][k]; });
  out.z() = from_owner(s, [&](size_t n) { return log_so3(state.q[n]).z(); });
  return out;
}

Vec3 thrust(Simulation& s, const Kinematics& state) {
  std::vector<double> sum(3, 0);
  for (const BodyForce& f : s.system().find<DynamicPositioning>()->forces_on(0, state))
    Eigen::Map<Vec3>(sum.data()) += Vec3(f.force.x(), f.force.y(), f.moment.z());
  all_reduce(PETSC_COMM_WORLD, MPI_SUM, sum);
  return Vec3(sum.data());
}

// Decay of offsets without load: x = e^(-zeta w t) (cos w_d t + zeta w/w_d sin w_d t) x_0. The filter of 1 s
// adds 3 (w/c)² = 5e-4 of the acceleration.
TEST(Positioning, DecaysAsAnOscillator) {
  constexpr double w = 2 * M_PI / 80, zeta = 0.5, turns = 2 * M_PI / 60;
  const model::Case c = vessel(
      "position: [10, -6, 0], rotation_deg: [0, 0, 4], ",
      fmt::format("positioning: {{place: [0, 0, 0], heading_deg: 0, proportional: [{0}, {0}, {1}], "
                  "derivative: [{2}, {2}, {3}], filter_period: 1}}",
                  kMass * w * w, kInertia * turns * turns, 2 * zeta * w * kMass, 2 * zeta * turns * kInertia),
      "statics: false\ndynamics: {duration: 120, step: 0.05, rho_infinity: 1}\n");
  Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto decay = [&](double omega, double t) {
    const double damped = omega * std::sqrt(1 - zeta * zeta);
    return std::exp(-zeta * omega * t) *
           (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t));
  };
  double off = 0;
  integrate(d, 120, 10, [&](const StepInfo& i) {
    if (!at_mark(i.time, 10)) return;
    const Vec3 x = place(s, d.committed_kinematics());
    off = std::max(off, std::abs(x.x() - 10 * decay(w, i.time)) / 10);
    off = std::max(off, std::abs(x.y() + 6 * decay(w, i.time)) / 6);
    off = std::max(off, std::abs(x.z() - 4 * M_PI / 180 * decay(turns, i.time)) / (4 * M_PI / 180));
  });
  printf("decay by positioning: off by %.1e of the offset\n", off);
  EXPECT_LT(off, 1e-3);
}

// A constant force on a body with heading +y, so that surge is along y: the linear loop of position, filter
// and integral is z' = A z + b, solved exactly by the exponential of A. At the end the integral carries the
// force, and the energy balance closes.
TEST(Positioning, HoldsAgainstAForceByItsIntegral) {
  constexpr double w = 2 * M_PI / 150;
  constexpr double P = kMass * w * w;
  constexpr double D = 1.4 * kMass * w;
  constexpr double I = 0.15 * P * w;
  constexpr double F = 4e4;
  constexpr double period = 40;
  constexpr double c = 2 * M_PI / period;
  const model::Case model =
      vessel("rotation_deg: [0, 0, 90], ",
             fmt::format("loads: [{{force: [0, {}, 0]}}], positioning: {{proportional: [{}, 7, 1e6], "
                         "derivative: [{}, 5, 1e7], "
                         "integral: [{}, 0.01, 0], filter_period: {}}}",
                         F, P, D, I, period),
             "statics: false\ndynamics: {duration: 1500, step: 0.5, rho_infinity: 1}\n");
  // z = (x, v, y, y', r, s): y filtered position, r' = c (y' - r), slow position y + 2 r/c, s its integral.
  Eigen::Matrix<double, 7, 7> A = Eigen::Matrix<double, 7, 7>::Zero();  // and the constant 1
  A(0, 1) = A(2, 3) = 1;
  A.row(3) << c * c, 0, -c * c, -2 * c, 0, 0, 0;
  A.row(4) << 0, 0, 0, c, -c, 0, 0;
  A.row(5) << 0, 0, 1, 0, 2 / c, 0, 0;
  A.row(1) << 0, 0, -P, -3 * D, 2 * D - 2 * P / c, -I, F;
  A.row(1) /= kMass;
  Simulation s(PETSC_COMM_WORLD, model);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  double off = 0, largest = 0, unbalanced = 0, least = 0;
  const auto energy = [&](double Energy::*part) {
    return from_owner(s, [&](size_t) { return s.system().energy(d.committed_kinematics()).*part; });
  };
  integrate(d, 1500, 25, [&](const StepInfo& i) {
    if (!at_mark(i.time, 25)) return;
    const double work = energy(&Energy::work);
    least = std::min(least, work);
    unbalanced = std::max(unbalanced, std::abs(work - energy(&Energy::kinetic) - energy(&Energy::potential)));
    const Eigen::Matrix<double, 7, 7> E = (A * i.time).exp();
    const double y = place(s, d.committed_kinematics()).y();
    off = std::max(off, std::abs(y - E(0, 6)));
    largest = std::max(largest, std::abs(E(0, 6)));
  });
  const double end = place(s, d.committed_kinematics()).y();
  printf("against a force: off by %.1e of %.3g m, at the end %.2e m\n", off, largest, end);
  EXPECT_GT(largest, 10);
  EXPECT_LT(off, 1e-4 * largest);
  EXPECT_LT(std::abs(end), 1e-3 * largest);
  EXPECT_NEAR(thrust(s, d.committed_kinematics()).y(), -F, 1e-3 * F);
  EXPECT_LT(least, -0.5 * F * largest);
  EXPECT_LT(unbalanced, 1e-4 * F * largest);
}

// Far from the set point the thrusters exert their maximum, towards the set point: x = x_0 - F/(2 m) t². The
// integral stays zero.
TEST(Positioning, GivesNoMoreThanItsLimits) {
  constexpr double kForce = 5e4, kMoment = 2e5, kUntil = 40;
  const model::Case c =
      vessel("position: [300, -400, 0], rotation_deg: [0, 0, 60], ",
             fmt::format("positioning: {{place: [0, 0, 0], heading_deg: 0, proportional: [1e6, 1e6, 1e9], "
                         "integral: [1e3, 1e3, "
                         "1e6], max_force: {}, max_moment: {}}}",
                         kForce, kMoment),
             fmt::format("statics: false\ndynamics: {{duration: {}, step: 0.1, rho_infinity: 1}}\n", kUntil));
  Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  integrate(d, kUntil, kUntil, [](const StepInfo&) {});
  const Vec3 end = place(s, d.committed_kinematics());
  const double way = 0.5 * kForce / kMass * kUntil * kUntil;
  EXPECT_NEAR(end.x(), 300 - 0.6 * way, 1e-6 * way);
  EXPECT_NEAR(end.y(), -400 + 0.8 * way, 1e-6 * way);
  EXPECT_NEAR(end.z(), M_PI / 3 - 0.5 * kMoment / kInertia * kUntil * kUntil, 1e-6);
  for (const CheckpointRecord& r : s.system().find<DynamicPositioning>()->checkpoint_records({}))
    // The integral is followed by time and work.
    EXPECT_EQ(Vec3(&r.values[r.values.size() - 5]), Vec3::Zero()) << "the integral";
}

// Limits of surge and sway are along the body's axes; a force between them ends on the ellipse in the
// direction of the set point. The body has heading +y, its set point is 300 m to starboard and 400 m ahead.
TEST(Positioning, LimitsAreAnEllipseInItsAxes) {
  constexpr double kSurge = 6e4, kSway = 2e4, P = 1e6;
  const model::Case c =
      vessel("rotation_deg: [0, 0, 90], ",
             fmt::format("positioning: {{place: [300, 400, 0], proportional: [{0}, {0}, 1e9], "
                         "max_force: [{1}, {2}]}}",
                         P, kSurge, kSway),
             "statics: false\ndynamics: {duration: 1, step: 0.1}\n");
  Simulation s(PETSC_COMM_WORLD, c);
  const Vec3 F = thrust(s, s.state().at_rest());
  const double size = 1 / std::hypot(0.8 / kSurge, 0.6 / kSway);
  EXPECT_NEAR(F.x(), 0.6 * size, 1e-9 * size);
  EXPECT_NEAR(F.y(), 0.8 * size, 1e-9 * size);
}

// A squall exceeds the thrusters for five minutes. The integral does not grow while they are at their limit:
// the overshoot is below a tenth of the offset.
TEST(Positioning, DoesNotWindUp) {
  constexpr double w = 2 * M_PI / 100;
  constexpr double P = kMass * w * w;
  constexpr double D = 1.4 * kMass * w;
  constexpr double I = P * w / 10;
  constexpr double F = 2e4;
  const auto past = [&](double integral) {
    const model::Case c = vessel(
        "",
        fmt::format("loads: [{{table: {{rows: [[0, 0, 0, 0], [10, {0}, 0, 0], [310, {0}, 0, 0], [320, 0, 0, "
                    "0]]}}}}], damping: [2e4, 2e4, 0], positioning: {{proportional: [{1}, {1}, 1e7], "
                    "derivative: [{2}, {2}, 1e8], integral: [{3}, {3}, 0], filter_period: 10, "
                    "max_force: {4}}}",
                    F, P, D, integral, 0.8 * F),
        "statics: false\ndynamics: {duration: 800, step: 0.5}\n");
    Simulation s(PETSC_COMM_WORLD, c);
    Dynamics& d = s.dynamics();
    d.start(s.state());
    double most = 0, least = 0;
    integrate(d, 800, 10, [&](const StepInfo&) {
      const double x = place(s, d.committed_kinematics()).x();
      most = std::max(most, x);
      least = std::min(least, x);
    });
    return std::pair(most, least);
  };
  const auto [far, beyond] = past(I);
  const auto [far_without, beyond_without] = past(0);
  printf("squall: %.3g m off and %.3g m beyond; without an integral %.3g and %.3g m\n", far, -beyond,
         far_without, -beyond_without);
  EXPECT_GT(far, 20);
  EXPECT_LT(-beyond, 0.1 * far);
}

// Statics converges from positions where the thrusters are at their limit.
TEST(Positioning, StaticsFromFarOff) {
  const model::Case c =
      vessel("position: [7, -4, 0], rotation_deg: [0, 0, 20], ",
             "stiffness: [0, 0, 1e6], turning_stiffness: [1e9, 1e9, 0], loads: [{force: [2e4, 1e4, 0]}], "
             "positioning: {place: [0, 0, 0], heading_deg: 0, proportional: [1e5, 1e5, 1e8], integral: [100, "
             "100, 1e5], max_force: 5e4, max_moment: 1e7}",
             "");
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  const Vec3 rest = place(s, s.state().at_rest());
  EXPECT_NEAR(rest.x(), 2e4 / 1e8, 1e-6);
  EXPECT_NEAR(rest.y(), 1e4 / 1e8, 1e-6);
  EXPECT_NEAR(rest.z(), 0, 1e-6);
}

// Equilibrium: with an integral the offset is a thousandth of F/P, or as small as the limit allows; without
// it F/P. The motion then starts at rest.
TEST(Positioning, StaticsHoldsThePlace) {
  constexpr double F = 3e4, N = 5e6, k = 1e4;
  struct Figure {
    const char* keys;
    double x, angle;
  };
  const Figure figures[] = {
      {"integral: [100, 100, 1e5]", F / (k + 1e8), N / (1e9 + 1e12)},
      {"derivative: [1e5, 1e5, 1e9]", F / (k + 1e5), N / (1e9 + 1e9)},
      {"integral: [100, 100, 1e5], max_force: 1e4, max_moment: 1e6", (F - 1e4) / k, (N - 1e6) / 1e9}};
  for (const Figure& f : figures) {
    const model::Case c =
        vessel("",
               fmt::format("stiffness: [{}, {}, 1e6], turning_stiffness: [1e9, 1e9, 1e9], loads: [{{force: "
                           "[{}, 0, 0], moment: "
                           "[0, 0, {}]}}], positioning: {{proportional: [1e5, 1e5, 1e9], {}}}",
                           k, k, F, N, f.keys),
               "statics: {tolerance: 1e-12}\ndynamics: {duration: 20, step: 0.2}\n");
    Simulation s(PETSC_COMM_WORLD, c);
    s.solve_statics();
    const Vec3 rest = place(s, s.state().at_rest());
    EXPECT_NEAR(rest.x(), f.x, 1e-6 * f.x) << f.keys;
    EXPECT_NEAR(rest.z(), f.angle, 1e-6 * f.angle) << f.keys;
    EXPECT_NEAR(thrust(s, s.state().at_rest()).x(), k * f.x - F, 1e-6 * F) << f.keys;
    Dynamics& d = s.dynamics();
    d.start(s.state());
    integrate(d, 20, 20, [](const StepInfo&) {});
    EXPECT_LT((place(s, d.committed_kinematics()) - rest).norm(), 1e-4 * (F / 1e5)) << f.keys;
  }
}

// Only surge has an integral, and the load exceeds the limit: sway exerts P_y y, surge the rest of the
// ellipse, springs the remaining force, and the motion starts at rest. For loads ahead and astern, and with
// surge and sway exchanged.
TEST(Positioning, OneIntegralBesideALimit) {
  constexpr double k = 1e4, P = 1e5, X = 3e4, Y = 2e4;
  for (const bool surge : {true, false})
    for (const double sign : {1.0, -1.0}) {
      const double ahead = sign * 8e4;
      const double across = 1.2e4;
      const double least = surge ? Y : X;
      const double most = surge ? X : Y;
      const Vec3 load = surge ? Vec3(ahead, across, 0) : Vec3(across, ahead, 0);
      const model::Case c = vessel(
          "",
          fmt::format(
              "stiffness: [{}, {}, 1e6], turning_stiffness: [1e9, 1e9, 1e9], loads: [{{force: [{}, {}, "
              "0]}}], positioning: {{proportional: [{}, {}, 1e9], integral: [{}, {}, 0], max_force: "
              "[{}, {}]}}",
              k, k, load.x(), load.y(), P, P, surge ? 100 : 0, surge ? 0 : 100, X, Y),
          "statics: {tolerance: 1e-12}\ndynamics: {duration: 20, step: 0.2}\n");
      Simulation s(PETSC_COMM_WORLD, c);
      s.solve_statics();
      const Vec3 rest = place(s, s.state().at_rest());
      const double aside = across / (k + P);
      const double share = P * aside / least;
      const double along = (ahead - std::copysign(most * std::sqrt(1 - share * share), ahead)) / k;
      EXPECT_NEAR(rest[surge ? 1 : 0], aside, 1e-6 * aside);
      EXPECT_NEAR(rest[surge ? 0 : 1], along, 1e-6 * std::abs(along));
      Dynamics& d = s.dynamics();
      d.start(s.state());
      integrate(d, 20, 20, [](const StepInfo&) {});
      EXPECT_LT((place(s, d.committed_kinematics()) - rest).norm(), 1e-3 * std::abs(along));
    }
}

// Modes about the equilibrium have the proportional stiffness, independent of integral and limits. Thrusters
// and a spring at the mass centre share the load at the origin. The origin is 10 m behind the mass centre, so
// sway and yaw are coupled, and the part F of the load that the spring carries adds to the yaw stiffness:
//   K = P_y (1, -10; -10, 100) + (0, 0; 0, P_yaw - 10 F)
TEST(Positioning, ModesHaveTheProportionalPart) {
  constexpr double kArm = 10, kSway = 1e5, kYaw = 1e8, kLoad = 3.7e6;  // N/m, of surge and sway
  for (const double spring : {0., 0.7e6, 0.9e6, 1.1e6}) {
    const double carried = spring > 0 ? 0.4 * kLoad : 0;
    const double heading = spring > 0 ? 30 : 0;
    const Vec3 load = kLoad * (exp_so3(heading * M_PI / 180 * Vec3::UnitZ()) * Vec3::UnitX());
    Simulation s(
        PETSC_COMM_WORLD,
        vessel(
            fmt::format("rotation_deg: [0, 0, {}], ", heading),
            fmt::format("centre_of_mass: [{0}, 0, 0], stiffness: [{3}, {3}, 1e7], turning_stiffness: [1e9, "
                        "1e9, 0], loads: [{{force: [{4:.17g}, {5:.17g}, 0]}}], positioning: {{proportional: "
                        "[{1}, {1}, {2}], integral: [170, 170, 1e5]{6}}}",
                        kArm, kSway, kYaw, spring, load.x(), load.y(),
                        spring > 0 ? fmt::format(", max_force: {}", kLoad - carried) : ""),
            "statics: {tolerance: 1e-12}\n"));
    s.solve_statics();
    s.system().find<DynamicPositioning>()->integrate_at_rest(false);
    const std::vector<NaturalMode> modes = natural_modes(s.system(), s.state().at_rest(), 3);
    Eigen::Matrix2d K;
    Eigen::Matrix2d M = Eigen::Vector2d(kMass, kInertia).asDiagonal();
    K << kSway + spring, -kArm * kSway, -kArm * kSway, kArm * kArm * kSway + kYaw - kArm * carried;
    const Eigen::Vector2d coupled =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(K, M).eigenvalues();
    std::vector<double> squares = {coupled[0], (kSway + spring) / kMass, coupled[1]};
    std::sort(squares.begin(), squares.end());
    ASSERT_EQ(modes.size(), 3u);
    for (size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(modes[i].squared, squares[i], 1e-6 * squares[i]) << i << " " << spring;
  }
}

TEST(Positioning, TangentOfAStep) {
  for (const char* limits :
       {"", ", max_force: 100, max_moment: 3e4", ", max_force: [300, 100], max_moment: 3e4"}) {
    const model::Case c = vessel(
        "position: [2, -3, 1], rotation_deg: [3, -5, 40], ",
        fmt::format(
            "centre_of_mass: [1, 0.5, 2], positioning: {{place: [40, 5, 0], heading_deg: 30, proportional: "
            "[1e4, 3e4, 1e7], derivative: [1e5, 4e5, 2e8], integral: [1e3, 2e3, 1e5], filter_period: 3{}}}",
            limits),
        "");
    Simulation s(PETSC_COMM_WORLD, c);
    StepTangent step = StepTangent::by_chance(s.system(), s.state(), 0.5, 0.05, 0.02);
    EXPECT_LT(step.worst(1e-3, 1e-3), 1e-7) << limits;
  }
}

// After a restart the motion and forces are those of one run, on 1 and 2 ranks.
TEST(Positioning, GoesOnAfterARestart) {
  const std::string path = runs::folder("positioning_restart");
  const std::string input = path + "/vessel.yaml";
  runs::write_case(input, fmt::format(R"(hawser: 1
bodies:
  vessel:
    position: [4, 2, 0]
    rotation_deg: [0, 0, 5]
    floating:
      mass: {}
      inertia: [1e8, 3e8, {}]
      stiffness: [0, 0, 1e6]
      loads: [{{table: {{rows: [[0, 1e4, 0, 0], [40, 5e4, 2e4, 0]]}}}}]
      positioning: {{place: [0, 0, 0], heading_deg: 0, proportional: [5e4, 5e4, 2e7], derivative: [2e5, 2e5, 1e8],
        integral: [1e3, 1e3, 1e5], filter_period: 5, max_force: 5e4}}
statics: false
dynamics: {{duration: 40, step: 0.1}}
output: {{every: 10, checkpoint_every: 20, history_every: 0.5, histories: [{{body: vessel}}]}}
)",
                                      kMass, kInertia));
  runs::run_on_all({input, path + "/whole.h5", "", 40});
  runs::run_on_all({input, path + "/half.h5", "", 20});
  runs::run_on_all({input, path + "/rest.h5", path + "/half.h5", 40});
  runs::run_on_one({input, path + "/one.h5", "", 40});
  if (runs::rank_of(PETSC_COMM_WORLD) != 0) return;
  const runs::Results whole = runs::read(path + "/whole.h5");
  const runs::Results rest = runs::read(path + "/rest.h5");
  const runs::Results one = runs::read(path + "/one.h5");
  ASSERT_EQ(whole.columns.at("vessel"), 27u + 6 * 2);  // motion, force, thrusters, remainder
  for (size_t c = 0; c < whole.columns.at("vessel"); ++c) {
    const auto there = rest.column("vessel", c);
    const auto here = runs::tail(whole.column("vessel", c), there);
    ASSERT_GT(there.size(), 10u);
    EXPECT_EQ(here, there) << c;
    EXPECT_EQ(whole.column("vessel", c), one.column("vessel", c)) << c;
  }
}

}  // namespace
}  // namespace hawser::test::positioning
