// CPU time per simulated second of a mooring line or a riser (support/mooring_speed.hpp) for a range of steps
// and tolerances of Newton's iteration; `digits` 8 is the default of a case.
#include "support/mooring_speed.hpp"

#include <benchmark/benchmark.h>

namespace hawser::test::speed {
namespace {

void measure(benchmark::State& state, const model::Case& c, const Extremes& exact) {
  for (auto _ : state) {
    const Cost cost = speed::measure(c, 20);
    const auto percent = [&](double a, double b) { return 100 * (a - b) / exact.most; };
    state.SetIterationTime(cost.used * 100);
    state.counters["ms_per_s"] = 1e3 * cost.used;
    state.counters["factorisations"] = cost.used / cost.one;
    state.counters["factorisation_us"] = 1e6 * cost.one;
    state.counters["us_a_step"] = 1e6 * cost.used * 100 / cost.steps;
    state.counters["iterations"] = cost.iterations / cost.steps;
    state.counters["least_error_%"] = percent(cost.found.least, exact.least);
    state.counters["most_error_%"] = percent(cost.found.most, exact.most);
    state.counters["anchor_least_%"] = percent(cost.found.anchor_least, exact.anchor_least);
    state.counters["anchor_most_%"] = percent(cost.found.anchor_most, exact.anchor_most);
  }
}

double seconds(std::int64_t ms) { return 1e-3 * static_cast<double>(ms); }

void chain(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0));
  const int lines = static_cast<int>(state.range(1));
  measure(state, chains(segments, lines, seconds(state.range(2)), static_cast<int>(state.range(3))), kChain);
}

void riser(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0));
  const int digits = static_cast<int>(state.range(2));
  measure(state, speed::riser(segments, seconds(state.range(1)), digits), kRiser);
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
}  // namespace hawser::test::speed

int main(int argc, char** argv) {
  PetscInitialize(&argc, &argv, nullptr, nullptr);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  PetscFinalize();
}
