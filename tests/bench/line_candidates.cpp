// Candidate pairs of lines: time to build the list and to check its validity, for 10^3 to 10^5 segments of a
// tangle of equal density; and pairs of unevenly distributed boxes.
#include "hawser/terms/line_candidates.hpp"

#include <benchmark/benchmark.h>
#include <mpi.h>

#include <cmath>
#include <random>

#include "hawser/geometry/box_pairs.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/state/state.hpp"

namespace {

using namespace hawser;

// Lines of 100 beams of 1 m: random walks in a box of `room` m³ per segment.
struct Tangle {
  Mesh mesh;
  LocalMesh local;
  State state;
  explicit Tangle(int segments, double room = 8) : state(0) {
    std::mt19937_64 rng(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double half = 0.5 * std::cbrt(room * segments);
    std::vector<Vec3> x, t;
    for (int line = 0; line < segments / 100; ++line) {
      const int first = mesh.nodes();
      Vec3 at = half * Vec3(unit(rng), unit(rng), unit(rng));
      Vec3 way = Vec3(unit(rng), unit(rng), unit(rng)).normalized();
      for (int i = 0; i <= 100; ++i) {
        mesh.add(Node{line, static_cast<double>(i), 1, true});
        x.push_back(at);
        t.push_back(way);
        if (i < 100) mesh.add(Element{line, first + i, first + i + 1, 0, 1, true});
        way = (way + 0.2 * Vec3(unit(rng), unit(rng), unit(rng))).normalized();
        for (int c = 0; c < 3; ++c)
          if (std::abs(at[c] + way[c]) > half) way[c] = -std::copysign(std::abs(way[c]), at[c]);
        at += way;
      }
    }
    local = local_mesh(mesh, NodeRanks::all_of(mesh.nodes()), 0, 1);
    state.resize(local.nodes());
    for (size_t n = 0; n < x.size(); ++n) {
      state.x[n] = x[n];
      state.q[n] = minimal_rotation(Vec3::UnitX(), t[n]);
      state.v[n] = 0.1 * Vec3(unit(rng), unit(rng), unit(rng));
    }
  }
};

void Build(benchmark::State& b) {
  const int n = static_cast<int>(b.range(0));
  Tangle t(n);
  LineCandidates list(MPI_COMM_SELF, t.local, ContactRadii({0.1, 0.1}));
  double side = 1;  // moves the lines before every update
  for (auto _ : b) {
    for (Vec3& x : t.state.x) x.x() += side;
    side = -side;
    list.update(t.state.after_step(0.1), 0.1);
  }
  const size_t pairs = list.elements().size();
  b.counters["pairs a segment"] = static_cast<double>(pairs) / n;
  b.counters["ns a segment"] = benchmark::Counter(
      n * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(Build)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

void Hold(benchmark::State& b) {
  const int n = static_cast<int>(b.range(0));
  const Tangle t(n);
  LineCandidates list(MPI_COMM_SELF, t.local, ContactRadii({0.1, 0.1}));
  list.update(t.state.after_step(0.1), 0.1);
  for (auto _ : b) benchmark::DoNotOptimize(list.update(t.state.after_step(0.1), 0.1));
  b.counters["ns a segment"] = benchmark::Counter(
      n * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(Hold)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

// Boxes of 1 m. 0: a spool, each box with hundreds of neighbours; 1: all at one place; 2: a tangle with one
// box across all of it; 3: four tangles 1 km apart.
void Uneven(benchmark::State& b) {
  std::mt19937_64 rng(2);
  std::uniform_real_distribution<double> unit(0, 1);
  const int kind = static_cast<int>(b.range(0));
  const int n = kind == 1 ? 1000 : 20000;
  const double room = kind == 0 ? 10 : kind == 1 ? 1e-3 : kind == 2 ? 54 : 34;
  std::vector<Box> boxes;
  for (int i = 0; i < n; ++i) {
    const double far = kind == 3 ? 1000 : 0;
    const Vec3 at =
        room * Vec3(unit(rng), unit(rng), unit(rng)) + far * Vec3(i % 4 == 1, i % 4 == 2, i % 4 == 3);
    boxes.push_back({at, at + Vec3::Ones()});
  }
  if (kind == 2) boxes.push_back({Vec3(-10, 27, 27), Vec3(100, 28, 28)});
  size_t pairs = 0;
  for (auto _ : b) pairs = overlapping_pairs(boxes).size();
  b.counters["pairs a box"] = static_cast<double>(pairs) / n;
  b.counters["ns a box"] = benchmark::Counter(
      n * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(Uneven)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  MPI_Finalize();
}
