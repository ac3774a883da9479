// What a second of a mooring line or a riser costs: a studless chain ("chain") and a pipe of beams ("riser")
// in 200 m of water, the upper end surging 2 m every 10 s, in CPU time and in numeric LU factorisations of
// the same chain (3-blocks, one a node of a cable, two of a beam, natural order), so that it can be compared
// across machines. Errors are of the upper end's extremes over 20 s to 100 s against converged ones, over the
// largest tension. Newton's tolerance: 10 to the power of minus `digits`; 8 is the default of a case.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <petscmat.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "hawser/app/simulation.hpp"

namespace hawser {
namespace {

// N, converged in element and step.
struct Extremes {
  double least, most, anchor_least, anchor_most;
};
constexpr Extremes kChain = {1809.80e3, 2352.10e3, 1194.62e3, 1642.79e3};
constexpr Extremes kRiser = {63.41e3, 70.16e3, 12.97e3, 16.90e3};

// Water, bed, vessel and what is asked of dynamics.
model::Case surging(double step, int digits) {
  model::Case c;
  c.environment.water.present = true, c.environment.water.depth = 200;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true, bed.depth = 200, bed.basis = model::StiffnessBasis::per_length;
  model::Body b;
  b.name = "vessel";
  model::HarmonicMotion m;
  m.amplitude = Vec3(2, 0, 0), m.period = 10;
  b.motion = m, b.ramp = 10;
  c.bodies.push_back(b);
  c.contact.between_lines.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 100, c.dynamics.step = step;
  c.dynamics.tolerance = std::pow(10, -digits);
  return c;
}

model::Line hung(const std::string& type, double length, int segments, const Vec3& anchor,
                 const Vec3& hang_off) {
  model::Line l;
  l.name = "line";
  l.sections.push_back({type, length, segments, 1});
  l.end_a.kind = model::EndKind::anchor, l.end_a.at = anchor;
  l.end_b.kind = model::EndKind::body, l.end_b.body = "vessel", l.end_b.at = hang_off;
  return l;
}

// Bed of 100 kN/m³ on the diameter, without friction; damping of a ratio of 1 a segment.
model::Case chains(int segments, int lines, double step, int digits) {
  model::Case c = surging(step, digits);
  model::LineType t;
  t.name = "chain";
  t.kind = model::LineKind::cable;
  t.outer_diameter = 0.252, t.contact_diameter = 1e-9, t.mass_per_length = 390, t.EA = 1.674e9;
  t.Cd_normal = 1.37, t.Cd_axial = 0.64;
  t.stiffness_damping = 760.0 / segments * std::sqrt(t.mass_per_length / t.EA);
  c.line_types.push_back(t);
  c.environment.seabed.normal_stiffness = 25200;
  for (int i = 0; i < lines; ++i) {
    c.lines.push_back(hung(t.name, 760, segments, Vec3(700, 50 * i, -200), Vec3(0, 50 * i, 0)));
    c.lines.back().name = fmt::format("{} {}", t.name, i);
  }
  return c;
}

// Beams pinned at both ends; no damping but the water's.
model::Case riser(int segments, double step, int digits) {
  model::Case c = surging(step, digits);
  model::LineType t;
  t.name = "pipe";
  t.outer_diameter = 0.2, t.contact_diameter = 1e-9, t.mass_per_length = 60;
  t.EA = 5e8, t.EI2 = t.EI3 = t.GJ = 5e4;
  t.rotary_inertia = Vec3(0.6, 0.3, 0.3);
  t.Cd_normal = 1.2, t.Cd_axial = 0.05;
  c.line_types.push_back(t);
  c.environment.seabed.normal_stiffness = 2e4;
  c.lines.push_back(hung(t.name, 420, segments, Vec3(300, 0, -200), Vec3(0, 0, -10)));
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

void measure(benchmark::State& state, const model::Case& c, const Extremes& exact) {
  const size_t segments = static_cast<size_t>(c.lines[0].sections[0].elements);
  for (auto _ : state) {
    app::Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    const double one = factorisation(sim.system(), sim.state());
    sim.dynamics().start(sim.state());
    Extremes seen = {1e99, 0, 1e99, 0};
    double iterations = 0, steps = 0;
    const size_t end = 3 * static_cast<size_t>(sim.local().block[segments]);
    const double from = cpu();
    sim.dynamics().run(
        100, [](double) { return 100.0; },
        [&](const StepInfo& info) {
          iterations += info.iterations, ++steps;
          if (info.time < 20) return true;
          const auto& r = sim.dynamics().reactions();
          const double T = Vec3(r[end], r[end + 1], r[end + 2]).norm(), A = Vec3(r[0], r[1], r[2]).norm();
          seen.least = std::min(seen.least, T), seen.most = std::max(seen.most, T);
          seen.anchor_least = std::min(seen.anchor_least, A),
          seen.anchor_most = std::max(seen.anchor_most, A);
          return true;
        });
    const double used = (cpu() - from) / 100;  // s a second
    const auto percent = [&](double a, double b) { return 100 * (a - b) / exact.most; };
    state.SetIterationTime(used * 100);
    state.counters["ms_per_s"] = 1e3 * used;
    state.counters["factorisations"] = used / one;
    state.counters["factorisation_us"] = 1e6 * one;
    state.counters["us_a_step"] = 1e6 * used * 100 / steps;
    state.counters["iterations"] = iterations / steps;
    state.counters["least_error_%"] = percent(seen.least, exact.least);
    state.counters["most_error_%"] = percent(seen.most, exact.most);
    state.counters["anchor_least_%"] = percent(seen.anchor_least, exact.anchor_least);
    state.counters["anchor_most_%"] = percent(seen.anchor_most, exact.anchor_most);
  }
}

double seconds(std::int64_t ms) { return 1e-3 * static_cast<double>(ms); }

void chain(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0)), lines = static_cast<int>(state.range(1));
  measure(state, chains(segments, lines, seconds(state.range(2)), static_cast<int>(state.range(3))), kChain);
}

void riser(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0)), digits = static_cast<int>(state.range(2));
  measure(state, riser(segments, seconds(state.range(1)), digits), kRiser);
}

BENCHMARK(chain)
    ->ArgNames({"segments", "lines", "step_ms", "digits"})
    ->ArgsProduct({{20, 50, 100, 200}, {1}, {50, 100, 200, 250, 400, 500}, {4, 8}})
    ->ArgsProduct({{50}, {100}, {200, 400}, {4, 8}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(riser)
    ->ArgNames({"segments", "step_ms", "digits"})
    ->ArgsProduct({{42, 105, 420}, {50, 100, 200, 250, 400, 500}, {4, 8}})
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
