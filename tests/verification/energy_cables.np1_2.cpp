// Energy of free lines of cables that start slack with random velocities and snap taut and slacken all the
// time (theory, "Cables").
#include <random>

#include "support/rig.hpp"

namespace hawser::test::energy_cables_test {
namespace {

// A chain of 40 m and 3.2 t without gravity, its elements vibrate with a period of 1.2 ms; every node has a
// random velocity.
struct Flight {
  double start = 0, end = 0;   // J
  double most = 0, least = 1;  // of the start, over all steps
  double momentum = 0;         // change over its size
};

Flight fly(double rho, double step, double duration) {
  model::LineType type = cable_type(1e8, 80);
  model::Case c = one_line(type, 40, 40, {}, {});
  c.lines[0].end_a.kind = c.lines[0].end_b.kind = model::EndKind::free;
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {Vec3(0, 0, 0), Vec3(20, 15, 0), Vec3(22, 0.5, 3)};
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = duration;
  c.dynamics.step = step;
  c.dynamics.resolve_impacts = false;
  c.dynamics.rho_infinity = rho;
  c.dynamics.tolerance = 1e-11;
  c.contact.between_lines.enabled = false;
  Simulation sim(MPI_COMM_WORLD, c);
  State s = sim.state();
  // The polyline is a little shorter than the line: the chain starts slack.
  for (size_t n = 0; n < s.x.size(); ++n) {
    std::mt19937 random(static_cast<unsigned>(sim.local().global[n]) + 7);
    std::uniform_real_distribution<double> u(-1, 1);
    s.v[n] = Vec3(2 + 3 * u(random), 3 * u(random), 3 * u(random));
  }
  const auto total = [&](double value) {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return value;
  };
  const auto energy = [&](const Kinematics& state) {
    const Energy e = sim.system().energy(state);
    return total(e.kinetic + e.strain);
  };
  const auto momentum = [&](const Kinematics& state) {
    double p = 0;  // equal elements: inner nodes carry one mass, ends a half
    for (const LocalElement& e : sim.local().elements)
      if (e.counted)
        p +=
            80.0 * 0.5 * (state.v[static_cast<size_t>(e.first)] + state.v[static_cast<size_t>(e.second)]).x();
    return total(p);
  };
  Flight f;
  sim.dynamics().start(s);
  f.start = energy(sim.dynamics().committed_kinematics());
  const double p0 = momentum(sim.dynamics().committed_kinematics());
  sim.dynamics().run(
      duration, [&](double) { return duration; },
      [&](const StepInfo&) {
        const double now = energy(sim.dynamics().committed_kinematics()) / f.start;
        f.most = std::max(f.most, now);
        f.least = std::min(f.least, now);
        return true;
      });
  f.end = energy(sim.dynamics().committed_kinematics());
  f.momentum = std::abs(momentum(sim.dynamics().committed_kinematics()) - p0) / std::abs(p0);
  return f;
}

// Without numerical damping energy is constant within Newton's tolerance, also at steps that do not resolve
// the vibration.
TEST(EnergyOfCables, IsKeptWithoutDamping) {
  for (const double step : {0.02, 0.005, 0.001}) {
    const Flight f = fly(1, step, 100 * step);
    printf("  rho 1, %g s: between 1 - %.1e and 1 + %.1e of the start, momentum %.1e\n", step, 1 - f.least,
           f.most - 1, f.momentum);
    EXPECT_LT(f.most - 1, 1e-6) << step;
    EXPECT_GT(f.least - 1, -1e-6) << step;
    EXPECT_LT(f.momentum, 1e-9);
  }
}

// With numerical damping the energy falls; it exceeds its initial value by at most the fraction delta², delta
// = (1 - rho)/(2 (1 + rho)).
TEST(EnergyOfCables, FallsWithDamping) {
  for (const double rho : {0.8, 0.4, 0.0})
    for (const double step : {0.1, 0.02, 0.005}) {
      const Flight f = fly(rho, step, 2);
      printf("  rho %g, %g s: %.3f of it left, at most 1 + %.1e, momentum %.1e\n", rho, step, f.end / f.start,
             f.most - 1, f.momentum);
      const double delta = (1 - rho) / (2 * (1 + rho));
      EXPECT_LT(f.most - 1, delta * delta) << rho << " " << step;
      EXPECT_LT(f.end, f.start);
      EXPECT_LT(f.momentum, 1e-9);
    }
}

}  // namespace
}  // namespace hawser::test::energy_cables_test
