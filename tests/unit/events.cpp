// Reading of events, and division of lines that events cut.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "hawser/io/case_reader.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/model/check.hpp"

namespace hawser::events_test {
namespace {

const char* const kCase = R"(hawser: 1
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, bending: false, thermal_expansion: 1e-5}
  pipe: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, EI: 1e4, GJ: 1e4}
bodies:
  ship: {position: [0, 0, 0]}
lines:
  hose:
    sections:
      - {type: rope, length: 40, elements: 8, grading: 4}
      - {type: pipe, length: 60, elements: 12}
    end_a: {anchor: [0, 0, 0]}
    end_b: {body: ship, at: [90, 0, 0]}
    masses: [{at: 10, mass: 1}, {at: 50, mass: 2}, {at: end_b, mass: 3}]
    loads: [{per_length: [0, 0, -1], from: 10, to: 90}, {at: 85, force: [1, 0, 0]}]
    temperature_change: [[0, 10], [100, 30]]
  other:
    sections: [{type: rope, length: 10, elements: 2}]
    end_a: {anchor: [0, 50, 0]}
    end_b: {anchor: [0, 60, 0]}
contact: {lines: [hose], between_lines: {self: false, exclude: [[hose, other]]}}
dynamics: {duration: 10}
events:
EVENTS
output: {histories: [{line: hose, at: 20}, {line: hose, at: 25}, {line: hose, at: end_b}], clearances: [{line: hose, other_line: other}]}
)";

model::Case read(const std::string& events) {
  std::string text = kCase;
  text.replace(text.find("EVENTS"), 6, events);
  return io::read_case_text(text,
                            (std::filesystem::path(HAWSER_SOURCE_DIR) / "tests/data/bad/text.yaml").string());
}

TEST(Events, ALineIsDividedWhereItIsCut) {
  const model::Case c = read(
      "  - {cut: {line: hose, at: 20}, time: 1}\n  - {cut: {line: hose, at: 70}, when: {tension: {line: "
      "hose, at: 80, "
      "above: 5}}}\n  - {release: {line: hose, end: end_b}, time: 2}");
  ASSERT_EQ(c.lines.size(), 4u);
  const std::string names[] = {"hose", "hose part 2", "hose part 3", "other"};
  for (size_t l = 0; l < 4; ++l) EXPECT_EQ(c.lines[l].name, names[l]);
  const double lengths[] = {20, 50, 30};
  int elements = 0;
  for (size_t l = 0; l < 3; ++l) {
    EXPECT_DOUBLE_EQ(model::length_of(c.lines[l]), lengths[l]);
    EXPECT_EQ(c.lines[l].masses.size(), 1u);
    for (const model::Section& s : c.lines[l].sections) elements += s.elements;
  }
  EXPECT_EQ(elements, 20);
  EXPECT_DOUBLE_EQ(c.lines[1].masses[0].at, 30);
  EXPECT_DOUBLE_EQ(c.lines[2].masses[0].at, 30);
  ASSERT_EQ(c.lines[0].loads.size() + c.lines[1].loads.size() + c.lines[2].loads.size(), 3u);
  EXPECT_DOUBLE_EQ(c.lines[0].loads[0].from, 10);
  EXPECT_DOUBLE_EQ(c.lines[0].loads[0].to, 20);
  EXPECT_DOUBLE_EQ(c.lines[2].loads[0].to, 20);
  EXPECT_DOUBLE_EQ(c.lines[2].point_loads.at(0).at, 15);
  EXPECT_DOUBLE_EQ(model::mean_temperature_change(c.lines[1], 0, 50), 10 + 20 * 0.45);
  // Elements of the graded section keep their lengths as far as the cut allows.
  const model::Section& a = c.lines[0].sections[0];
  const model::Section& b = c.lines[1].sections[0];
  EXPECT_EQ(a.elements + b.elements, 8);
  EXPECT_NEAR(std::pow(a.grading, 1.0 / (a.elements - 1)), std::pow(4, 1.0 / 7), 1e-12);
  EXPECT_NEAR(std::pow(b.grading, 1.0 / (b.elements - 1)), std::pow(4, 1.0 / 7), 1e-12);

  ASSERT_EQ(c.joints.size(), 2u);
  EXPECT_FALSE(c.joints[0].rigid);  // a rope is cut
  EXPECT_TRUE(c.joints[1].rigid);
  EXPECT_EQ(c.events[0].action.line, "hose part 2");
  EXPECT_EQ(c.events[0].action.line_end, LineEnd::A);
  EXPECT_EQ(c.events[1].action.line, "hose part 3");
  EXPECT_EQ(c.events[1].cause.line, "hose part 3");
  EXPECT_DOUBLE_EQ(c.events[1].cause.arc, 10);
  EXPECT_EQ(c.events[2].action.line, "hose part 3");
  EXPECT_EQ(c.events[2].action.line_end, LineEnd::B);
  ASSERT_GE(c.notes.size(), 2u);
  EXPECT_EQ(std::vector<std::string>(c.notes.end() - 2, c.notes.end()),
            (std::vector<std::string>{
                "lines.hose: what is beyond its cut at 20 m is 'hose part 2' in results, with "
                "arc lengths from there",
                "lines.hose: what is beyond its cut at 70 m is 'hose part 3' in results, with "
                "arc lengths from there"}));

  const auto& h = c.output.histories;
  EXPECT_EQ(h[0].line + h[1].line + h[2].line, "hosehose part 2hose part 3");
  EXPECT_DOUBLE_EQ(h[0].at, 20);
  EXPECT_DOUBLE_EQ(h[1].at, 5);
  EXPECT_DOUBLE_EQ(h[2].at, 30);
  EXPECT_EQ(c.output.clearances.size(), 3u);
  EXPECT_EQ(c.contact.lines.size(), 3u);
  EXPECT_EQ(c.contact.between_lines.exclude.size(),
            3u + 3u);  // three parts with the other line, and three pairs of parts

  const Mesh m = build_mesh(c);
  const LineSpan& first = m.lines[0];
  const LineSpan& second = m.lines[1];
  EXPECT_EQ(m.node(static_cast<size_t>(second.first_node)).tied_to, first.first_node + first.nodes - 1);
  EXPECT_EQ(m.node(static_cast<size_t>(second.first_node)).pinned_to, -1);
}

TEST(Events, WhatTheyWaitFor) {
  const model::Case c = read(
      "  - {name: go, release: {line: hose, end: end_b}, when: {position: {body: ship, axis: y, below: "
      "-3}}}\n"
      "  - {attach: {line: hose, end: end_b, body: ship, at: [1, 2, 3], within: 0.5, clamped: true}}\n"
      "  - {cut: {line: other, at: 5}, tension: 2 kN}\n"
      "  - {release: {line: other, end: end_b}, after: go, delay: 3}");
  using model::Cause;
  EXPECT_EQ(c.events[0].cause.kind, Cause::Kind::position);
  EXPECT_EQ(c.events[0].cause.axis, 1);
  EXPECT_TRUE(c.events[0].cause.below);
  EXPECT_DOUBLE_EQ(c.events[0].cause.limit, -3);
  EXPECT_EQ(c.events[1].cause.kind, Cause::Kind::near);
  EXPECT_TRUE(c.events[1].action.clamped);
  EXPECT_EQ(c.events[2].cause.kind, Cause::Kind::tension);
  EXPECT_DOUBLE_EQ(c.events[2].cause.limit, 2000);
  EXPECT_DOUBLE_EQ(c.events[2].cause.arc, 5);
  EXPECT_EQ(c.events[3].cause.event, "go");
  EXPECT_DOUBLE_EQ(c.events[3].cause.time, 3);
  EXPECT_EQ(c.events[2].name, "line other cut at 5 m");
}

}  // namespace
}  // namespace hawser::events_test
