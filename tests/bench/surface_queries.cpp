// CPU time of a signed distance as evaluated by contact: nodes of lines 0.5 m apart that follow a surface, 0
// to 0.3 m off it, moved by 2 cm since the last result, within 0.5 m.
//   surface/one        one point per call, the last result as a hint
//   surface/unlimited  one point per call, at any distance
// First argument: triangles of a uniform tube, or 0: a tanker's hull of 130 000 triangles, open and graded,
// if its mesh is beside the sources. Second argument: 0 flat facets, 1 curved.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>
#include <memory>
#include <random>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/io/mesh_reader.hpp"
#include "support/hulls.hpp"
#include "support/shapes.hpp"

namespace {

using namespace hawser;

struct Question {
  Vec3 point;
  int hint;
};
struct Case {
  std::unique_ptr<MeshSurface> surface;
  std::vector<Question> questions;
};

TriangleMesh tube(int count) {
  const double radius = 20, length = 320;
  const int nv = static_cast<int>(std::lround(std::sqrt(count / 2.0 * 2 * M_PI * radius / length)));
  const int rings = count / (2 * nv);
  return test::drum_mesh(nv, radius, length, rings);
}

const Case& get(int kind, bool smooth) {
  static std::map<std::pair<int, bool>, Case> all;
  auto [it, made] = all.try_emplace({kind, smooth});
  Case& c = it->second;
  if (!made) return c;
  if (kind == 0) {
    const std::string path = test::unpacked_hull(
        "kvlcc2.obj", (std::filesystem::temp_directory_path() / "hawser_bench_hulls").string());
    if (path.empty()) return c;
    io::LoadedMesh hull = io::read_mesh(path, 58);
    c.surface = std::make_unique<MeshSurface>(std::move(hull.mesh), std::vector<bool>(),
                                              MeshSurfaceOptions{smooth, 40 * M_PI / 180, hull.open});
  } else {
    c.surface = std::make_unique<MeshSurface>(tube(kind), std::vector<bool>(), MeshSurfaceOptions{smooth});
  }
  std::mt19937 gen(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  const auto direction = [&] { return Vec3(normal(gen), normal(gen), normal(gen)).normalized().eval(); };
  const MeshView m = c.surface->mesh();
  const int points = kind == 0 ? 20000 : 100000;
  while (static_cast<int>(c.questions.size()) < points) {
    Vec3 x = m.vertices[gen() % m.vertices.size()];
    Vec3 way = direction();
    for (int i = 0; i < 250; ++i) {
      const auto near = c.surface->query(x, 10);
      if (!near) break;
      x -= near->distance * near->normal;
      const Vec3 before = x + 0.3 * uniform(gen) * direction();
      const auto nearest = c.surface->query(before, 0.5);
      c.questions.push_back({before + 0.02 * direction(), nearest ? nearest->triangle : -1});
      way = (way - near->normal * near->normal.dot(way)).stableNormalized();
      x += 0.5 * way;
    }
  }
  return c;
}

enum class Way { one, unlimited };

void surface(benchmark::State& state, Way way) {
  const Case& c = get(static_cast<int>(state.range(0)), state.range(1) != 0);
  if (!c.surface) return state.SkipWithError("the hull meshes are not beside the sources");
  state.counters["MB"] = 1e-6 * static_cast<double>(c.surface->packed_size());
  std::size_t i = 0;
  for (auto _ : state) {
    const Question& q = c.questions[i];
    if (way == Way::one)
      benchmark::DoNotOptimize(c.surface->query(q.point, 0.5, q.hint));
    else
      benchmark::DoNotOptimize(c.surface->query(q.point, 1e9));
    if (++i == c.questions.size()) i = 0;
  }
  state.counters["triangles"] = static_cast<double>(c.surface->mesh().triangles.size());
}

#define EACH \
  ->Args({10000, 0})->Args({1000000, 0})->Args({10000, 1})->Args({1000000, 1})->Args({0, 0})->Args({0, 1})
BENCHMARK_CAPTURE(surface, one, Way::one) EACH;
BENCHMARK_CAPTURE(surface, unlimited, Way::unlimited) EACH;

}  // namespace

BENCHMARK_MAIN();
