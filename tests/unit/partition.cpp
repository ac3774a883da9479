// Which rank gets which lines of a farm, and when lines are cut.
#include "hawser/mesh/partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace hawser::test::partition_test {
namespace {

// Lines of so many cable nodes each.
Mesh mesh_of(const std::vector<int>& nodes) {
  Mesh mesh;
  for (size_t l = 0; l < nodes.size(); ++l) {
    const int line = static_cast<int>(l), first = static_cast<int>(mesh.nodes.size());
    mesh.lines.push_back({first, nodes[l], static_cast<int>(mesh.elements.size()), nodes[l] - 1, 1, "line"});
    for (int n = 0; n < nodes[l]; ++n) mesh.nodes.push_back({.line = line});
    for (int n = 0; n + 1 < nodes[l]; ++n)
      mesh.elements.push_back({.line = line, .first = first + n, .second = first + n + 1});
  }
  return mesh;
}

// Lines that follow each other are one rank's, and no line is cut.
TEST(Partition, LinesOfAFarmAreStretches) {
  const Mesh mesh = mesh_of(std::vector<int>(100, 6));
  const std::vector<int> owner = partition(mesh, 4);
  EXPECT_TRUE(std::is_sorted(owner.begin(), owner.end()));
  for (int r = 0; r < 4; ++r) EXPECT_EQ(std::count(owner.begin(), owner.end(), r), 150) << r;
  EXPECT_EQ(cut_elements(mesh, owner), 0);
}

// A joint and a coupling of nodes keep lines together, wherever they are in the file.
TEST(Partition, JoinedLinesAreOnOneRank) {
  Mesh mesh = mesh_of(std::vector<int>(100, 6));
  mesh.nodes[6 * 99].pinned_to = 0;
  const std::vector<std::pair<int, int>> coupled{{6 * 1, 6 * 98}};
  const std::vector<int> owner = partition(mesh, 2, coupled);
  EXPECT_EQ(owner[0], owner[6 * 99 + 3]);
  EXPECT_EQ(owner[6 * 1], owner[6 * 98]);
  EXPECT_EQ(cut_elements(mesh, owner), 0);
  EXPECT_NE(owner[6 * 2], owner[6 * 97]);
}

// Two bodies, one on the first line and one on the last, that act on each other.
TEST(Partition, CoupledBodiesAreOnOneRank) {
  Mesh mesh = mesh_of(std::vector<int>(10, 6));
  for (const int node : {0, 6 * 9}) {
    mesh.nodes[static_cast<size_t>(node)].tied_to = static_cast<int>(mesh.nodes.size());
    mesh.nodes.push_back({.line = static_cast<int>(mesh.nodes.size()) - 50, .rotates = true});
  }
  const std::vector<std::pair<int, int>> coupled{{60, 61}};
  const std::vector<int> apart = partition(mesh, 2), owner = partition(mesh, 2, coupled);
  EXPECT_NE(apart[60], apart[61]);
  EXPECT_EQ(owner[60], owner[61]);
  EXPECT_EQ(owner[0], owner[6 * 9]);
  EXPECT_EQ(cut_elements(mesh, owner), 0);
}

// One long line and short ones: whole lines would leave a rank with far more than its share.
TEST(Partition, ALongLineIsCut) {
  const Mesh mesh = mesh_of({200, 20, 20, 20});
  const std::vector<int> owner = partition(mesh, 2);
  EXPECT_GT(cut_elements(mesh, owner), 0);
  EXPECT_NEAR(static_cast<double>(std::count(owner.begin(), owner.end(), 0)), 130, 13);
}

}  // namespace
}  // namespace hawser::test::partition_test
