// Lines and bodies of a case that a rank forgets: what stays, look-up by name, and their container.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "hawser/io/case_reader.hpp"

namespace hawser::forgotten_lines_test {
namespace {

// Five lines, of which an event names the second one.
model::Case farm() {
  std::string text = R"(hawser: 1
environment: {gravity: 9.81}
line_types:
  rope: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, bending: false}
dynamics: {duration: 10}
events:
  - {release: {line: l1, end: end_a}, time: 1}
lines:
)";
  for (int i = 0; i < 5; ++i)
    text += "  l" + std::to_string(i) +
            ": {sections: [{type: rope, length: 20, elements: 2}], end_a: {anchor: [" + std::to_string(i) +
            ", 0, 0]}, end_b: {anchor: [" + std::to_string(i) + ", 10, 0]}}\n";
  return io::read_case_text(text, HAWSER_SOURCE_DIR "/tests/forgotten_lines.yaml");
}

TEST(ForgottenLines, ThoseThatTheCaseNamesStay) {
  model::Case c = farm();
  EXPECT_EQ(c.line_index("l4"), 4);  // fills the index
  c.forget_lines_and_bodies({false, false, true, false, false});
  EXPECT_EQ(c.lines.size(), 5u);
  for (size_t l = 0; l < 5; ++l) EXPECT_EQ(c.lines.has(l), l == 1 || l == 2) << l;
  EXPECT_EQ(c.line_index("l1"), 1);
  EXPECT_EQ(c.line_index("l2"), 2);
  EXPECT_EQ(c.line("l2").name, "l2");
  EXPECT_THROW(c.line_index("l4"), std::out_of_range);
  EXPECT_THROW(c.lines[4], std::logic_error);
  EXPECT_THROW(for (const model::Line& l : c.lines) EXPECT_FALSE(l.name.empty()), std::logic_error);
}

// Of a case with a body for each reason to stay, and one without.
TEST(ForgottenLines, BodiesThatLinesOrOtherObjectsNameStay) {
  const std::string fixed = ": {position: [0, 0, 0]}\n", linear = "interpolation: linear, ";
  const std::string rows = "rows: [[0, 0, 0, 0], [1, 0, 0, 1], [20, 0, 0, 0]]}}}\n";
  const std::string text = R"(hawser: 1
environment: {gravity: 9.81}
line_types:
  rope: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, bending: false}
dynamics: {duration: 10}
bodies:
  other)" + fixed + "  end" +
                           fixed + "  taker" + fixed + "  linked" + fixed + "  shown" + fixed + "  wall" +
                           fixed + "  jumps: {position: [0, 0, 0], motion: {table: {" + linear + rows +
                           "  smooth: {position: [0, 0, 0], motion: {table: {" + rows + R"(
  heavy: {position: [0, 0, 9], floating: {mass: 1, inertia: [1, 1, 1]}}
volumes:
  box: {body: wall, shape: {box: {centre: [0, 0, -99], size: [1, 1, 1]}}, normal_stiffness: {per_point: 1e6}}
links:
  spring: {end_a: {body: linked, at: [0, 0, 0]}, end_b: {body: heavy, at: [0, 0, 0]}, stiffness: 100}
events:
  - {release: {line: l0, end: end_a}, time: 1}
  - {attach: {line: l0, end: end_a, body: taker}, time: 2}
output: {histories: [{body: shown}]}
lines:
  l0: {sections: [{type: rope, length: 20, elements: 2}], end_a: {anchor: [0, 0, 0]}, end_b: {body: end, at: [0, 10, 0]}}
  l1: {sections: [{type: rope, length: 20, elements: 2}], end_a: {anchor: [9, 0, 0]}, end_b: {body: other, at: [9, 10, 0]}}
)";
  model::Case c = io::read_case_text(text, HAWSER_SOURCE_DIR "/tests/forgotten_lines.yaml");
  EXPECT_EQ(c.body_index("other"), 0);  // fills the index
  c.forget_lines_and_bodies({false, false});
  for (const std::string name : {"end", "taker", "linked", "shown", "wall", "jumps", "heavy"})
    EXPECT_GE(c.body_index(name), 0) << name;
  for (const std::string name : {"other", "smooth"}) EXPECT_EQ(c.body_index(name), -1) << name;
  EXPECT_EQ(c.bodies.size(), 9u);
  EXPECT_THROW(c.bodies[0], std::logic_error);
}

// A copy has entries of its own.
TEST(ForgottenLines, Copies) {
  model::Entries<std::string> all = {"a", "b", "c"};
  model::Entries<std::string> copy = all;
  copy[0] = "changed";
  copy.forget(1);
  EXPECT_EQ(all[0], "a");
  EXPECT_EQ(all[1], "b");
  const model::Entries<std::string> again = copy;
  EXPECT_TRUE(again.has(0) && !again.has(1) && again.has(2));
  EXPECT_EQ(again.back(), "c");
}

}  // namespace
}  // namespace hawser::forgotten_lines_test
