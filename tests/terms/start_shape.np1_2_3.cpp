// Start shapes of lines that affect each other and are distributed over ranks: each rank computes its own
// lines and those that they depend on, and the shapes equal those of one rank.
#include "hawser/solve/start_shape.hpp"

#include <fmt/format.h>

#include <cstring>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/mesh/partition.hpp"
#include "support/rig.hpp"

namespace hawser::test::start_shape_test {
namespace {

std::string line(const std::string& name, const Vec3& a, const std::string& b, double length,
                 const std::string& type = "rope") {
  return fmt::format(
      "  {}: {{sections: [{{type: {}, length: {}, elements: 20}}], end_a: {{anchor: [{}, {}, {}]}}, end_b: "
      "{}}}\n",
      name, type, length, a.x(), a.y(), a.z(), b);
}

std::string at(const Vec3& x, const std::string& more = "") {
  return fmt::format("{{anchor: [{}, {}, {}]{}}}", x.x(), x.y(), x.z(), more);
}

// On a bed at z = -50: `low` lies under `middle`, which lies under `top`; a line apart from all others; three
// legs of a joint; a line that is cut later, with one that lies over its far part; two hoses whose clamped
// ends point back. Lines that affect each other are far apart in the file.
model::Case field(const std::string& over = "[[middle, low], [top, middle], [across, parted]]") {
  const Vec3 bed(0, 0, -50);
  const auto on_bed = [&](double x, double y) -> Vec3 { return bed + Vec3(x, y, 0); };
  const std::string joint = "{joint: knot}", back = ", direction: [-1, 0, -0.6], clamped: true";
  std::string lines = line("low", on_bed(0, 0), at(on_bed(100, 0)), 101);
  lines += line("leg 1", on_bed(2300, 0), joint, 330);
  lines += line("parted", on_bed(3000, 0), at(on_bed(3100, 0)), 101);
  lines += line("hose 1", Vec3(4000, 0, 10), at(Vec3(4040, 0, 10), back), 45, "hose");
  lines += line("middle", on_bed(50, -50), at(on_bed(50, 50)), 101);
  lines += line("alone", on_bed(1000, 0), at(on_bed(1000, 100)), 101);
  lines += line("leg 2", on_bed(1700, 300), joint, 440);
  lines += line("hose 2", Vec3(4000, 500, 10), at(Vec3(4040, 500, 10), back), 45, "hose");
  lines += line("across", on_bed(3075, -50), at(on_bed(3075, 50)), 101);
  lines += line("top", on_bed(0, 3), at(on_bed(100, 3)), 101);
  lines += line("leg 3", on_bed(1700, -300), joint, 440);
  return io::read_case_text(
      fmt::format(
          "hawser: 1\nenvironment: {{water: {{density: 1025, depth: 50}}, seabed: {{depth: 50, "
          "friction: 0.5}}}}\nline_types:\n  rope: {{outer_diameter: 0.2, mass_per_length: 100, EA: 1e8, "
          "bending: false}}\n  hose: {{outer_diameter: 0.2, mass_per_length: 50, EA: 1e7, EI: 1e4, GJ: "
          "1e4}}\ncontact: {{between_lines: {{over: {}}}}}\njoints: {{knot: {{start: [2000, 0, "
          "-30]}}}}\nlines:\n{}events:\n  - {{cut: {{line: parted, at: 50}}, time: 1}}\ndynamics: "
          "{{duration: 2}}\n",
          over, lines),
      "field.yaml");
}

// Assigns the lines to the ranks in turn, and the ends to the rank of the node they are attached to.
LocalMesh dealt(const Mesh& mesh, MPI_Comm comm) {
  std::vector<int> owner;
  for (int i = 0; i < mesh.nodes(); ++i) {
    Node n = mesh.node(i);
    while (n.pinned_to >= 0 || n.tied_to >= 0)
      n = mesh.node(static_cast<size_t>(std::max(n.pinned_to, n.tied_to)));
    owner.push_back(n.line % ranks_of(comm));
  }
  return local_mesh(mesh, owner, rank_of(comm), ranks_of(comm));
}

bool same(const Vec3& a, const Vec3& b) { return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0; }

TEST(StartShape, RanksMakeTheirOwn) {
  const model::Case c = field();
  const Mesh mesh = build_mesh(c);
  const Bodies bodies(c.bodies);
  const LocalMesh local = dealt(mesh, PETSC_COMM_WORLD);
  const LocalMesh all = dealt(mesh, PETSC_COMM_SELF);
  const StartShape mine = start_shape(PETSC_COMM_WORLD, c, local, bodies);
  const StartShape one = start_shape(PETSC_COMM_SELF, c, all, bodies);
  EXPECT_EQ(mine.notes, one.notes);
  ASSERT_EQ(one.notes.size(), 5u);  // three lines that lie over others, two hoses
  EXPECT_EQ(mine.any_laid, one.any_laid);
  ASSERT_TRUE(one.any_laid);
  std::vector<bool> here(c.lines.size(), false);
  for (size_t n = 0; n < static_cast<size_t>(local.nodes()); ++n) {
    const size_t g = static_cast<size_t>(local.global[n]);
    here[static_cast<size_t>(mesh.node(g).line)] = true;
    EXPECT_TRUE(same(mine.state.x[n], one.state.x[g])) << mesh.place(static_cast<int>(g));
    EXPECT_EQ(mine.state.q[n].coeffs(), one.state.q[g].coeffs()) << mesh.place(static_cast<int>(g));
    EXPECT_TRUE(same(mine.laid[n], one.laid[g])) << mesh.place(static_cast<int>(g));
  }
  for (size_t l = 0; l < here.size(); ++l) {
    if (!here[l]) continue;
    for (const size_t end : {size_t{0}, size_t{1}})
      EXPECT_EQ(mine.ends[l][end].coeffs(), one.ends[l][end].coeffs()) << c.lines[l].name;
  }
  size_t held = 0;
  for (const TiedNode& t : one.tied) held += local.find(t.node) >= 0;
  EXPECT_EQ(mine.tied.size(), held);
  // A line that does not affect the lines of this rank is not computed on it.
  const size_t alone = static_cast<size_t>(c.line_index("alone"));
  EXPECT_NE(one.ends[alone][0].coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(mine.ends[alone][0].coeffs() == one.ends[alone][0].coeffs(), here[alone]);
  // The order of the lines that lie on each other.
  const auto top_of = [&](const char* name) {
    const LineSpan& span = mesh.lines[static_cast<size_t>(c.line_index(name))];
    double z = -HUGE_VAL;
    for (int n = 0; n < span.nodes; ++n)
      z = std::max(z, one.state.x[static_cast<size_t>(span.first_node + n)].z());
    return z;
  };
  EXPECT_GT(top_of("middle"), top_of("low") + 0.15);
  EXPECT_GT(top_of("top"), top_of("middle") + 0.01);
}

TEST(StartShape, AllRanksRefuseWhatOneDoes) {
  const model::Case c = field("[[middle, low], [top, middle]]");
  const Mesh mesh = build_mesh(c);
  const Bodies bodies(c.bodies);
  const auto refusal = [&](MPI_Comm comm) -> std::string {
    try {
      start_shape(comm, c, dealt(mesh, comm), bodies);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  const std::string here = refusal(PETSC_COMM_WORLD);
  const std::string alone = refusal(PETSC_COMM_SELF);
  EXPECT_EQ(here, alone);
  EXPECT_NE(alone.find("which of the two is on top"), std::string::npos) << alone;
}

}  // namespace
}  // namespace hawser::test::start_shape_test
