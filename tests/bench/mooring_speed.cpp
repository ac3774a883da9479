// What a second of a mooring line costs: a studless chain in 200 m of water, its fairlead surging 2 m every
// 10 s, in CPU time and in numeric LU factorisations of the same chain (one 3-block a node, natural order),
// so that it can be compared across machines. Errors are of the fairlead's extremes over 20 s to 100 s
// against converged ones, over the largest tension.
#include <benchmark/benchmark.h>
#include <petscmat.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "hawser/app/simulation.hpp"

namespace hawser {
namespace {

constexpr double kLeast = 1809.80e3, kMost = 2352.10e3;  // N, converged in element and step

model::Case chains(int segments, int lines, double step) {
  model::Case c;
  model::LineType t;
  t.name = "chain";
  t.kind = model::LineKind::cable;
  t.outer_diameter = 0.252, t.contact_diameter = 1e-9, t.mass_per_length = 390, t.EA = 1.674e9;
  t.Cd_normal = 1.37, t.Cd_axial = 0.64;
  t.stiffness_damping = 760.0 / segments * std::sqrt(t.mass_per_length / t.EA);
  c.line_types.push_back(t);
  c.environment.water.present = true, c.environment.water.depth = 200;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true, bed.depth = 200;
  bed.basis = model::StiffnessBasis::per_length, bed.normal_stiffness = 25200;
  model::Body b;
  b.name = "vessel";
  model::HarmonicMotion m;
  m.amplitude = Vec3(2, 0, 0), m.period = 10;
  b.motion = m, b.ramp = 10;
  c.bodies.push_back(b);
  for (int i = 0; i < lines; ++i) {
    model::Line l;
    l.name = "chain " + std::to_string(i);
    l.sections.push_back({t.name, 760, segments, 1});
    l.end_a.kind = model::EndKind::anchor, l.end_a.at = Vec3(700, 50 * i, -200);
    l.end_b.kind = model::EndKind::body, l.end_b.body = "vessel", l.end_b.at = Vec3(0, 50 * i, 0);
    c.lines.push_back(l);
  }
  c.contact.between_lines.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 100, c.dynamics.step = step;
  c.dynamics.tolerance = 1e-4;
  return c;
}

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// s, of one numeric factorisation.
double factorisation(System& system, const State& s) {
  MatHandle J = system.create_matrix();
  Weights w;
  w.M = 400;
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  system.tangent(s.view(0), w, zero, false, J.get());
  IS rows = nullptr, columns = nullptr;
  check(MatGetOrdering(J.get(), MATORDERINGNATURAL, &rows, &columns));
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info));
  Mat F = nullptr;
  check(MatGetFactor(J.get(), MATSOLVERPETSC, MAT_FACTOR_LU, &F));
  check(MatLUFactorSymbolic(F, J.get(), rows, columns, &info));
  double best = 1e9;
  for (int batch = 0; batch < 20; ++batch) {
    const int n = 200;
    const double from = cpu();
    for (int i = 0; i < n; ++i) check(MatLUFactorNumeric(F, J.get(), &info));
    best = std::min(best, (cpu() - from) / n);
  }
  check(MatDestroy(&F));
  check(ISDestroy(&rows));
  check(ISDestroy(&columns));
  return best;
}

void chain(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0)), lines = static_cast<int>(state.range(1));
  const double step = 1e-3 * static_cast<double>(state.range(2));
  const model::Case c = chains(segments, lines, step);
  for (auto _ : state) {
    app::Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    const double one = factorisation(sim.system(), sim.state());
    sim.dynamics().start(sim.state());
    double least = 1e99, most = 0, iterations = 0, steps = 0;
    const size_t end = 3 * static_cast<size_t>(sim.local().block[static_cast<size_t>(segments)]);
    const double from = cpu();
    sim.dynamics().run(
        100, [](double) { return 100.0; },
        [&](const StepInfo& info) {
          iterations += info.iterations, ++steps;
          if (info.time < 20) return true;
          const auto& r = sim.dynamics().reactions();
          const double T = Vec3(r[end], r[end + 1], r[end + 2]).norm();
          least = std::min(least, T), most = std::max(most, T);
          return true;
        });
    const double used = (cpu() - from) / 100;  // s a second
    state.SetIterationTime(used * 100);
    state.counters["ms_per_s"] = 1e3 * used;
    state.counters["factorisations"] = used / one;
    state.counters["factorisation_us"] = 1e6 * one;
    state.counters["us_a_step"] = 1e6 * used * 100 / steps;
    state.counters["iterations"] = iterations / steps;
    state.counters["least_error_%"] = 100 * (least - kLeast) / kMost;
    state.counters["most_error_%"] = 100 * (most - kMost) / kMost;
  }
}

BENCHMARK(chain)
    ->ArgNames({"segments", "lines", "step_ms"})
    ->ArgsProduct({{20, 50, 100, 200}, {1}, {50, 100, 200, 250, 400, 500}})
    ->Args({50, 100, 200})
    ->Args({50, 100, 400})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hawser

int main(int argc, char** argv) {
  PetscInitialize(&argc, &argv, nullptr, nullptr);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  PetscFinalize();
}
