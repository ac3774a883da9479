// Cost of a Newton iteration (residual, tangent, factor, solve, and the trial state they need) per node,
// against the bare numeric LU of the same chain in PETSc's BAIJ, block 3, natural order, measured in the same
// run. Counters: newton_us and lu_us a node, ratio of the two (least CPU times of interleaved repetitions).
#include <benchmark/benchmark.h>
#include <petscksp.h>

#include <algorithm>

#include "hawser/run/simulation.hpp"
#include "support/cpu_time.hpp"

using namespace hawser;
using run::Simulation;

namespace {

model::Case lines(int count, int elements, bool beam) {
  model::Case c;
  model::LineType t;
  t.name = "type";
  t.kind = beam ? model::LineKind::beam : model::LineKind::cable;
  t.outer_diameter = t.contact_diameter = 0.25;
  t.mass_per_length = 100;
  t.EA = 1e9;
  if (beam) t.EI2 = t.EI3 = t.GJ = 1e5;
  t.rotary_inertia = Vec3::Constant(0.5);
  c.line_types.push_back(t);
  for (int i = 0; i < count; ++i) {
    model::Line l;
    l.name = std::to_string(i);
    l.sections.push_back({"type", 120, elements, 1});
    l.end_a.kind = l.end_b.kind = model::EndKind::anchor;
    l.end_a.at = Vec3(0, 10. * i, 0);
    l.end_b.at = Vec3(90, 10. * i, 40);
    c.lines.push_back(l);
  }
  c.dynamics.enabled = true;
  c.dynamics.duration = 1;
  return c;
}

void newton(benchmark::State& state) {
  const bool beam = state.range(0);
  const model::Case c = lines(static_cast<int>(state.range(1)), static_cast<int>(state.range(2)), beam);
  Simulation sim(PETSC_COMM_WORLD, c);
  System& system = sim.system();
  AlphaState from, trial;
  from.s = sim.state();
  alpha_start(system.mesh(), from);
  trial = from;
  const AlphaCoefficients alpha(0.8);
  const double h = 0.05;
  std::vector<double> u(3 * static_cast<size_t>(system.mesh().blocks()));
  for (size_t i = 0; i < u.size(); ++i) u[i] = 1e-3 * std::sin(static_cast<double>(i));
  VecHandle r = system.create_vector();
  VecHandle du = system.create_vector();
  MatHandle J = system.create_matrix();
  KspHandle ksp, bare;
  for (KspHandle* k : {&ksp, &bare}) {
    check(KSPCreate(PETSC_COMM_WORLD, k->out()));
    configure_linear_solver(k->get(), system, "bench_");
  }
  // CPU time of the parts of an iteration.
  const auto state_part = [&] { alpha_trial(system.mesh(), system.tied_nodes(), alpha, h, from, u, trial); };
  const auto residual_part = [&] { system.residual(trial.s.after_step(h), r.get()); };
  const auto tangent_part = [&] {
    system.tangent(trial.s.after_step(h), alpha_weights(alpha, h), u, false, J.get());
  };
  const auto solve_part = [&] {
    check(MatAssemblyBegin(J.get(), MAT_FINAL_ASSEMBLY));  // otherwise it is not factorised again
    check(MatAssemblyEnd(J.get(), MAT_FINAL_ASSEMBLY));
    check(KSPSetOperators(ksp.get(), J.get(), J.get()));
    check(KSPSolve(ksp.get(), r.get(), du.get()));
  };
  const auto iteration = [&] {
    state_part();
    residual_part();
    tangent_part();
    solve_part();
  };
  iteration();
  MatHandle chain;
  check(MatDuplicate(J.get(), MAT_COPY_VALUES, chain.out()));
  const auto factor = [&] {
    check(MatAssemblyBegin(chain.get(), MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(chain.get(), MAT_FINAL_ASSEMBLY));
    check(KSPSetOperators(bare.get(), chain.get(), chain.get()));
    check(KSPSetUp(bare.get()));
  };
  factor();
  const double nodes = static_cast<double>(sim.mesh().nodes());
  const int inner = std::max(1, static_cast<int>(10000 / nodes));
  // Least time of interleaved repetitions, which excludes other load on the machine.
  double best[6];
  std::fill(std::begin(best), std::end(best), 1e9);
  const auto time = [&](double& least, const auto& what) {
    const double t = test::cpu_seconds();
    for (int i = 0; i < inner; ++i) what();
    least = std::min(least, 1e6 * (test::cpu_seconds() - t) / inner / nodes);
  };
  for (auto _ : state) {
    time(best[0], iteration);
    time(best[1], factor);
    time(best[2], state_part);
    time(best[3], residual_part);
    time(best[4], tangent_part);
    time(best[5], solve_part);
  }
  const char* names[] = {"newton_us", "lu_us", "state_us", "residual_us", "tangent_us", "solve_us"};
  for (int i = 0; i < 6; ++i) state.counters[names[i]] = best[i];
  state.counters["ratio"] = best[0] / best[1];
}

}  // namespace

BENCHMARK(newton)
    ->ArgNames({"beam", "lines", "elements"})
    ->ArgsProduct({{0, 1}, {1, 100}, {100}})
    ->Iterations(40);

int main(int argc, char** argv) {
  ::benchmark::Initialize(&argc, argv);
  if (PetscInitialize(&argc, &argv, nullptr, nullptr)) return 1;
  ::benchmark::RunSpecifiedBenchmarks();
  return PetscFinalize();
}
