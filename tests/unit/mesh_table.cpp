// The mesh as a table: nodes and elements equal those that are computed one after the other along each line.
#include "hawser/mesh/mesh_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/mesh/node_ranks.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/model/line_nodes.hpp"

namespace hawser::mesh_table_test {
namespace {

// Even and graded sections, nodes moved to masses, temperatures, cables beside beams.
model::Case uneven() {
  return io::read_case_text(R"(hawser: 1
environment: {gravity: 9.81}
line_types:
  bar: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, EI: 1e4, GJ: 1e4, thermal_expansion: 1e-5}
  rope: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, bending: false, thermal_expansion: 2e-5}
lines:
  a:
    sections:
      - {type: rope, length: 123.4, elements: 200}
      - {type: bar, length: 80.1, elements: 150, grading: 3}
      - {type: rope, length: 20, elements: 1}
    masses: [{at: 33.3, mass: 100}, {at: 150.05, mass: 20}]
    end_a: {anchor: [0, 0, 0]}
    end_b: free
    temperature_change: [[10, 60], [150, -20], [200, 0]]
  b:
    sections: [{type: bar, length: 70, elements: 7, grading: 0.5}, {type: bar, length: 30, elements: 7}]
    end_a: {anchor: [0, 10, 0]}
    end_b: free
    temperature_change: 40
)",
                            HAWSER_SOURCE_DIR "/tests/mesh_table.yaml");
}

TEST(MeshTable, EqualsTheSumsAlongTheLines) {
  const model::Case c = uneven();
  const Mesh mesh = build_mesh(c);
  const auto places = model::fixed_places(c);
  int n = 0, e = 0;
  for (size_t l = 0; l < c.lines.size(); ++l) {
    EXPECT_EQ(mesh.lines[l].first_node, n);
    EXPECT_EQ(mesh.lines[l].first_element, e);
    double start = 0, arc = 0, before = 0;
    bool beam_before = false;
    const auto lengths = model::element_lengths(c.lines[l], places[l]);
    for (size_t s = 0; s < lengths.size(); ++s) {
      const model::Section& section = c.lines[l].sections[s];
      const model::LineType& type = c.line_type(section.type);
      const bool beam = type.kind == model::LineKind::beam;
      double along = 0;
      for (const double length : lengths[s]) {
        const Node node = mesh.node(n);
        EXPECT_EQ(node.line, static_cast<int>(l));
        EXPECT_EQ(node.arc, arc) << n;
        EXPECT_EQ(node.tributary, 0.5 * before + 0.5 * length) << n;
        EXPECT_EQ(node.rotates, beam || beam_before) << n;
        const Element element = mesh.element(e);
        EXPECT_EQ(element.first, n);
        EXPECT_EQ(element.second, n + 1);
        EXPECT_EQ(element.length, length) << e;
        EXPECT_EQ(element.beam, beam);
        EXPECT_EQ(c.line_types[static_cast<size_t>(element.type)].name, section.type);
        EXPECT_EQ(element.free_strain, model::thermal_strain(type, c.lines[l], arc, arc + length)) << e;
        ++n;
        ++e;
        along += length;
        arc = start + along;
        before = length;
        beam_before = beam;
      }
      arc = start = start + section.length;
    }
    EXPECT_EQ(mesh.node(n).arc, arc);
    EXPECT_EQ(mesh.node(n).tributary, 0.5 * before);
    EXPECT_EQ(mesh.node(n).rotates, beam_before);
    ++n;
    EXPECT_EQ(mesh.lines[l].length, arc);
    EXPECT_EQ(mesh.lines[l].nodes, n - mesh.lines[l].first_node);
  }
  EXPECT_EQ(mesh.nodes(), n);
  EXPECT_EQ(mesh.elements(), e);
  // Two sections of another type than the one before, and two masses.
  EXPECT_EQ(mesh.special_nodes().size(), 4u);
  EXPECT_LE(mesh.parts().size(), 10u);
}

TEST(MeshTable, NearestNodeOfALine) {
  const Mesh mesh = build_mesh(uneven());
  for (const double s : {-1.0, 0.0, 0.3, 33.3, 61.7, 123.4, 150.05, 199.9, 213.0, 223.4, 500.0}) {
    int best = 0;
    for (int n = 0; n < mesh.lines[0].nodes; ++n)
      if (std::abs(mesh.node(n).arc - s) < std::abs(mesh.node(best).arc - s)) best = n;
    EXPECT_EQ(mesh.nearest_node(0, s), best) << s;
  }
}

TEST(MeshTable, LengthsAndKindsAreThoseOfTheElements) {
  const Mesh mesh = build_mesh(uneven());
  double longest = 0;
  for (int e = 0; e < mesh.elements(); ++e) {
    const Element element = mesh.element(e);
    EXPECT_EQ(mesh.length_of(e), element.length);
    EXPECT_EQ(mesh.part_of(e).shape->type, element.type);
    EXPECT_EQ(mesh.part_of(e).line, element.line);
    longest = std::max(longest, element.length);
  }
  EXPECT_EQ(mesh.longest_element(), longest);
  EXPECT_TRUE(mesh.any_beam());
  EXPECT_TRUE(mesh.any_cable());
  EXPECT_TRUE(mesh.any_rotates());
}

// A farm has thousands of equal lines.
TEST(MeshTable, EqualLinesShareTheirParts) {
  std::string text = R"(hawser: 1
environment: {gravity: 9.81}
line_types: {rope: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, bending: false}}
lines:
)";
  for (const int elements : {70, 70, 80})
    text += "  l" + std::to_string(text.size()) +
            ": {sections: [{type: rope, length: 20, elements: " + std::to_string(elements) +
            "}], end_a: {anchor: [0, 0, 0]}, end_b: free}\n";
  const Mesh mesh = build_mesh(io::read_case_text(text, HAWSER_SOURCE_DIR "/tests/mesh_table.yaml"));
  const auto shape = [&](int line) { return mesh.part_of(mesh.lines[line].first_element).shape; };
  EXPECT_EQ(shape(0), shape(1));
  EXPECT_NE(shape(0), shape(2));
  EXPECT_EQ(mesh.node(mesh.lines[1].first_node + 66).arc, mesh.node(66).arc);
}

// A node that is set twice has the later properties; a node that is not set keeps its properties.
TEST(MeshTable, NodesThatAreSet) {
  Mesh mesh = build_mesh(uneven());
  const size_t before = mesh.special_nodes().size();
  const int marked = mesh.special_nodes()[1].first;
  const int plain = marked + 1;
  Node node = mesh.node(plain);
  node.pinned_to = 3;
  mesh.set({{plain, node}});
  EXPECT_EQ(mesh.node(plain).pinned_to, 3);
  EXPECT_TRUE(mesh.node(marked).two_sided);
  EXPECT_EQ(mesh.special_nodes().size(), before + 1);
  node.pinned_to = 5;
  mesh.set({{plain, node}});
  EXPECT_EQ(mesh.node(plain).pinned_to, 5);
  EXPECT_EQ(mesh.special_nodes().size(), before + 1);
  for (size_t i = 1; i < mesh.special_nodes().size(); ++i)
    EXPECT_LT(mesh.special_nodes()[i - 1].first, mesh.special_nodes()[i].first);
}

// Nodes and elements that were added one by one are returned unchanged.
TEST(MeshTable, GivenOneByOne) {
  Mesh mesh;
  const Node nodes[] = {{0, 0, 0.5, false}, {0, 1, 1, true}, {0, 2, 0.5, true}};
  // Elements 2 to 6 differ in one property each from the one before, the last two in none.
  const Element elements[] = {{0, 0, 1, 2, 1, false, 0.1}, {0, 1, 2, 3, 1, true, 0},
                              {0, 2, 3, 3, 1, true, 0.2},  {0, 3, 4, 3, 2, true, 0.2},
                              {0, 4, 5, 3, 2, false, 0.2}, {1, 5, 6, 3, 2, false, 0.2},
                              {1, 7, 8, 3, 2, false, 0.2}, {1, 8, 9, 3, 2, false, 0.2}};
  for (const Node& n : nodes) mesh.add(n);
  for (const Element& e : elements) mesh.add(e);
  EXPECT_EQ(mesh.parts().size(), std::size(elements) - 1);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(mesh.node(i).arc, nodes[i].arc);
    EXPECT_EQ(mesh.node(i).rotates, nodes[i].rotates);
  }
  for (size_t i = 0; i < std::size(elements); ++i) {
    EXPECT_EQ(mesh.element(i).line, elements[i].line);
    EXPECT_EQ(mesh.element(i).first, elements[i].first);
    EXPECT_EQ(mesh.element(i).second, elements[i].second);
    EXPECT_EQ(mesh.element(i).type, elements[i].type);
    EXPECT_EQ(mesh.element(i).length, elements[i].length);
    EXPECT_EQ(mesh.element(i).beam, elements[i].beam);
    EXPECT_EQ(mesh.element(i).free_strain, elements[i].free_strain);
  }
  EXPECT_TRUE(mesh.any_beam());
  EXPECT_TRUE(mesh.any_cable());
}

TEST(NodeRanks, AreRuns) {
  const std::vector<int> each{0, 0, 2, 2, 2, 1, 0, 0};
  const NodeRanks ranks(each);
  EXPECT_EQ(ranks.runs().size(), 4u);
  EXPECT_EQ(ranks.of_nodes(), each);
  for (size_t n = 0; n < each.size(); ++n) EXPECT_EQ(ranks[n], each[n]);
  EXPECT_TRUE(ranks.whole(2, 3));
  EXPECT_FALSE(ranks.whole(2, 4));
  EXPECT_FALSE(ranks.whole(1, 2));
  EXPECT_TRUE(ranks.whole(6, 2)) << "up to the last node";
  EXPECT_EQ(ranks.end(1), 5);
  EXPECT_EQ(ranks.end(3), 8);
  EXPECT_EQ(ranks.size(), 8);
  NodeRanks more = NodeRanks::all_of(3, 1);
  more.append(0, 2);
  more.append(2, 1);
  more.append(1, 0);
  EXPECT_EQ(more, NodeRanks(std::vector<int>{1, 1, 1, 1, 1, 0}));
  EXPECT_EQ(more.runs().size(), 2u);
}

// Numbers of blocks and local elements of cut lines, against a count node by node.
TEST(LocalMesh, NumbersOfCutLines) {
  const Mesh mesh = build_mesh(uneven());
  std::vector<int> owner;
  for (int n = 0; n < mesh.nodes(); ++n) owner.push_back(n / 70 % 3);
  int next = 0;
  for (int rank = 0; rank < 3; ++rank) {
    const LocalMesh local = local_mesh(mesh, owner, rank, 3);
    for (int n = 0; n < mesh.nodes(); ++n) {
      if (owner[static_cast<size_t>(n)] != rank) continue;
      EXPECT_EQ(local.first_block(n), next) << n;
      next += mesh.node(n).rotates ? 2 : 1;
    }
    std::vector<int> elements;
    for (int e = 0; e < mesh.elements(); ++e)
      if (const Element g = mesh.element(e);
          owner[static_cast<size_t>(g.first)] == rank || owner[static_cast<size_t>(g.second)] == rank)
        elements.push_back(e);
    ASSERT_EQ(local.elements.size(), elements.size());
    for (size_t i = 0; i < elements.size(); ++i) {
      EXPECT_EQ(local.elements[i].global, elements[i]);
      EXPECT_EQ(local.element(local.elements[i]).first, mesh.element(elements[i]).first);
      EXPECT_EQ(local.global[static_cast<size_t>(local.elements[i].second)],
                mesh.element(elements[i]).second);
    }
  }
}

// A node at a joint has the blocks of the node whose position it shares; bodies are last; both may be on any
// rank.
TEST(LocalMesh, NumbersOfJointsAndBodies) {
  const model::Case c = io::read_case_text(R"(hawser: 1
line_types:
  bar: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, EI: 1e4, GJ: 1e4}
  rope: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, bending: false}
bodies:
  buoy: {position: [30, 0, 0], floating: {mass: 100, inertia: [1, 1, 1]}}
  clump: {position: [0, 30, 0], floating: {mass: 100, inertia: [1, 1, 1]}}
joints: {y: {start: [10, 0, 0]}}
lines:
  a: {sections: [{type: rope, length: 11, elements: 3}], end_a: {anchor: [0, 0, 0]}, end_b: {joint: y}}
  b: {sections: [{type: bar, length: 11, elements: 2}], end_a: {joint: y}, end_b: {anchor: [20, 0, 0]}}
  c: {sections: [{type: rope, length: 22, elements: 4}], end_a: {joint: y}, end_b: {body: buoy, at: [0, 0, 0]}}
  d: {sections: [{type: rope, length: 50, elements: 3}], end_a: {body: clump, at: [0, 0, 0]}, end_b: {body: buoy, at: [0, 0, 0]}}
)",
                                           HAWSER_SOURCE_DIR "/tests/mesh_joints.yaml");
  const Mesh mesh = build_mesh(c);
  int pinned = 0;
  for (const int pattern : {1, 2, 5}) {
    std::vector<int> owner;
    for (int n = 0; n < mesh.nodes(); ++n) owner.push_back((7 - n / pattern % 3) % 3);
    int next = 0;
    std::vector<int> first(static_cast<size_t>(mesh.nodes()), -1);
    for (int rank = 0; rank < 3; ++rank)
      for (int n = 0; n < mesh.nodes(); ++n)
        if (owner[static_cast<size_t>(n)] == rank && mesh.node(n).pinned_to < 0)
          first[static_cast<size_t>(n)] = std::exchange(next, next + (mesh.node(n).rotates ? 2 : 1));
    for (int rank = 0; rank < 3; ++rank) {
      const LocalMesh local = local_mesh(mesh, owner, rank, 3);
      for (int n = 0; n < mesh.nodes(); ++n) {
        const int to = mesh.node(n).pinned_to;
        pinned += to >= 0;
        EXPECT_EQ(local.first_block(n), first[static_cast<size_t>(to >= 0 ? to : n)]) << pattern << " " << n;
      }
      for (int n = 0; n < local.nodes(); ++n)
        EXPECT_EQ(local.global_block[static_cast<size_t>(local.block[static_cast<size_t>(n)])],
                  local.first_block(local.global[static_cast<size_t>(n)]));
    }
  }
  EXPECT_EQ(pinned, 3 * 3 * 2);
}

}  // namespace
}  // namespace hawser::mesh_table_test
