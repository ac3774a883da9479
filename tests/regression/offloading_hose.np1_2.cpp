// The offloading hose of cases/offloading-hose: with contact it stays outside the hull and lies along it;
// without contact it passes through. Results on one rank and on two are equal, because a hose that may touch
// itself is not cut. Whole (HAWSER_FULL), or with longer elements until it has reached stern and side.
#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "regression/runs.hpp"
#include "support/cpu_time.hpp"
#include "support/hulls.hpp"

namespace hawser::runs::offloading_hose {
namespace {

constexpr double kRadius = 0.5 * 0.49843;  // m
constexpr double kSide = 27.5;             // m, half the beam; the port side is x = -27.5, heading north

bool whole() { return std::getenv("HAWSER_FULL") != nullptr; }
double stop_at() { return whole() ? 0 : 150; }

std::string hose(const std::string& path, const std::string& name) {
  const std::string from = HAWSER_SOURCE_DIR "/cases/offloading-hose/";
  std::ostringstream text;
  text << std::ifstream(from + name).rdbuf();
  Edits edits{{"mesh: hull.obj", "mesh: " + from + "hull.obj"},
              {"file: vlcc.rao", "file: " + from + "vlcc.rao"}};
  if (!whole()) edits.push_back({"elements: 200", "elements: 70"});
  write_case(path, text.str(), edits);
  return path;
}

// Nodes of the last output with their centre inside the hull, by the winding number of all its triangles, and
// their largest distance from the port side.
struct Inside {
  int nodes = 0;
  double deepest = 0;  // m
};
Inside inside(const std::string& path, const Results& r) {
  const model::Case c = io::read_case(path);
  const TriangleMesh mesh = run::load_volumes(c)[0].facets->copy();
  const auto boundary = test::boundary_of(mesh);
  const auto& x = r.fields.at("position");
  const size_t nodes = x.size() / 3 / r.output_times.size();
  const size_t first = 3 * nodes * (r.output_times.size() - 1);
  Inside out;
  for (size_t n = 0; n < nodes; ++n) {
    const double* p = x.data() + first + 3 * n;
    // The ship moves by some centimetres: only deeper nodes count.
    const Vec3 body(p[1], -p[0], p[2]);
    const Vec3 up = Vec3(0.0031, 0.0017, 1).normalized();
    if (!(test::WindingAlong(mesh, body, up).at(0, mesh, boundary) > 0.5)) continue;
    ++out.nodes;
    out.deepest = std::max(out.deepest, p[0] + kSide);
  }
  return out;
}

TEST(OffloadingHose, StaysOutsideAndLiesAlongTheHull) {
  if (size_of(MPI_COMM_WORLD) == 1 && !whole()) GTEST_SKIP() << "2 ranks run it on 1, too; set HAWSER_FULL";
  const std::string path = folder("offloading_hose");
  const std::string here = hose(path + "/hose.yaml", "offloading-hose.yaml");
  const double before = test::cpu_seconds();
  run_on_all({here, path + "/all.h5", "", stop_at()});
  const double used = test::cpu_seconds() - before;
  if (size_of(MPI_COMM_WORLD) > 1) run_on_one({here, path + "/one.h5", "", stop_at()});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Results all = read(path + "/all.h5");
  const double deepest = all.summary.at(3 * 4);
  const Inside in = inside(here, all);
  // Nodes where the hose is within 0.15 m of the hull, along the port side and round the quarter.
  const auto hull = run::load_volumes(io::read_case(here))[0].surface;
  const auto& x = all.fields.at("position");
  const size_t nodes = x.size() / 3 / all.output_times.size();
  const size_t first = 3 * nodes * (all.output_times.size() - 1);
  int along = 0;
  for (size_t n = 0; n < nodes; ++n) {
    const double* p = x.data() + first + 3 * n;
    along += hull->query(Vec3(p[1], -p[0], p[2]), kRadius + 0.15).has_value();
  }
  const double length = 278.5 * along / static_cast<double>(nodes - 1);
  std::printf(
      "offloading hose on %d ranks: %zu steps, deepest %.2f mm (%.2f %% of the radius), %d nodes inside, "
      "%.0f m "
      "along the hull, %.0f s of CPU for %.0f s\n",
      size_of(MPI_COMM_WORLD), all.step_times.size(), 1e3 * deepest, 100 * deepest / kRadius, in.nodes,
      length, used, all.step_times.back());
  EXPECT_GT(deepest, 0);
  // Elements of 4 m have harder impacts than those of 1.4 m.
  EXPECT_LT(deepest, (whole() ? 0.02 : 0.04) * kRadius);
  EXPECT_EQ(in.nodes, 0);
  EXPECT_GT(length, whole() ? 60 : 5);
  // 12 054; 16 540 with steps that follow the damped vibrations after impacts for twenty periods (decision
  // 042).
  if (whole()) {
    EXPECT_LT(all.step_times.size(), 14500U);
  }
  if (size_of(MPI_COMM_WORLD) == 1) {
#if defined(__OPTIMIZE__) && defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
    // Faster than real time on one core.
    EXPECT_LT(used, all.step_times.back());
#endif
    return;
  }
  // Equal within the error tolerance. A cut hose would differ by millimetres: impacts and rebounds over tens
  // of metres determine the steps and amplify the smallest difference.
  const Results one = read(path + "/one.h5");
  EXPECT_EQ(one.output_times, all.output_times);
  EXPECT_EQ(one.step_times, all.step_times);
  EXPECT_LE(largest_difference(one.fields.at("position"), all.fields.at("position")), 0.0003);  // m
}

TEST(OffloadingHose, GoesThroughTheHullWithoutContact) {
  const std::string path = folder("offloading_hose_no_contact");
  const std::string here = hose(path + "/hose.yaml", "offloading-hose-no-contact.yaml");
  run_on_all({here, path + "/all.h5", "", stop_at()});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Inside in = inside(here, read(path + "/all.h5"));
  std::printf("without contact: %d nodes inside, %.1f m past the side\n", in.nodes, in.deepest);
  EXPECT_GT(in.nodes, whole() ? 20 : 3);
  EXPECT_GT(in.deepest, whole() ? 10 : 1);
}

}  // namespace
}  // namespace hawser::runs::offloading_hose
