// Wind and current on floating bodies by coefficients: reference forces as offsets in statics, a body carried
// by the current, its energy, and the tangent of a step.
#include <fmt/format.h>

#include "../regression/runs.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "support/step_tangent.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::wind_and_current {
namespace {

using run::Simulation;

// Coefficients of one side, every 15 deg.
constexpr const char* kWind =
    "{frontal_area: 3939, lateral_area: 14368, length: 320, rows: [[0, 0.8, 0, 0], [15, 0.7727, 0.2459, "
    "0.0502], "
    "[30, 0.6928, 0.475, 0.0879], [45, 0.5657, 0.6718, 0.1041], [60, 0.4, 0.8227, 0.0953], [75, 0.2071, "
    "0.9176, "
    "0.0643], [90, 0, 0.95, 0.02], [105, -0.2071, 0.9176, -0.0257], [120, -0.4, 0.8227, -0.0606], [135, "
    "-0.5657, "
    "0.6718, -0.0759], [150, -0.6928, 0.475, -0.0679], [165, -0.7727, 0.2459, -0.0398], [180, -0.8, 0, 0]]}";
constexpr const char* kCurrent =
    "{length: 320, draught: 21.5, rows: [[0, 0.05, 0, 0], [15, 0.0483, 0.1812, 0.03], [30, 0.0433, 0.35, "
    "0.052], "
    "[45, 0.0354, 0.495, 0.06], [60, 0.025, 0.6062, 0.052], [75, 0.0129, 0.6761, 0.03], [90, 0, 0.7, 0], "
    "[105, "
    "-0.0129, 0.6761, -0.03], [120, -0.025, 0.6062, -0.052], [135, -0.0354, 0.495, -0.06], [150, -0.0433, "
    "0.35, "
    "-0.052], [165, -0.0483, 0.1812, -0.03], [180, -0.05, 0, 0]]}";

model::Case ship(const std::string& environment, const std::string& body, const std::string& rest = "") {
  const std::string text =
      fmt::format("hawser: 1\nenvironment: {{{}}}\nbodies:\n  ship: {{{}}}\n{}", environment, body, rest);
  return io::read_case_text(text, testing::TempDir() + "ship.yaml");
}

// On springs with a large rotational stiffness the offset is the force of the reference case over the
// stiffness: a ship of 320 m by tables of 15 deg, wind of 25 m/s to 250 deg at a heading of -35 deg, current
// of 1.2 m/s to 90 deg at a heading of 15 deg.
TEST(WindAndCurrent, StaticsHasTheReferenceForces) {
  struct Figure {
    const char* environment;
    double heading;
    std::string flow;
    Vec3 force;
  };
  const Figure figures[] = {{"wind: {speed: 25, direction_deg: 250}", -35, std::string("wind: ") + kWind,
                             Vec3(-2639047.61, -4313404.21, -113173144.0)},
                            {"water: {}, current: {speed: 1.2, direction_deg: 90}", 15,
                             std::string("current: ") + kCurrent, Vec3(-825221.666, 3332837.79, 48743424.0)}};
  for (const Figure& f : figures) {
    Simulation s(PETSC_COMM_WORLD,
                 ship(f.environment,
                      fmt::format("rotation_deg: [0, 0, {}], floating: {{mass: 1e8, inertia: [1e10, "
                                  "1e11, 1e11], stiffness: [1e6, 1e6, 1e6], turning_stiffness: "
                                  "[1e15, 1e15, 1e15], {}}}",
                                  f.heading, f.flow),
                      "statics: {tolerance: 1e-12}\n"));
    s.solve_statics();
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(1e6 * from_owner(s, [&](size_t n) { return s.state().x[n][k]; }), f.force[k],
                  5e-7 * f.force.norm())
          << k;
    const double turned =
        from_owner(s, [&](size_t n) { return log_so3(s.state().q[n]).z(); }) - f.heading * M_PI / 180;
    EXPECT_NEAR(1e15 * turned, f.force.z(), 1e-5 * std::abs(f.force.z()));
  }
}

// m v' = k (U - v)² from rest: U - v = U/(1 + k U t/m), k = rho/2 C_x L T. The work of the current is the
// kinetic energy.
TEST(WindAndCurrent, CurrentCarriesABodyAlong) {
  constexpr double U = 1.2, m = 2e7, k = 0.5 * 1025 * 0.05 * 320 * 21.5, kUntil = 200;
  const model::Case c =
      ship("water: {}, current: {speed: 1.2, direction_deg: 30}",
           fmt::format(
               "rotation_deg: [0, 0, 30], floating: {{mass: {}, inertia: [1e10, 1e11, 1e11], current: {}}}",
               m, kCurrent),
           fmt::format("statics: false\ndynamics: {{duration: {}, step: 0.5, rho_infinity: 1}}\n", kUntil));
  Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  integrate(d, kUntil, kUntil, [](const StepInfo&) {});
  const double speed = from_owner(s, [&](size_t n) { return d.committed_kinematics().v[n].norm(); });
  const double exact = U - U / (1 + k * U * kUntil / m);
  const Energy e = s.system().energy(d.committed_kinematics());
  double work = e.work;
  double kinetic = e.kinetic;
  MPI_Allreduce(MPI_IN_PLACE, &work, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &kinetic, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  printf("a current of %.1f m/s carries a body to %.7f m/s, exact %.7f m/s; work %.6g J, kinetic %.6g J\n", U,
         speed, exact, work, kinetic);
  EXPECT_GT(exact, 0.7);
  EXPECT_NEAR(speed, exact, 1e-5 * exact);
  EXPECT_NEAR(kinetic, 0.5 * m * speed * speed, 1e-9 * kinetic);
  EXPECT_NEAR(work, kinetic, 1e-5 * kinetic);
}

TEST(WindAndCurrent, TangentOfAStep) {
  const model::Case c = ship(
      "water: {depth: 50}, current: {speed: 1.2, direction_deg: 20, exponent: 1/7}, wind: {speed: 20, "
      "direction_deg: "
      "160, gusts: {spectrum: iso, ramp: 0}}",
      fmt::format(
          "position: [0, 0, -2], rotation_deg: [3, -5, 40], floating: {{mass: 1e5, inertia: [1e6, 2e6, 3e6], "
          "centre_of_mass: [1, 0.5, 2], wind: {}, current: {}}}",
          std::string(kWind).insert(1, "at: [5, -3, 20], height: 25, "),
          std::string(kCurrent).insert(1, "at: [-5, 2, -6], ")));
  Simulation s(PETSC_COMM_WORLD, c);
  StepTangent step = StepTangent::by_chance(s.system(), s.state(), 0.5, 0.05, 0.02);
  EXPECT_LT(step.worst(1e-3, 1e-3), 1e-7);
}

// Gusts add to the mean wind speed: on a stiff spring the force is rho/2 C A (U + u)².
TEST(WindAndCurrent, GustsAddToTheMean) {
  const model::Case c = ship(
      "wind: {speed: 20, gusts: {spectrum: api, seed: 5, ramp: 0, components: 50}}",
      fmt::format(
          "floating: {{mass: 1e3, inertia: [1e10, 1e11, 1e11], stiffness: [1e8, 1e8, 1e8], damping: [6e5, "
          "6e5, 6e5], wind: {}}}",
          kWind),
      "statics: false\ndynamics: {duration: 30, step: 0.05}\n");
  Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto all = gusts(GustSpectrum::api, 20, 20, 10, 50, 5);
  double largest = 0, speeds = 0;
  integrate(d, 30, 5, [&](const StepInfo& i) {
    if (i.time < 4 || !at_mark(i.time, 5)) return;
    const double x = from_owner(s, [&](size_t n) { return d.committed_kinematics().x[n].x(); });
    double u = 0;
    for (const Gust& g : all) u += g.amplitude * std::cos(g.omega * i.time + g.phase);
    const double force = 0.5 * 1.225 * 0.8 * 3939 * std::pow(20 + u, 2);
    largest = std::max(largest, std::abs(1e8 * x - force) / force);
    speeds = std::max(speeds, std::abs(u));
  });
  EXPECT_GT(speeds, 0.5);
  EXPECT_LT(largest, 0.02);  // effect of the damper: a delay of 0.006 s
}

}  // namespace
}  // namespace hawser::test::wind_and_current
