// Time of a nearest-triangle query near the surface, 0 to 0.3 m off it, within 0.5 m. Even meshes of 10^4 to
// 10^6 triangles (target: the time of `together/step` grows at most 1.5 times), and a hull with small rollers
// (argument 0), where cells of one size fail.
//   nearest/   one point a call
//   together/  all points of the row in one call
//   embree/    the same question to Embree 3, one point a call, where it is installed (libembree-dev)
//   line    250 nodes of a line 0.5 m apart over the surface, asked again and again, as time steps do
//   warm    the same, moved 2 cm, with the last answer as a hint
//   lines   2000 nodes of such lines: more than the second-level cache holds on the finest mesh
//   first   10^5 such points, each once: what a query reads is not in the cache yet
//   step    the same, moved 2 cm, with the last answer as a hint: what contact asks in a step
//   random  10^5 points in random order: neither is anything near it
#include "hawser/geometry/spatial_hash.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <random>
#ifdef HAWSER_EMBREE
#include <embree3/rtcore.h>
#endif

namespace {

using namespace hawser;

struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
};

// A ship-like closed surface of 2 nu nv triangles, some thin and some without area at its ends.
void add_hull(Mesh& m, int nu, int nv, const Vec3& size, const Vec3& centre) {
  const int base = static_cast<int>(m.vertices.size());
  const auto power = [](double x, double p) { return std::copysign(std::pow(std::abs(x), p), x); };
  for (int i = 0; i <= nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const double u = M_PI * i / nu, v = 2 * M_PI * j / nv, s = std::sqrt(std::max(std::sin(u), 0.0));
      m.vertices.push_back(centre + 0.5 * size.cwiseProduct(Vec3(std::cos(u), s * power(std::cos(v), 0.6),
                                                                 s * power(std::sin(v), 0.6))));
    }
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const int a = base + i * nv + j, b = base + i * nv + (j + 1) % nv;
      m.triangles.push_back({a, b, a + nv});
      m.triangles.push_back({b, b + nv, a + nv});
    }
}

// A tube of radius 20 m and length 320 m, askew, of `count` triangles of one size.
void add_tube(Mesh& m, int count) {
  const double radius = 20, length = 320;
  const int nv = static_cast<int>(std::lround(std::sqrt(count / 2.0 * 2 * M_PI * radius / length)));
  const int nu = count / (2 * nv);
  const Eigen::AngleAxisd askew(0.7, Vec3(1, 2, 3).normalized());
  for (int i = 0; i <= nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const double v = 2 * M_PI * j / nv;
      m.vertices.push_back(askew * Vec3(length * i / nu, radius * std::cos(v), radius * std::sin(v)));
    }
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const int a = i * nv + j, b = i * nv + (j + 1) % nv;
      m.triangles.push_back({a, b, a + nv});
      m.triangles.push_back({b, b + nv, a + nv});
    }
}

Mesh make(int kind) {
  Mesh m;
  if (kind == 0) {
    add_hull(m, 100, 100, {320, 55, 27}, Vec3::Zero());
    for (int r = 0; r < 60; ++r)
      add_hull(m, 90, 90, {4, 0.6, 0.6}, {170.0 + 6 * (r / 4), (r % 4) * 1.2 - 2, 5.0 - 0.3 * (r / 4)});
  } else {
    add_tube(m, kind);
  }
  return m;
}

struct Queries {
  Mesh mesh;
  SpatialHash hash;
  std::vector<Vec3> along, moved, scattered;
  std::vector<int> answer;
};

const Queries& queries(int kind) {
  static std::map<int, Queries> all;
  auto [it, made] = all.try_emplace(kind);
  Queries& q = it->second;
  if (!made) return q;
  q.mesh = make(kind);
  q.hash = SpatialHash(q.mesh.vertices, q.mesh.triangles);
  std::mt19937 gen(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  const auto direction = [&] { return Vec3(normal(gen), normal(gen), normal(gen)).normalized().eval(); };
  const auto on_surface = [&] {
    const auto t = static_cast<std::size_t>(uniform(gen) * static_cast<double>(q.mesh.triangles.size()));
    return q.mesh.vertices[static_cast<std::size_t>(q.mesh.triangles[t][0])];
  };
  // Lines of 250 points 0.5 m apart that follow the surface.
  const int points = 100000;
  while (static_cast<int>(q.along.size()) < points) {
    Vec3 x = on_surface(), way = direction();
    for (int i = 0; i < 250; ++i) {
      const SpatialHash::Nearest near = q.hash.nearest(x).value();
      const auto& t = q.mesh.triangles[static_cast<std::size_t>(near.triangle)];
      const auto v = [&](std::size_t k) { return q.mesh.vertices[static_cast<std::size_t>(t[k])]; };
      const Vec3 n = (v(1) - v(0)).cross(v(2) - v(0)).stableNormalized();
      if (n.allFinite()) x -= n * n.dot(x - v(0));
      q.along.push_back(x + 0.3 * uniform(gen) * direction());
      way = (way - n * n.dot(way)).stableNormalized();
      x += 0.5 * way;
    }
  }
  for (int i = 0; i < points; ++i) q.scattered.push_back(on_surface() + 0.3 * uniform(gen) * direction());
  for (const Vec3& x : q.along) {
    const auto near = q.hash.nearest(x, 0.5);
    q.answer.push_back(near ? near->triangle : -1);
    q.moved.push_back(x + 0.02 * direction());
  }
  return q;
}

enum Way { line, warm, lines, first, step, scattered };

void nearest(benchmark::State& state, Way way) {
  const Queries& q = queries(static_cast<int>(state.range(0)));
  const bool hinted = way == warm || way == step;
  const auto& points = hinted ? q.moved : way == scattered ? q.scattered : q.along;
  const std::size_t n = way == line || way == warm ? 250 : way == lines ? 2000 : points.size();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(q.hash.nearest(points[i], 0.5, hinted ? q.answer[i] : -1));
    if (++i == n) i = 0;
  }
  SpatialHash::Counters c;
  for (std::size_t k = 0; k < n; ++k) q.hash.nearest(points[k], 0.5, hinted ? q.answer[k] : -1, &c);
  const auto per = [&](long total) { return static_cast<double>(total) / static_cast<double>(c.queries); };
  state.counters["triangles"] = static_cast<double>(q.mesh.triangles.size());
  state.counters["lookups/q"] = per(c.lookups);
  state.counters["cells/q"] = per(c.cells);
  state.counters["bounds/q"] = per(c.triangles);
  state.counters["tests/q"] = per(c.exact);
}

// All points of a row in one call.
void together(benchmark::State& state, Way way) {
  const Queries& q = queries(static_cast<int>(state.range(0)));
  const bool hinted = way == warm || way == step;
  const auto& points = hinted ? q.moved : q.along;
  std::vector<SpatialHash::Question> ask;
  for (std::size_t i = 0; i < (way == warm ? 250 : points.size()); ++i)
    ask.push_back({points[i], 0.5, hinted ? q.answer[i] : -1});
  std::vector<std::optional<SpatialHash::Nearest>> answers(ask.size());
  while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(ask.size()))) {
    q.hash.nearest(ask, answers);
    benchmark::DoNotOptimize(answers.data());
  }
  SpatialHash::Counters c;
  q.hash.nearest(ask, answers, &c);
  const auto per = [&](long total) { return static_cast<double>(total) / static_cast<double>(c.queries); };
  state.counters["triangles"] = static_cast<double>(q.mesh.triangles.size());
  state.counters["lookups/q"] = per(c.lookups);
  state.counters["cells/q"] = per(c.cells);
  state.counters["bounds/q"] = per(c.triangles);
  state.counters["tests/q"] = per(c.exact);
}

#ifdef HAWSER_EMBREE
// The closest-point query of a bounding volume hierarchy. Its boxes are in single precision; the triangles
// are tested in double, as the hash does, so that both give the same answer.
class Tree {
 public:
  explicit Tree(const Mesh& m) : mesh_(m), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry g = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* v = static_cast<float*>(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                          3 * sizeof(float), m.vertices.size()));
    auto* t = static_cast<unsigned*>(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                             3 * sizeof(unsigned), m.triangles.size()));
    for (const Vec3& x : m.vertices)
      for (int a = 0; a < 3; ++a) *v++ = static_cast<float>(x[a]);
    for (const auto& tri : m.triangles)
      for (const int i : tri) *t++ = static_cast<unsigned>(i);
    rtcSetGeometryPointQueryFunction(g, test);
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene_, g);
    rtcReleaseGeometry(g);
    rtcCommitScene(scene_);
  }
  ~Tree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  SpatialHash::Nearest nearest(const Vec3& p, double max_distance, int hint) const {
    Asked a{&mesh_, p, {-1, max_distance * max_distance}};
    if (hint >= 0) a.offer(static_cast<unsigned>(hint));
    RTCPointQuery query;
    query.x = static_cast<float>(p.x());
    query.y = static_cast<float>(p.y());
    query.z = static_cast<float>(p.z());
    query.radius = a.radius();
    query.time = 0;
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &query, &context, nullptr, &a);
    return a.best;
  }

 private:
  struct Asked {
    const Mesh* mesh;
    Vec3 p;
    SpatialHash::Nearest best;
    float radius() const { return static_cast<float>(std::sqrt(best.squared_distance) * (1 + 1e-6)) + 1e-4f; }
    bool offer(unsigned triangle) {
      const auto& t = mesh->triangles[triangle];
      const auto v = [&](std::size_t i) { return mesh->vertices[static_cast<std::size_t>(t[i])]; };
      const double d = squared_distance_to(v(0) - p, v(1) - p, v(2) - p);
      if (!(d < best.squared_distance)) return false;
      best = {static_cast<int>(triangle), d};
      return true;
    }
  };
  // Ericson (2005), 5.1.5, corners seen from the point, as in the hash.
  static double squared_distance_to(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a;
    const double d1 = -ab.dot(a), d2 = -ac.dot(a);
    if (d1 <= 0 && d2 <= 0) return a.squaredNorm();
    const double d3 = -ab.dot(b), d4 = -ac.dot(b);
    if (d3 >= 0 && d4 <= d3) return b.squaredNorm();
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return (a + d1 / (d1 - d3) * ab).squaredNorm();
    const double d5 = -ab.dot(c), d6 = -ac.dot(c);
    if (d6 >= 0 && d5 <= d6) return c.squaredNorm();
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return (a + d2 / (d2 - d6) * ac).squaredNorm();
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
      return (b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).squaredNorm();
    const double f = 1 / (va + vb + vc);
    return (a + vb * f * ab + vc * f * ac).squaredNorm();
  }
  static bool test(RTCPointQueryFunctionArguments* args) {
    Asked& a = *static_cast<Asked*>(args->userPtr);
    if (!a.offer(args->primID)) return false;
    args->query->radius = a.radius();
    return true;
  }

  const Mesh& mesh_;
  RTCDevice device_;
  RTCScene scene_;
};

void embree(benchmark::State& state, Way way) {
  const Queries& q = queries(static_cast<int>(state.range(0)));
  static std::map<int, std::unique_ptr<Tree>> trees;
  auto& tree = trees[static_cast<int>(state.range(0))];
  if (!tree) tree = std::make_unique<Tree>(q.mesh);
  const bool hinted = way == warm || way == step;
  const auto& points = hinted ? q.moved : q.along;
  const std::size_t n = way == line || way == warm ? 250 : points.size();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(tree->nearest(points[i], 0.5, hinted ? q.answer[i] : -1));
    if (++i == n) i = 0;
  }
  double worst = 0;
  for (std::size_t k = 0; k < n; k += 7) {
    const auto other = tree->nearest(points[k], 0.5, -1), own = q.hash.nearest(points[k], 0.5);
    if (!own && other.triangle < 0) continue;
    const double found = own ? std::sqrt(own->squared_distance) : 0;
    worst = std::max(worst, std::abs(std::sqrt(other.squared_distance) - found));
  }
  state.counters["differs_m"] = worst;
}
#endif

void build(benchmark::State& state) {
  const Mesh& m = queries(static_cast<int>(state.range(0))).mesh;
  for (auto _ : state) benchmark::DoNotOptimize(SpatialHash(m.vertices, m.triangles));
  state.counters["triangles"] = static_cast<double>(m.triangles.size());
}

// 0 stands for the hull with rollers.
#define EACH_MESH ->Arg(10000)->Arg(100000)->Arg(1000000)->Arg(0)
BENCHMARK_CAPTURE(nearest, line, line) EACH_MESH;
BENCHMARK_CAPTURE(nearest, warm, warm) EACH_MESH;
BENCHMARK_CAPTURE(nearest, lines, lines) EACH_MESH;
BENCHMARK_CAPTURE(nearest, first, first) EACH_MESH;
BENCHMARK_CAPTURE(nearest, step, step) EACH_MESH;
BENCHMARK_CAPTURE(nearest, random, scattered) EACH_MESH;
BENCHMARK_CAPTURE(together, warm, warm) EACH_MESH;
BENCHMARK_CAPTURE(together, first, first) EACH_MESH;
BENCHMARK_CAPTURE(together, step, step) EACH_MESH;
#ifdef HAWSER_EMBREE
BENCHMARK_CAPTURE(embree, line, line) EACH_MESH;
BENCHMARK_CAPTURE(embree, first, first) EACH_MESH;
BENCHMARK_CAPTURE(embree, step, step) EACH_MESH;
#endif
BENCHMARK(build)->Arg(10000)->Arg(1000000)->Arg(0)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
