// Assignment of the lines of a farm to ranks, and cutting of lines: load, number of cut lines and number of
// runs of nodes are within given bounds.
#include "hawser/mesh/partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace hawser::test::partition_test {
namespace {

// Cable lines with these numbers of nodes.
Mesh mesh_of(const std::vector<int>& nodes) {
  Mesh mesh;
  for (size_t l = 0; l < nodes.size(); ++l) {
    const int line = static_cast<int>(l);
    const int first = mesh.nodes();
    mesh.lines.push_back({first, nodes[l], mesh.elements(), nodes[l] - 1, 1});
    for (int n = 0; n < nodes[l]; ++n) mesh.add(Node{.line = line});
    for (int n = 0; n + 1 < nodes[l]; ++n)
      mesh.add(Element{.line = line, .first = first + n, .second = first + n + 1});
  }
  return mesh;
}

void change(Mesh& mesh, int node, int Node::*property, int to) {
  Node n = mesh.node(node);
  n.*property = to;
  mesh.set({{node, n}});
}

// Lines of a farm are assigned to ranks in consecutive groups, and no line is cut.
TEST(Partition, LinesOfAFarmAreStretches) {
  const Mesh mesh = mesh_of(std::vector<int>(100, 6));
  const std::vector<int> owner = partition(mesh, 4).of_nodes();
  EXPECT_TRUE(std::is_sorted(owner.begin(), owner.end()));
  for (int r = 0; r < 4; ++r) EXPECT_EQ(std::count(owner.begin(), owner.end(), r), 150) << r;
  EXPECT_EQ(cut_elements(mesh, owner), 0);
}

// Lines that are joined or coupled by nodes are on one rank, for any order in the file.
TEST(Partition, JoinedLinesAreOnOneRank) {
  Mesh mesh = mesh_of(std::vector<int>(100, 6));
  change(mesh, 6 * 99, &Node::pinned_to, 0);
  const std::vector<std::pair<int, int>> coupled{{6 * 1, 6 * 98}};
  const std::vector<int> owner = partition(mesh, 2, coupled).of_nodes();
  EXPECT_EQ(owner[0], owner[6 * 99 + 3]);
  EXPECT_EQ(owner[6 * 1], owner[6 * 98]);
  EXPECT_EQ(cut_elements(mesh, owner), 0);
  EXPECT_NE(owner[6 * 2], owner[6 * 97]);
}

// Two coupled bodies, one on the first line and one on the last.
TEST(Partition, CoupledBodiesAreOnOneRank) {
  Mesh mesh = mesh_of(std::vector<int>(10, 6));
  for (const int node : {0, 6 * 9}) {
    change(mesh, node, &Node::tied_to, mesh.nodes());
    mesh.add(Node{.line = mesh.nodes() - 50, .rotates = true});
  }
  const std::vector<std::pair<int, int>> coupled{{60, 61}};
  const NodeRanks apart = partition(mesh, 2);
  const NodeRanks owner = partition(mesh, 2, coupled);
  EXPECT_NE(apart[60], apart[61]);
  EXPECT_EQ(owner[60], owner[61]);
  EXPECT_EQ(owner[0], owner[6 * 9]);
  EXPECT_EQ(cut_elements(mesh, owner), 0);
}

// One long line and short ones: without cuts one rank would be overloaded.
TEST(Partition, ALongLineIsCut) {
  const Mesh mesh = mesh_of({200, 20, 20, 20});
  const std::vector<int> owner = partition(mesh, 2).of_nodes();
  EXPECT_GT(cut_elements(mesh, owner), 0);
  EXPECT_NEAR(static_cast<double>(std::count(owner.begin(), owner.end(), 0)), 130, 13);
}

// Platforms with three cables each; a floating one is a node tied to their ends.
Mesh platforms(int count, int line_nodes, bool floating) {
  Mesh mesh = mesh_of(std::vector<int>(static_cast<size_t>(3 * count), line_nodes));
  for (int p = 0; floating && p < count; ++p) {
    for (int l = 3 * p; l < 3 * p + 3; ++l)
      change(mesh, line_nodes * (l + 1) - 1, &Node::tied_to, mesh.nodes());
    mesh.add(Node{.line = 3 * count + p, .rotates = true, .body = p});
  }
  return mesh;
}

std::vector<int> all_lines(const Mesh& mesh) {
  std::vector<int> lines(mesh.lines.size());
  std::iota(lines.begin(), lines.end(), 0);
  return lines;
}

// Largest number of runs of consecutive nodes on a rank: each run is a separate write of a data set.
int most_runs(const std::vector<int>& owner, int ranks) {
  std::vector<int> runs(static_cast<size_t>(ranks), 0);
  for (size_t n = 0; n < owner.size(); ++n)
    if (n == 0 || owner[n] != owner[n - 1]) ++runs[static_cast<size_t>(owner[n])];
  return *std::max_element(runs.begin(), runs.end());
}

struct Expected {
  int ranks;
  double imbalance;
  int cut_lines, runs;
};

void expect(const Mesh& mesh, const Expected& e) {
  const std::vector<int> owner = partition(mesh, e.ranks, {}, all_lines(mesh)).of_nodes();
  const Balance b = balance(mesh, owner, e.ranks);
  EXPECT_LE(b.imbalance, e.imbalance) << e.ranks;
  EXPECT_LE(b.cut_lines, e.cut_lines) << e.ranks;
  EXPECT_LE(most_runs(owner, e.ranks), e.runs) << e.ranks;
}

// Lines of platforms with prescribed motion are separate components: at least one rank has ceil(300 / ranks)
// of them, and no line needs to be cut.
TEST(Partition, LinesOfPrescribedPlatforms) {
  for (const Expected& e : {Expected{4, 1, 0, 1}, {16, 1.014, 0, 1}, {64, 1.067, 0, 1}, {256, 1.707, 0, 1}})
    expect(platforms(100, 11, false), e);
}

// A floating platform and its lines are one component. On 64 ranks with at most 1.07 times the mean load no
// rank can have two components, so at least 36 platforms are cut, each at one line or more. The nodes of
// platforms are a separate run after those of the lines.
TEST(Partition, FloatingPlatforms) {
  for (const Expected& e : {Expected{4, 1, 0, 2}, {16, 1.07, 8, 3}, {64, 1.113, 36, 3}, {256, 1.35, 200, 3}})
    expect(platforms(100, 11, true), e);
  expect(platforms(100, 51, true), {64, 1.078, 36, 3});
}

// Two lines in contact along their length are cut at the same place: cuts in file order would separate the
// lines from each other.
TEST(Partition, TouchingLinesAreCutAcross) {
  const Mesh mesh = mesh_of({100, 100});
  std::vector<std::pair<int, int>> coupled;
  for (int n = 0; n < 100; ++n) coupled.emplace_back(n, 100 + n);
  const std::vector<int> owner = partition(mesh, 2, coupled).of_nodes();
  const Balance b = balance(mesh, owner, 2);
  EXPECT_EQ(b.cut_lines, 2);
  EXPECT_EQ(b.cut_elements, 2);
  EXPECT_LE(b.imbalance, 1.07);
}

}  // namespace
}  // namespace hawser::test::partition_test
