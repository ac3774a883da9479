// Rigid bodies in water against closed forms: natural periods, terminal velocity, draught, wave forces; and
// the energy balance of a load that is lowered through the surface.
#include <fmt/format.h>

#include "../regression/runs.hpp"
#include "hawser/io/case_reader.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::bodies_in_water {
namespace {

constexpr double kG = 9.80665;

// Water of 1000 kg/m³ with the keys `sea`, a body called load, and a nearly weightless line.
std::string text(const std::string& sea, const std::string& body, const std::string& line,
                 const std::string& rest) {
  std::string text =
      "hawser: 1\nenvironment: {gravity: 9.80665, water: {density: 1000, depth: 200" + sea + "}}\n";
  text += "bodies:\n  load: {" + body + "}\n";
  if (!line.empty())
    text +=
        "line_types: {rope: {outer_diameter: 1e-4, mass_per_length: 1e-4, EA: 5e6, bending: false, "
        "Cd_normal: 0, Ca_normal: 0}}\nlines:\n  rope: {" +
        line + "}\n";
  return text + rest + "\n";
}

model::Case load(const std::string& sea, const std::string& body, const std::string& line,
                 const std::string& rest) {
  return io::read_case_text(text(sea, body, line, rest), testing::TempDir() + "in_water.yaml");
}

double swing(const model::Case& c, int axis) {
  Simulation s(PETSC_COMM_WORLD, c);
  return period_from_rest(s, [axis](const Kinematics& state, size_t n) { return state.x[n][axis]; });
}

// A submerged sphere on a line of stiffness k = EA/L: T = 2 pi sqrt((m + Ca rho V)/k).
TEST(BodiesInWater, SphereHeavesOnALine) {
  const double k = 5e6 / 50;
  const double T = 2 * M_PI * std::sqrt((2000 + 0.5 * 1000) / k);
  const model::Case c =
      load("",
           "position: [0, 0, -50.1], floating: {mass: 2000, inertia: [300, 300, 300], weight: true, "
           "velocity: [0, 0, 0.05], in_water: {volume: 1, height: 1.24, Ca: [0.5, 0.5, 0.5]}}",
           "sections: [{type: rope, length: 50, elements: 1}], end_a: {anchor: [0, 0, 0]}, "
           "end_b: {body: load, at: [0, 0, 0]}",
           fmt::format("dynamics: {{duration: {}, step: {}, rho_infinity: 1}}", 5 * T, T / 400));
  const double found = swing(c, 2);
  printf("sphere on a line: %.6f s, closed form %.6f s (%+.4f %%)\n", found, T, 100 * (found / T - 1));
  EXPECT_NEAR(found, T, 1e-3 * T);
}

// A submerged load on a line is a pendulum: T = 2 pi sqrt((m + Ca rho V) L/((m - rho V) g)).
TEST(BodiesInWater, LoadSwingsBelowItsHook) {
  // Length of the line stretched by its load, EA 5 MN.
  const double L = 20 * (1 + 3000 * kG / 5e6);
  const double T = 2 * M_PI * std::sqrt((5000 + 1.2 * 2000) * L / ((5000 - 2000) * kG));
  const model::Case c =
      load("",
           "position: [0, 0, -30], floating: {mass: 5000, inertia: [3000, 3000, 3000], weight: true, "
           "velocity: [0.05, 0, 0], in_water: {volume: 2, height: 2, added_mass: [2400, 2400, 9000]}}",
           "sections: [{type: rope, length: 20, elements: 1}], end_a: {anchor: [0, 0, -10]}, "
           "end_b: {body: load, at: [0, 0, 0]}",
           fmt::format("dynamics: {{duration: {}, step: {}, rho_infinity: 1}}", 5 * T, T / 400));
  const double found = swing(c, 0);
  printf("load under water on its hook: %.5f s, closed form %.5f s (%+.4f %%)\n", found, T,
         100 * (found / T - 1));
  EXPECT_NEAR(found, T, 1e-3 * T);
}

// Heave of a floating body with automatic steps: T = 2 pi sqrt((m + A) H/(rho g V)). The time integration
// adds at most 0.1 %.
TEST(BodiesInWater, HeavesWithAutomaticSteps) {
  const double T = 2 * M_PI * std::sqrt(7000.0 * 3 / (1000 * kG * 12));
  model::Case c = load("",
                       "position: [0, 0, 0], floating: {mass: 7000, inertia: [9000, 12000, 11000], "
                       "centre_of_mass: [0, 0, -0.4], weight: true, velocity: [0, 0, 0.2], "
                       "in_water: {volume: 12, height: 3}}",
                       "", fmt::format("dynamics: {{duration: {}}}\noutput: {{every: {}}}", 20 * T, 20 * T));
  const double found = swing(c, 2);
  printf("heave by automatic steps: %.5f s, closed form %.5f s (%+.4f %%)\n", found, T,
         100 * (found / T - 1));
  EXPECT_NEAR(found, T, 1.2e-3 * T);
}

// A body with in_water has no stiffness of a waterplane against tilting. Statics warns about a floating body
// without turning_stiffness, but not about one with it or about a submerged one.
TEST(BodiesInWater, WhatFloatsWithoutAWaterplaneIsNamed) {
  const auto named = [](double mass, const std::string& more) {
    const model::Case c =
        load("",
             fmt::format("position: [0, 0, -10], floating: {{mass: {}, inertia: [9000, 12000, "
                         "11000], centre_of_mass: [0, 0, -0.4], weight: true, in_water: "
                         "{{volume: 12, height: 3}}{}}}",
                         mass, more),
             mass > 12000 ? "sections: [{type: rope, length: 20, elements: 1}], end_a: "
                            "{anchor: [0, 0, 10]}, end_b: {body: load, at: [0, 0, 0]}"
                          : "",
             "dynamics: {duration: 1}");
    Simulation s(PETSC_COMM_WORLD, c);
    s.solve_statics();
    return s.tilting_warnings();
  };
  ASSERT_EQ(named(7000, "").size(), 1U);
  EXPECT_NE(named(7000, "").front().find("bodies.load: it floats at the surface"), std::string::npos);
  EXPECT_TRUE(named(7000, ", turning_stiffness: [2e5, 2e5, 0]").empty());
  EXPECT_TRUE(named(13000, "").empty());
}

// A body sinks at the speed where drag equals its weight in water: v = sqrt(2 (m g - rho g V)/(rho Cd A)).
TEST(BodiesInWater, TerminalVelocity) {
  const model::Case c =
      load("",
           "position: [0, 0, -5], rotation_deg: [0, 90, 0], floating: {mass: 2000, inertia: [300, 300, 300], "
           "weight: true, in_water: {volume: 1, height: 1, drag_area: [2, 3, 5], Cd: [1.6, 1, 1], "
           "Ca: [1, 0.5, 0.5]}}",
           "", "statics: false\ndynamics: {duration: 6, step: 0.01}");
  Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  integrate(d, 6, 6, [](const StepInfo&) {});
  const double found = -from_owner(s, [&](size_t n) { return d.committed_kinematics().v[n].z(); });
  const double v = std::sqrt(2 * (2000 - 1000) * kG / (1000 * 1.6 * 2));
  printf("falling body: %.6f m/s, closed form %.6f m/s (%+.4f %%)\n", found, v, 100 * (found / v - 1));
  EXPECT_NEAR(found, v, 1e-3 * v);
}

// A body of 100 kg that displaces 50 kg, with an added mass of 500 or 5000 kg, sinks by z = v²/a0 ln cosh(a0
// t/v). An added mass of 5 and 50 times the mass, treated as a force, stays stable with steps of 0.05 to 1 s.
TEST(BodiesInWater, LightBodyWithMuchAddedMassSinks) {
  for (const auto& [added, step, tolerance] : {std::tuple(500.0, 0.1, 1e-3),
                                               {500.0, 0.05, 2.5e-4},
                                               {500.0, 1.0, 0.05},
                                               {5000.0, 0.1, 1e-3},
                                               {5000.0, 1.0, 0.05}}) {
    const model::Case c =
        load("",
             fmt::format("position: [0, 0, -20], floating: {{mass: 100, inertia: [50, 50, 50], weight: true, "
                         "in_water: {{volume: 0.05, height: 0.3, drag_area: [0.2, 0.2, 0.2], "
                         "added_mass: [{0}, {0}, {0}]}}}}",
                         added),
             "", fmt::format("statics: false\ndynamics: {{duration: 10, step: {}}}", step));
    Simulation s(PETSC_COMM_WORLD, c);
    Dynamics& d = s.dynamics();
    d.start(s.state());
    const double a0 = 50 * kG / (100 + added);
    const double v = std::sqrt(2 * 50 * kG / (1000 * 0.2));
    double worst = 0;
    integrate(d, 10, 1, [&](const StepInfo& i) {
      const double sunk = -20 - from_owner(s, [&](size_t n) { return d.committed_kinematics().x[n].z(); });
      const double exact = v * v / a0 * std::log(std::cosh(a0 * i.time / v));
      if (i.time > 0.99) worst = std::max(worst, std::abs(sunk / exact - 1));
    });
    printf("light body, added mass %g kg, steps of %g s: off by %.1e\n", added, step, worst);
    EXPECT_LT(worst, tolerance);
  }
}

// Draught of a box: its wet fraction is mass over (density of water times volume). Statics starts with the
// box above the water and tilted.
TEST(BodiesInWater, BoxFindsItsDraught) {
  const model::Case c = load("",
                             "position: [3, 2, 1.2], rotation_deg: [8, -5, 20], floating: {mass: 7000, "
                             "inertia: [9000, 12000, 11000], centre_of_mass: [0, 0, -0.4], weight: true, "
                             "in_water: {volume: 12, height: 3, drag_area: [6, 6, 4]}}",
                             "", "dynamics: {duration: 1}");
  Simulation s(PETSC_COMM_WORLD, c);
  const StaticsReport report = s.solve_statics();
  const double draught = 3 * 7000.0 / 12000;
  const double z =
      from_owner(s, [&](size_t n) { return (s.state().x[n] - s.state().q[n] * Vec3(0, 0, -0.4)).z(); });
  const double upright = from_owner(s, [&](size_t n) { return (s.state().q[n] * Vec3::UnitZ()).z(); });
  printf("box: draught %.8f m, by its mass %.8f m, upright to %.1e, %d iterations\n", 1.5 - z, draught,
         1 - upright, report.iterations);
  EXPECT_NEAR(1.5 - z, draught, 1e-7);
  EXPECT_NEAR(upright, 1, 1e-9);
}

// A half submerged body on a hoist line in a current: the line carries the weight less the buoyancy of the
// wet part, and the drag.
TEST(BodiesInWater, HangsHalfWet) {
  const model::Case c =
      load("}, current: {speed: 1.2",
           "position: [0, 0, -0.3], floating: {mass: 20000, inertia: [30000, 30000, 30000], weight: true, "
           "in_water: {volume: 6, height: 3, drag_area: [12, 12, 10], Cd: [1.1, 1.1, 1.1]}}",
           "sections: [{type: rope, length: 30, elements: 3}], end_a: {anchor: [0, 0, 30.7]}, "
           "end_b: {body: load, at: [0, 0, 0]}",
           "dynamics: {duration: 1}");
  Simulation s(PETSC_COMM_WORLD, c);
  const StaticsReport report = s.solve_statics();
  const double x = from_owner(s, [&](size_t n) { return s.state().x[n].x(); });
  const double z = from_owner(s, [&](size_t n) { return s.state().x[n].z(); });
  const double wet = 0.5 - z / 3;
  const double drag = 0.5 * 1000 * 1.1 * 12 * 1.2 * 1.2 * wet;
  const double tension = std::hypot((20000 - 6000 * wet) * kG, drag);
  const double length = std::hypot(30.7 - z, x);
  printf(
      "half wet on its hoist: %.3f wet, line %.5f m (its tension's %.5f m), %.5f m aside (%.5f m), %d "
      "iterations\n",
      wet, length, 30 * (1 + tension / 5e6), x, length * drag / tension, report.iterations);
  EXPECT_GT(wet, 0.3);
  EXPECT_LT(wet, 0.7);
  EXPECT_NEAR(length, 30 * (1 + tension / 5e6), 1e-5 * length);
  EXPECT_NEAR(x, length * drag / tension, 1e-4 * x);
}

// Amplitude of the force on a held body in a regular wave, rho V (1 + Ca) a_w e^(kz), with Ca of each axis;
// the horizontal and the vertical force are a quarter of a period apart.
TEST(BodiesInWater, HeldInARegularWave) {
  const model::Case c = load("}, waves: {regular: {height: 2, period: 8}, stretching: none, ramp: 0",
                             "position: [0, 0, -12], floating: {mass: 5000, inertia: [3000, 3000, 3000], "
                             "weight: true, in_water: {volume: 3, height: 2, Ca: [0.6, 0.8, 1.7]}}",
                             "", "statics: false\ndynamics: {duration: 10}");
  Simulation s(PETSC_COMM_WORLD, c);
  const double omega = 2 * M_PI / 8;
  const double k = omega * omega / kG;
  const double across = 3000 * 1.6 * omega * omega * std::exp(-12 * k);
  const double along = 3000 * 2.7 * omega * omega * std::exp(-12 * k);
  Vec3 most = Vec3::Zero();
  State& state = s.state();
  for (int i = 0; i < 90; ++i) {
    state.time = 8.0 * i / 90;
    s.system().prepare(state.after_step(0.1), 0.1);
    VecHandle r = s.system().create_vector();
    s.system().residual(state.after_step(0.1), r.get());
    const PetscScalar* p = nullptr;
    check(VecGetArrayRead(r.get(), &p));
    for (int axis = 0; axis < 3; ++axis) {
      const double f = -from_owner(s, [&](size_t n) { return p[3 * s.local().block[n] + axis]; });
      most[axis] = std::max(most[axis], std::abs(f + (axis == 2 ? 2000 * kG : 0)));
    }
    check(VecRestoreArrayRead(r.get(), &p));
  }
  printf("in a regular wave: %.3f N across, %.3f N upwards (closed form %+.4f, %+.4f %%), %.1e N beside\n",
         most.x(), most.z(), 100 * (most.x() / across - 1), 100 * (most.z() / along - 1), most.y());
  EXPECT_NEAR(most.x(), across, 5e-3 * across);
  EXPECT_NEAR(most.z(), along, 5e-3 * along);
  EXPECT_LT(most.y(), 1e-6 * across);
}

// J: error of the energy balance, and energy exchanged; m: lowest and last position of the load.
struct Lowered {
  double unexplained = 0, turnover = 0, least = 1e300;
  Vec3 place = Vec3::Zero();
};
Lowered lower(MPI_Comm comm, const model::Case& c) {
  Simulation s(comm, c);
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto [stored, brought] = balance(s, comm);
  Lowered out;
  integrate(d, c.dynamics.duration, c.dynamics.duration, [&](const StepInfo&) {
    const int n = s.local().find(s.mesh().body_node(0));
    Vec3 x = n >= 0 && n < s.local().owned ? Vec3(d.committed_kinematics().x[static_cast<size_t>(n)])
                                           : Vec3::Zero();
    MPI_Allreduce(MPI_IN_PLACE, x.data(), 3, MPI_DOUBLE, MPI_SUM, comm);
    out.place = x;
    out.least = std::min(out.least, x.z());
  });
  const auto [left, all] = balance(s, comm);
  out.unexplained = left - stored - (all - brought);
  out.turnover = std::abs(stored - left) + std::abs(all);
  return out;
}

// A crane tip lowers the load by 12 m through waves of 2 m. The centres of buoyancy and drag are not the
// centre of mass.
std::string lowered() {
  return text(
      "}, waves: {regular: {height: 2, period: 7, direction_deg: 20}}, current: {profile: [{depth: 0, speed: "
      "0.4}, {depth: 200, speed: 0.2}]",
      "position: [0, 0, 6], floating: {mass: 30000, inertia: [6e4, 9e4, 8e4], centre_of_mass: [0.1, 0, "
      "-0.3], weight: true, in_water: {volume: 9, height: 3, centre_of_buoyancy: [0.05, 0.1, 0.1], "
      "drag_area: [12, 24, 32], Cd: [1.2, 1.2, 1.5], centre_of_drag: [0, 0.2, 0.3], Ca: [0.5, 0.8, 2]}}}\n  "
      "tip: {position: [0, 0, 37.5], motion: {table: {rows: [[0, 0, 0, 0], [2, 0, 0, 0], [32, 0, 0, -12], "
      "[40, 0, 0, -12]], interpolation: monotone}}",
      "sections: [{type: rope, length: 30, elements: 6}], end_a: {body: tip, at: [0, 0, 0]}, "
      "end_b: {body: load, at: [0, 0, 1.5]}",
      "dynamics: {duration: 40}\noutput: {every: 1, histories: [{body: load}]}");
}

TEST(BodiesInWater, LoweredThroughTheWaves) {
  const model::Case c = io::read_case_text(lowered(), testing::TempDir() + "in_water.yaml");
  const Lowered all = lower(PETSC_COMM_WORLD, c);
  const Lowered one = lower(PETSC_COMM_SELF, c);
  printf("lowered through the waves to %.3f m: %.1f J of %.0f J not explained, ranks apart by %.1e m\n",
         all.least, all.unexplained, all.turnover, (all.place - one.place).norm());
  EXPECT_LT(std::abs(all.unexplained), 0.01 * all.turnover);
  EXPECT_LT(all.least, -5);
  EXPECT_LT((all.place - one.place).norm(), 1e-6);
}

// A restart while the load is in the wave zone continues exactly: the checkpoint has the last position at
// which the wave kinematics were evaluated.
TEST(BodiesInWater, GoesOnAfterARestart) {
  const std::string base = runs::folder("bodies_in_water") + "/";
  const std::string input = base + "case.yaml";
  runs::write_case(input, lowered(), {{"duration: 40", "duration: 26"}});
  runs::run_on_all({input, base + "whole.h5"});
  runs::run_on_all({input, base + "half.h5", "", 20});
  runs::run_on_all({input, base + "rest.h5", base + "half.h5"});
  if (runs::rank_of(MPI_COMM_WORLD) != 0) return;
  const runs::Results whole = runs::read(base + "whole.h5");
  const runs::Results rest = runs::read(base + "rest.h5");
  for (const char* series : {"load", "energy"}) {
    const auto& all = whole.series.at(series);
    const auto& end = rest.series.at(series);
    const double off = runs::largest_difference(runs::tail(all, end), end);
    printf("restart: %s off by %.1e of %.1e\n", series, off, runs::largest(end));
    EXPECT_LT(off, 1e-12 * runs::largest(end)) << series;
  }
}

}  // namespace
}  // namespace hawser::test::bodies_in_water
