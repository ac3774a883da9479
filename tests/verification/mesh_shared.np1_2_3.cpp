// A mesh shared by the ranks of a host: its results are those of a private mesh to the last bit, each file is
// read once and stored once a host, and all ranks report the same error of a file.
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "hawser/base/error.hpp"
#include "hawser/base/host.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/driver.hpp"
#include "hawser/run/volumes.hpp"
#include "support/shapes.hpp"

namespace hawser::test::mesh_shared {
namespace {

using namespace hawser::test;

bool same(const std::optional<SurfacePoint>& a, const std::optional<SurfacePoint>& b) {
  if (!a || !b) return !a && !b;
  const auto bits = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return bits(a->distance, b->distance) && bits(a->normal, b->normal) && bits(a->curvature, b->curvature) &&
         bits(a->point, b->point) && a->triangle == b->triangle && a->feature == b->feature;
}

// Compares queries at points around a surface; each rank has other points.
void expect_same(const Surface& own, const Surface& shared, int points) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::mt19937 gen(17 + static_cast<unsigned>(rank));
  std::uniform_real_distribution<double> unit(-1, 1);
  const Box box = own.bounds();
  ASSERT_TRUE(box.lo == shared.bounds().lo && box.hi == shared.bounds().hi);
  int hint = -1, inside = 0;
  for (int i = 0; i < points; ++i) {
    const Vec3 y = box.centre() + 0.6 * box.extent().cwiseProduct(Vec3(unit(gen), unit(gen), unit(gen)));
    const double within = 0.3 * box.diagonal();
    const auto a = own.query(y, within, hint);
    ASSERT_TRUE(same(a, shared.query(y, within, hint))) << y.transpose();
    hint = a ? a->triangle : -1;
    inside += a && a->distance < 0;
  }
  EXPECT_GT(inside, points / 50);
}

std::shared_ptr<const MeshSurface> share(const Host& host, const MeshSurface& own) {
  const auto block = host.share(own.packed_size(), [&](std::byte* to) { own.write(to); });
  return block ? std::make_shared<MeshSurface>(block) : nullptr;
}

TEST(MeshShared, AnswersAreTheSame) {
  const Host host(MPI_COMM_WORLD);
  TriangleMesh open = sphere_mesh(3);
  open.triangles.erase(open.triangles.begin() + 40, open.triangles.begin() + 43);
  const TriangleMesh ball = sphere_mesh(4);
  const TriangleMesh drum = flanged_drum_mesh(48, 2, 3, 3.0, 0.3);
  std::vector<bool> half(drum.triangles.size());
  for (std::size_t t = 0; t < half.size(); ++t)
    half[t] = drum.vertices[static_cast<std::size_t>(drum.triangles[t][0])].x() > 0;
  std::vector<MeshSurface> all;
  for (const bool smooth : {false, true}) {
    all.emplace_back(ball, std::vector<bool>(), MeshSurfaceOptions{.smooth = smooth});
    all.emplace_back(drum, half, MeshSurfaceOptions{.smooth = smooth});
    all.emplace_back(open, std::vector<bool>(), MeshSurfaceOptions{.smooth = smooth, .open = true});
  }
  for (const MeshSurface& own : all) {
    const auto shared = share(host, own);
    ASSERT_TRUE(shared);
    EXPECT_EQ(shared->curved(), own.curved());
    EXPECT_EQ(shared->sharp_edges(), own.sharp_edges());
    EXPECT_EQ(shared->bulge(), own.bulge());
    EXPECT_EQ(shared->mesh().triangles.size(), own.mesh().triangles.size());
    expect_same(own, *shared, 3000);
  }
}

// Memory [bytes] of this process alone; 0 if the system does not report it.
std::size_t own_memory() {
  std::ifstream in("/proc/self/smaps_rollup");
  std::string word;
  std::size_t kilobytes = 0, sum = 0;
  while (in >> word)
    if ((word == "Private_Clean:" || word == "Private_Dirty:") && in >> kilobytes) sum += kilobytes;
  return 1024 * sum;
}

TEST(MeshShared, OneCopyAHost) {
  const Host host(MPI_COMM_WORLD);
  if (host.size() == 1) GTEST_SKIP() << "needs two ranks on a host";
  if (own_memory() == 0) GTEST_SKIP() << "the system does not report what memory is shared";
  std::unique_ptr<MeshSurface> made;
  if (host.leads()) made = std::make_unique<MeshSurface>(sphere_mesh(7));
  const std::size_t before = own_memory();
  const auto block = host.share(made ? made->packed_size() : 0, [&](std::byte* to) { made->write(to); });
  ASSERT_TRUE(block);
  const MeshSurface shared(block);
  const std::size_t size = shared.packed_size();
  EXPECT_GT(size, std::size_t{10} << 20);
  for (const Vec3& x : shared.mesh().vertices) ASSERT_TRUE(shared.query(1.001 * x, 0.1));
  MPI_Barrier(host.comm());
  if (!host.leads()) {
    EXPECT_LT(own_memory(), before + size / 10);
  }
  MPI_Barrier(host.comm());
}

// Number of times that processes open a file while `work` runs. inotify merges equal successive events, so
// reading and closing are watched as well.
int openings(const std::string& path, const std::function<void()>& work) {
  const int watch = inotify_init1(IN_NONBLOCK);
  EXPECT_GE(inotify_add_watch(watch, path.c_str(), IN_OPEN | IN_ACCESS | IN_CLOSE), 0) << path;
  MPI_Barrier(MPI_COMM_WORLD);
  work();
  MPI_Barrier(MPI_COMM_WORLD);
  int found = 0;
  alignas(inotify_event) std::array<char, 4096> events;
  for (ssize_t n = 0; (n = read(watch, events.data(), events.size())) > 0;)
    for (ssize_t at = 0; at < n;) {
      inotify_event e;
      std::memcpy(&e, events.data() + at, sizeof e);
      found += (e.mask & IN_OPEN) != 0;
      at += static_cast<ssize_t>(sizeof e + e.len);
    }
  close(watch);
  return found;
}

// A whole run and a check of a case in which two volumes have the same mesh, and the seabed is a mesh.
TEST(MeshShared, EachFileIsReadOnce) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const std::string folder = testing::TempDir() + "read_once";
  const std::string path = folder + "/case.yaml";
  const auto write_stl = [](const std::string& to, const std::string& corners) {
    std::ofstream out(to);
    std::istringstream in(corners);
    out << "solid s\n";
    for (std::string x, y, z; in >> x >> y >> z;) {
      out << "facet normal 0 0 0\nouter loop\nvertex " << x << ' ' << y << ' ' << z << '\n';
      for (int i = 0; i < 2 && in >> x >> y >> z; ++i) out << "vertex " << x << ' ' << y << ' ' << z << '\n';
      out << "endloop\nendfacet\n";
    }
    out << "endsolid s\n";
  };
  if (rank == 0) {
    std::filesystem::create_directories(folder);
    write_stl(folder + "/post.stl",
              "0 0 0 0 4 0 4 0 0  0 0 0 4 0 0 0 0 4  0 0 0 0 0 4 0 4 0  4 0 0 0 4 0 0 0 4");
    write_stl(folder + "/bed.stl", "-50 -50 -30 50 -50 -30 50 50 -30  -50 -50 -30 50 50 -30 -50 50 -30");
    std::ofstream(path) << R"(hawser: 1
environment:
  seabed: {mesh: {file: bed.stl}}
line_types:
  rope: {outer_diameter: 0.2, mass_per_length: 30, EA: 1e7, bending: false}
bodies:
  near: {position: [0, 20, 0]}
volumes:
  post: {mesh: post.stl, normal_stiffness: {per_length: 1e5}}
  other: {mesh: post.stl, body: near, normal_stiffness: {per_length: 1e5}}
lines:
  rope:
    sections: [{type: rope, length: 24, elements: 12}]
    end_a: {anchor: [-10, -6, 0]}
    end_b: {anchor: [10, -6, 0]}
)";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  run::RunOptions options;
  options.case_path = path;
  options.output = folder + "/case.h5";
  options.quiet = true;
  for (const char* mesh : {"/post.stl", "/bed.stl"}) {
    const auto run = [&] { EXPECT_EQ(run::run(MPI_COMM_WORLD, options), 0); };
    const auto check = [&] { EXPECT_EQ(run::check_case(MPI_COMM_WORLD, {.case_path = path}), 0); };
    EXPECT_EQ(openings(folder + mesh, run), 1) << mesh;
    EXPECT_EQ(openings(folder + mesh, check), 1) << mesh;
  }
}

// Error of load_volumes() on all ranks.
std::string wrong(const model::Case& c) {
  try {
    run::load_volumes(c, MPI_COMM_WORLD);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(MeshShared, VolumesOfACase) {
  const model::Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/reel/reel.yaml");
  const auto own = run::load_volumes(c);
  const auto shared = run::load_volumes(c, MPI_COMM_WORLD);
  ASSERT_EQ(own.size(), shared.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(own[i].name, shared[i].name);
    EXPECT_EQ(own[i].report, shared[i].report);
    EXPECT_EQ(own[i].notes, shared[i].notes);
    EXPECT_EQ(own[i].active, shared[i].active);
    ASSERT_EQ(own[i].facets->triangles.size(), shared[i].facets->triangles.size());
    expect_same(*own[i].surface, *shared[i].surface, 2000);
  }
}

TEST(MeshShared, AllRanksReportWhatIsWrong) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  model::Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/reel/reel.yaml");
  ASSERT_FALSE(c.volumes.empty());
  // A missing file, which only the leading rank finds, and a file without a mesh.
  for (const bool there : {false, true}) {
    c.volumes[0].mesh = (std::filesystem::temp_directory_path() / "hawser_shared_bad.stl").string();
    if (rank == 0) {
      std::filesystem::remove(c.volumes[0].mesh);
      if (there) std::ofstream(c.volumes[0].mesh) << "solid nothing\nendsolid nothing\n";
    }
    MPI_Barrier(MPI_COMM_WORLD);
    const std::string message = wrong(c);
    EXPECT_NE(message.find("hawser_shared_bad.stl"), std::string::npos) << message;
    std::string first = message;
    auto n = static_cast<int>(first.size());
    MPI_Bcast(&n, 1, MPI_INT, 0, MPI_COMM_WORLD);
    first.resize(static_cast<std::size_t>(n));
    MPI_Bcast(first.data(), n, MPI_CHAR, 0, MPI_COMM_WORLD);
    EXPECT_EQ(message, first);
  }
  if (rank == 0) std::filesystem::remove(c.volumes[0].mesh);
}

}  // namespace
}  // namespace hawser::test::mesh_shared
