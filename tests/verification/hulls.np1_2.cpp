// Bodies with hulls in water against closed forms: periods, draught and heel, Froude-Krylov force of a box, a
// spar with members; energy in waves, restart. On one and two ranks.
#include "hawser/terms/hulls.hpp"

#include <fmt/format.h>

#include <fstream>

#include "../regression/runs.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/longest_step.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::hulls {
namespace {

constexpr double kG = 9.80665;
constexpr double kRho = 1000;

// A box of 20 x 8 x 6 m, its bottom 4 m below the body's origin.
std::string barge(const std::string& floating, const std::string& sea, const std::string& rest) {
  return fmt::format(R"(hawser: 1
environment: {{gravity: 9.80665, water: {{density: 1000, depth: 200}}{}}}
bodies:
  barge: {{{}}}
volumes:
  side: {{shape: {{box: {{centre: [0, 0, -1], size: [20, 8, 6]}}}}, body: barge}}
{}
)",
                     sea, floating, rest);
}

model::Case read(const std::string& text) {
  return io::read_case_text(text, testing::TempDir() + "hulls.yaml");
}

Simulation simulation(model::Case c) {
  const auto volumes = run::load_volumes(c, PETSC_COMM_WORLD);
  run::set_hydrostatics(c, volumes);
  return Simulation(PETSC_COMM_WORLD, c, run::surfaces(volumes), run::skeletons(c, volumes),
                    run::volume_facets(volumes));
}

constexpr double kMass = kRho * 20 * 8 * 2.5;  // draught 2.5 m

// Periods without added mass: heave by the waterplane, roll by I/(rho g (I_x + V (z_B - z_G))).
TEST(Hulls, HeaveAndRollOfABox) {
  const double inertia = 4e6;
  const auto found = [&](const std::string& start, int axis, double T) {
    const model::Case c = read(barge(
        fmt::format("position: [0, 0, 1.5], floating: {{mass: {}, inertia: [{}, 2e7, 2e7], centre_of_mass: "
                    "[0, 0, -2], {}, hull: {{volumes: [side]}}}}",
                    kMass, inertia, start),
        "", fmt::format("dynamics: {{duration: {}, step: {}, rho_infinity: 1}}", 4.2 * T, T / 400)));
    Simulation s = simulation(c);
    return period_from_rest(s, [axis](const Kinematics& state, size_t n) {
      return axis == 2 ? state.x[n].z() : log_so3(floating_state(state, static_cast<int>(n)).q).x();
    });
  };
  const double heave = 2 * M_PI * std::sqrt(kMass / (kRho * kG * 160));
  EXPECT_NEAR(found("velocity: [0, 0, 0.02]", 2, heave), heave, 1e-3 * heave);
  const double stiffness = kRho * kG * (20 * 512 / 12.0 + 400 * (-1.25 - 0.5 + 1));
  const double roll = 2 * M_PI * std::sqrt(inertia / stiffness);
  EXPECT_NEAR(found("angular_velocity: [0.005, 0, 0]", 3, roll), roll, 1e-3 * roll);
}

// Heave and roll in still water, where nothing else shortens the steps: automatic steps are a sixtieth of the
// shorter period, and the motion after 16 s is that with steps of 4 ms.
TEST(Hulls, AutomaticStepsFollowThePeriodsOfAHull) {
  const double duration = 16;
  const auto read_afloat = [&](const std::string& step) {
    return read(barge(
        fmt::format("position: [0, 0, 1.7], floating: {{mass: {}, inertia: [4e6, 2e7, 2e7], "
                    "centre_of_mass: [0, 0, -2], angular_velocity: [0.05, 0, 0], hull: {{volumes: [side]}}}}",
                    kMass),
        "",
        fmt::format("statics: false\ndynamics: {{duration: {}{}}}\noutput: {{every: {}}}", duration, step,
                    duration)));
  };
  const auto end = [&](const std::string& step) {
    Simulation s = simulation(read_afloat(step));
    if (step.empty()) {
      const double heave = 2 * M_PI * std::sqrt(kMass / (kRho * kG * 160));
      EXPECT_NEAR(model::longest_step(s.model()).length, heave / 60, 1e-9 * heave);
    }
    Dynamics& d = s.dynamics();
    d.start(s.state());
    integrate(d, duration, duration, [](const StepInfo&) {});
    Vec3 out;
    for (int axis = 0; axis < 3; ++axis)
      out[axis] = from_owner(s, [&](size_t n) {
        if (axis == 2) return d.committed_kinematics().x[n].z() + 0.5;
        return log_so3(floating_state(d.committed_kinematics(), static_cast<int>(n)).q)[axis];
      });
    return out;
  };
  const Vec3 automatic = end("");
  const Vec3 fine = end(", step: 0.004");
  printf("hull afloat: heave %.5f and roll %.6f, with short steps %.5f and %.6f\n", automatic.z(),
         automatic.x(), fine.z(), fine.x());
  EXPECT_NEAR(automatic.z(), fine.z(), 0.03 * 0.2);
  EXPECT_NEAR(automatic.x(), fine.x(), 0.03 * 0.045);
}

// Errors: a box without bottom, and a box heavier than the water it can displace.
TEST(Hulls, WhatDoesNotFloatIsRefused) {
  const auto message = [](double mass, const std::string& volume) {
    model::Case c = read(barge(fmt::format("floating: {{mass: {}, inertia: [4e6, 2e7, 2e7], hull: {{volumes: "
                                           "[side]}}}}",
                                           mass),
                               "", "dynamics: {duration: 1}"));
    if (!volume.empty()) {
      c.volumes[0].shape.reset();
      c.volumes[0].mesh = volume;
    }
    const auto volumes = run::load_volumes(c, PETSC_COMM_WORLD);
    try {
      run::set_hydrostatics(c, volumes);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(kMass, ""), "");
  EXPECT_NE(message(1e6, "").find("it cannot float: the fully submerged hull displaces 9.6e+05 kg"),
            std::string::npos);
  const std::string open = testing::TempDir() + "open.obj";
  if (runs::rank_of(MPI_COMM_WORLD) == 0)
    std::ofstream(open)
        << "v -10 -4 -4\nv 10 -4 -4\nv 10 4 -4\nv -10 4 -4\nv -10 -4 2\nv 10 -4 2\nv 10 4 2\nv -10 4 2\n"
           "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n";
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_NE(message(kMass, open).find("the surface is not closed: its volume is 960, 960 or"),
            std::string::npos);
}

// Heel of a wall-sided ship with an eccentric centre of mass (Barrass and Derrett, Ship Stability), at
// constant displaced volume:
//   tan(heel) (GM + BM/2 tan²(heel)) = y_G
TEST(Hulls, HeelOfABoxAtRest) {
  const double off = 0.2;
  const model::Case c = read(
      barge(fmt::format(
                "position: [0, 0, 2.1], floating: {{mass: {}, inertia: [4e6, 2e7, 2e7], centre_of_mass: [0, "
                "{}, -2], hull: {{volumes: [side]}}}}",
                kMass, off),
            "", ""));
  Simulation s = simulation(c);
  s.solve_statics();
  const double heel = from_owner(
      s, [&](size_t n) { return log_so3(floating_state(s.state().at_rest(), static_cast<int>(n)).q).x(); });
  const double BM = 20 * 512 / 12.0 / (160 * 2.5);
  const double GM = 1.25 + BM - 2;
  double tangent = 0;
  for (int i = 0; i < 50; ++i) tangent = off / (GM + 0.5 * BM * tangent * tangent);
  printf("box at rest: heel %.8f rad, by the formula of wall-sided ships %.8f rad\n", heel,
         std::atan(tangent));
  EXPECT_NEAR(std::abs(heel), std::atan(tangent), 1e-6);
  EXPECT_LT(heel, -0.1);  // towards the side of the centre of mass
}

// A barge with its centre of mass off the middle heels and trims. Nothing turns it about the vertical: its
// bow rests within a degree of where it was, and Newton's method takes a few iterations.
TEST(Hulls, BoxAtRestKeepsItsHeading) {
  const model::Case c = read(
      barge(fmt::format("position: [0, 0, 2.1], rotation_deg: [0, 0, 40], floating: {{mass: {}, inertia: "
                        "[4e6, 2e7, 2e7], centre_of_mass: [0.5, 0.3, -2], hull: {{volumes: [side]}}}}",
                        kMass),
            "", ""));
  Simulation s = simulation(c);
  EXPECT_LE(s.solve_statics().iterations, 15);
  const auto bow = [&](int k) {
    return from_owner(s, [&](size_t n) { return (s.state().q[n] * Vec3::UnitX())[k]; });
  };
  EXPECT_LT(bow(2), -0.01);
  EXPECT_NEAR(std::atan2(bow(1), bow(0)) * 180 / M_PI, 40, 1);
}

// Froude-Krylov force of linear waves of 0.1 m on a fixed box of L x B, draught T:
//   across rho g a B (1 - exp(-k T))/k 2 sin(k L/2), upwards rho g a exp(-k T) B (2/k) sin(k L/2)
TEST(Hulls, FroudeKrylovForceOfABox) {
  const double period = 6;
  const model::Case c = read(barge(
      fmt::format("position: [0, 0, 1.5], floating: {{mass: {}, inertia: [4e6, 2e7, 2e7], "
                  "centre_of_mass: [0, 0, -2], hull: {{volumes: [side]}}}}",
                  kMass),
      fmt::format(", waves: {{regular: {{height: 0.1, period: {}}}}}", period), "dynamics: {duration: 1}"));
  Simulation s = simulation(c);
  auto* hulls = s.system().find<Hulls>();
  ASSERT_NE(hulls, nullptr);
  Kinematics at = s.state().at_rest();
  constexpr int kTimes = 24;
  Vec3 cosine = Vec3::Zero();
  Vec3 sine = Vec3::Zero();
  for (int i = 0; i < kTimes; ++i) {
    at.time = period * (20 + static_cast<double>(i) / kTimes);  // after the ramp of the waves
    at.phase = Phase::start;
    at.step = 0.01;
    hulls->prepare(at, 0.01);
    at.phase = Phase::step;
    at.time += 1e-9;
    const std::vector<BodyForce> forces = hulls->forces_on(0, at);
    Vec3 force = forces.empty() ? Vec3::Zero() : forces[1].force;
    MPI_Allreduce(MPI_IN_PLACE, force.data(), 3, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    cosine += 2.0 / kTimes * std::cos(2 * M_PI * i / kTimes) * force;
    sine += 2.0 / kTimes * std::sin(2 * M_PI * i / kTimes) * force;
  }
  const double k = std::pow(2 * M_PI / period, 2) / kG;
  const double length = 2 / k * std::sin(10 * k);
  const double up = kRho * kG * 0.05 * 8 * std::exp(-2.5 * k) * length;
  const double across = kRho * kG * 0.05 * 8 * (1 - std::exp(-2.5 * k)) * length;
  printf("box in waves: upwards %.0f N (%+.2f %%), across %.0f N (%+.2f %%)\n", cosine.z(),
         100 * (cosine.z() / up - 1), -sine.x(), 100 * (-sine.x() / across - 1));
  EXPECT_NEAR(cosine.z(), up, 0.01 * up);
  EXPECT_NEAR(-sine.x(), across, 0.01 * across);
  EXPECT_LT(std::abs(cosine.y()) + std::abs(sine.y()), 1e-3 * up);
}

// A floating cylinder with the added mass of a member, on a spring for surge only:
// T = 2 pi sqrt((m + rho Ca pi D²/4 T)/k).
TEST(Hulls, SurgeOfASparWithMembers) {
  const double mass = kRho * M_PI * 9 * 40;
  const double k = 2e5;
  const double T = 2 * M_PI * std::sqrt((mass + 0.8 * mass) / k);
  const model::Case c = read(fmt::format(
      R"(hawser: 1
environment: {{gravity: 9.80665, water: {{density: 1000, depth: 200}}}}
bodies:
  spar:
    position: [0, 0, 0]
    floating:
      mass: {}
      inertia: [1e9, 1e9, 1e9]
      centre_of_mass: [0, 0, -30]
      velocity: [0.01, 0, 0]
      stiffness: [{}, 0, 0]
      turning_stiffness: [1e13, 1e13, 1e13]
      hull: {{volumes: [column]}}
      members: [{{from: [0, 0, -40], to: [0, 0, 12], diameter: 6, Cd: 0, Ca: 0.8}}]
volumes:
  column: {{shape: {{cylinder: {{from: [0, 0, -40], to: [0, 0, 12], radius: 3}}}}, body: spar}}
dynamics: {{duration: {}, step: {}, rho_infinity: 1}}
)",
      mass, k, 3.2 * T, T / 300));
  Simulation s = simulation(c);
  const double found = period_from_rest(s, [](const Kinematics& state, size_t n) { return state.x[n].x(); });
  printf("spar with members: surge %.4f s, closed form %.4f s\n", found, T);
  EXPECT_NEAR(found, T, 2e-3 * T);
}

// A barge with members and hull, moored by two lines, in waves of several periods.
std::string moored() {
  return barge(
      fmt::format(
          "position: [0, 0, 1.6], floating: {{mass: {}, inertia: [4e6, 2e7, 2e7], centre_of_mass: [0, "
          "0.1, -2], hull: {{volumes: [side]}}, members: [{{from: [-10, 0, -3], to: [10, 0, -3], "
          "diameter: 8, Cd: 1, Ca: 0.6, axial_Cd: 1, axial_Ca: 0.3}}]}}",
          kMass),
      ", waves: {components: [{height: 1.4, period: 5, direction_deg: 30}, {height: 1, period: 8}], "
      "ramp: "
      "4}, current: {profile: [{depth: 0, speed: 0.4}, {depth: 200, speed: 0.1}]}",
      R"(line_types: {rope: {outer_diameter: 0.1, mass_per_length: 5, EA: 4e6, bending: false}}
lines:
  west: {sections: [{type: rope, length: 99, elements: 6}], end_a: {anchor: [-110, 0, 0]}, end_b: {body: barge, at: [-10, 0, 2.5]}}
  east: {sections: [{type: rope, length: 99, elements: 6}], end_a: {anchor: [110, 10, 0]}, end_b: {body: barge, at: [10, 0, 2.5]}}
dynamics: {duration: 20}
output: {every: 1, histories: [{body: barge}]}
)");
}

// The energy balance closes within 1 % over 20 s.
TEST(Hulls, EnergyInWaves) {
  const model::Case c = read(moored());
  Simulation s = simulation(c);
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto [stored, brought] = balance(s, PETSC_COMM_WORLD);
  double moved = 0;
  Vec3 end = Vec3::Zero();
  double before = stored;
  integrate(d, c.dynamics.duration, c.dynamics.duration, [&](const StepInfo&) {
    const double now = balance(s, PETSC_COMM_WORLD).stored;
    moved += std::abs(now - before);
    before = now;
    for (int k = 0; k < 3; ++k)
      end[k] = from_owner(s, [&](size_t n) { return d.committed_kinematics().x[n][k]; });
  });
  const auto [left, all] = balance(s, PETSC_COMM_WORLD);
  const double unexplained = left - stored - (all - brought);
  printf("barge in waves: %.0f J of %.0f J moved not explained; it ends at %.9f, %.9f, %.9f m\n", unexplained,
         moved, end.x(), end.y(), end.z());
  EXPECT_LT(std::abs(unexplained), 0.01 * moved);
  EXPECT_GT(moved, 1e5);
}

// A restart from a checkpoint in the middle of the run continues the same motion, on 1 and 2 ranks.
TEST(Hulls, GoesOnAfterARestart) {
  const std::string base = runs::folder("hulls") + "/";
  const std::string input = base + "case.yaml";
  runs::write_case(input, moored(), {{"duration: 20", "duration: 12, step: 0.1"}});
  runs::run_on_all({input, base + "whole.h5"});
  runs::run_on_all({input, base + "half.h5", "", 7});
  runs::run_on_all({input, base + "rest.h5", base + "half.h5"});
  if (runs::rank_of(MPI_COMM_WORLD) != 0) return;
  const runs::Results whole = runs::read(base + "whole.h5");
  const runs::Results rest = runs::read(base + "rest.h5");
  for (const char* series : {"barge", "energy"}) {
    const auto& all = whole.series.at(series);
    const auto& end = rest.series.at(series);
    const double off = runs::largest_difference(runs::tail(all, end), end);
    printf("restart: %s off by %.1e of %.1e\n", series, off, runs::largest(end));
    EXPECT_LT(off, 1e-11 * runs::largest(end)) << series;
  }
}

}  // namespace
}  // namespace hawser::test::hulls
