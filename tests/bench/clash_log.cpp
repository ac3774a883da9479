// CPU time of the clash report per step: contacts of all pairs are gathered and merged into the open clashes.
#include "hawser/record/clash_log.hpp"

#include <benchmark/benchmark.h>

namespace hawser::record {
namespace {

// Lines lie on a volume at ten places each, three panels of half a metre per place; half of the places appear
// and disappear.
ActiveContacts touching(int number, int step) {
  ActiveContacts out;
  for (int i = 0; i < number; ++i) {
    const int line = i / 30;
    const int place = i / 3;
    if (place % 2 && (place + step) % 7 == 0) continue;
    ActiveContact t;
    t.line = line;
    t.volume = 0;
    t.from = 50.0 * (place % 10) + 0.5 * (i % 3);
    t.to = t.from + 0.5;
    t.force = 100 + i % 17;
    t.energy = 1;
    t.depth = 1e-3;
    out.push_back(t);
  }
  return out;
}

void BM_ClashStep(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const std::vector<double> merge(static_cast<size_t>(n / 30 + 1), 2.0);
  std::vector<ActiveContacts> steps;
  for (int s = 0; s < 7; ++s) steps.push_back(touching(n, s));
  ClashLog log({0.1, merge});
  double time = 0;
  size_t s = 0;
  for (auto _ : state) {
    time += 0.01;
    log.step(time, merge_contacts(steps[s], merge));
    s = (s + 1) % steps.size();
    benchmark::DoNotOptimize(log.take());
  }
  state.SetComplexityN(n);
  state.counters["open"] = static_cast<double>(log.open().size());
}
BENCHMARK(BM_ClashStep)->RangeMultiplier(10)->Range(100, 100000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hawser::record

BENCHMARK_MAIN();
