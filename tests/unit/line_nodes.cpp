// Nodes of a line are moved to the places of attachments: arc lengths by hand.
#include "hawser/model/line_nodes.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "hawser/mesh/mesh.hpp"

namespace hawser::model {
namespace {

Line line_of(std::vector<Section> sections) {
  Line line;
  line.name = "rope";
  line.sections = std::move(sections);
  return line;
}

std::vector<double> arcs(const Line& line, const std::vector<double>& places) {
  std::vector<double> out = {0};
  for (const auto& section : element_lengths(line, places))
    for (const double l : section) out.push_back(out.back() + l);
  return out;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

TEST(LineNodes, TheNearestGoesToThePlaceAndTheOthersFollow) {
  const Line line = line_of({{"chain", 10, 5}});
  expect_near(arcs(line, {}), {0, 2, 4, 6, 8, 10});
  expect_near(arcs(line, {4.6}), {0, 2.3, 4.6, 6.4, 8.2, 10});
  expect_near(arcs(line, {4}), {0, 2, 4, 6, 8, 10});
  expect_near(arcs(line, {0.5}), {0, 0.5, 2.875, 5.25, 7.625, 10});
  expect_near(arcs(line, {4.6, 4.6, 6.9}),
              {0, 2.3, 4.6, 6.9, 8.45, 10});  // the second time a node is already there
  expect_near(arcs(line, {4.6, 5.2}), {0, 2.3, 4.6, 5.2, 7.6, 10});
}

TEST(LineNodes, SectionsEndWhereTheyDid) {
  const Line line = line_of({{"chain", 10, 5}, {"wire", 12, 3, 2}});
  const std::vector<double> plain = arcs(line, {});
  const std::vector<double> moved = arcs(line, {4.6, 14});
  expect_near({moved.begin(), moved.begin() + 6}, {0, 2.3, 4.6, 6.4, 8.2, 10});
  EXPECT_NEAR(moved[6], 14, 1e-12);
  EXPECT_NEAR(moved[8], 22, 1e-12);
  // The elements of a grading keep their ratios.
  EXPECT_NEAR((moved[8] - moved[7]) / (moved[7] - moved[6]), (plain[8] - plain[7]) / (plain[7] - plain[6]),
              1e-12);
}

TEST(LineNodes, NoneCloserThanATenthAndNoneThatIsNotThere) {
  const Line line = line_of({{"chain", 10, 5}});
  for (const double at : {0.0, 0.1, 9.9, 10.0}) expect_near(arcs(line, {at}), {0, 2, 4, 6, 8, 10});
  expect_near(arcs(line, {4.6, 4.7}), {0, 2.3, 4.6, 6.4, 8.2, 10});
  expect_near(arcs(line, {9.3}), {0, 2.325, 4.65, 6.975, 9.3, 10});
  expect_near(arcs(line, {8.5, 9.3}), {0, 2.125, 4.25, 6.375, 8.5, 10});
  expect_near(arcs(line_of({{"chain", 10, 1}}), {4}), {0, 10});
  // Nodes at places remain there, and no element becomes much longer, from either end.
  expect_near(arcs(line, {7.6, 8}), {0, 2, 4, 6, 8, 10});
  expect_near(arcs(line, {2, 2.4}), {0, 2, 4, 6, 8, 10});
  expect_near(arcs(line, {4.2, 4.5, 4.8, 5.1, 5.4}), {0, 2.1, 4.2, 5.4, 7.7, 10});
}

// Masses, loads, links and bodies are at nodes where the mesh expects them.
TEST(LineNodes, OfMassesLoadsLinksAndBodies) {
  Case c;
  c.line_types.resize(1);
  c.line_types[0].name = "chain";
  c.lines = {line_of({{"chain", 100, 10}}), line_of({{"chain", 100, 10}})};
  c.lines[1].name = "other";
  c.lines[0].masses.resize(1);
  c.lines[0].masses[0].at = 33.3;
  c.lines[0].point_loads.resize(1);
  c.lines[0].point_loads[0].at = 52;
  c.links.resize(1);
  c.links[0].end_a.line = "other";
  c.links[0].end_a.arc = 77;
  c.links[0].end_b.line = "rope";
  c.links[0].end_b.arc = 86;
  c.bodies.emplace_back();
  c.bodies[0].name = "rider";
  c.bodies[0].ride = Ride{"other", 14};
  EXPECT_EQ(fixed_places(c), (std::vector<std::vector<double>>{{33.3, 52, 86}, {14, 77}}));
  const Mesh m = build_mesh(c);
  for (const double at : {33.3, 52.0, 86.0}) EXPECT_NEAR(m.node(m.nearest_node(0, at)).arc, at, 1e-12);
  for (const double at : {14.0, 77.0}) EXPECT_NEAR(m.node(m.nearest_node(1, at)).arc, at, 1e-12);
  EXPECT_NEAR(m.element(0).length, 11.1, 1e-12);
}

}  // namespace
}  // namespace hawser::model
