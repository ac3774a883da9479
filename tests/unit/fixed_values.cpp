// Which values of a case a restart compares with those of the checkpoint.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::fixed_values_test {
namespace {

using Texts = std::map<std::string, std::string>;

// A chain between an anchor and a buoy of 1 m, with a fender and a spring.
Texts fixed(const std::string& from = "", const std::string& to = "") {
  std::string text = R"(hawser: 1
line_types: {chain: {outer_diameter: 0.1, mass_per_length: 30, EA: 1e8, bending: false}}
lines:
  chain: {sections: [{type: chain, length: 100, elements: 10}], end_a: {anchor: [0, 5, 0]}, end_b: {anchor: [90, 5, 0]}}
bodies:
  buoy: {position: [0, 40, 0]}
volumes:
  fender: {shape: {sphere: {centre: [0, 0, 0.25], radius: 1}}, body: buoy, normal_stiffness: {per_point: 1e6}, friction: 0.3}
links:
  spring: {end_a: {line: chain, at: 50}, end_b: {body: buoy, at: [0, 0, 1]}, stiffness: 2e5, tension_only: true}
dynamics: {duration: 1}
)";
  if (!from.empty()) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  }
  return model::fixed_values(*io::read_case_text(text, "fixed.yaml").tree);
}

TEST(FixedValues, AreThoseOfTheKeysThatAreMarked) {
  const Texts base = fixed();
  EXPECT_EQ(base.at("volumes.fender.shape"), "[sphere: [centre: [0, 0, 0.25], radius: 1]]");
  EXPECT_EQ(base.at("volumes.fender.body"), "buoy");
  EXPECT_EQ(base.at("volumes.fender.normal_stiffness"), "[per_point: 1000000]");
  EXPECT_TRUE(base.contains("links.spring"));
  for (const auto& [key, value] : base)
    EXPECT_TRUE(key.starts_with("volumes.fender.") || key.starts_with("line_types.chain.") ||
                key == "links.spring")
        << key;
  for (const char* key : {"outer_diameter", "mass_per_length", "EA"})
    EXPECT_TRUE(base.contains(std::string("line_types.chain.") + key)) << key;
  EXPECT_FALSE(base.contains("line_types.chain.Cd_normal"));
}

TEST(FixedValues, DependOnTheValueAndNotOnHowItIsWritten) {
  const Texts base = fixed();
  for (const auto& [from, to] : {std::pair("radius: 1}", "radius: 100 cm}"),
                                 {"centre: [0, 0, 0.25], radius: 1", "radius: 1, centre: [0.0, 0, 25 cm]"},
                                 {"friction: 0.3", "friction: 0.4"},
                                 {"tension_only: true", "tension_only: True"},
                                 {"duration: 1", "duration: 2"}})
    EXPECT_EQ(fixed(from, to), base) << to;
  for (const auto& [from, to, key] :
       {std::tuple("radius: 1}", "radius: 1.001}", "volumes.fender.shape"),
        {"per_point: 1e6", "per_length: 1e6", "volumes.fender.normal_stiffness"},
        {", body: buoy", "", "volumes.fender.body"},
        {"stiffness: 2e5", "stiffness: 3e5", "links.spring"},
        {"at: 50", "at: 60", "links.spring"},
        {"EA: 1e8", "EA: 1.1e8", "line_types.chain.EA"},
        {"mass_per_length: 30", "mass_per_length: 31", "line_types.chain.mass_per_length"}}) {
    Texts other = fixed(from, to);
    Texts rest = base;
    EXPECT_NE(other[key], rest[key]) << to;
    other.erase(key);
    rest.erase(key);
    EXPECT_EQ(other, rest) << to;
  }
}

// Calls what(value) for v and all its descendants.
template <class What>
void each(const model::Value& v, const What& what) {
  what(v);
  for (size_t i = 0; i < v.items.size(); ++i) each(*model::Entry(v, i), what);
}

// The tree without the values that a run does not read still has the line numbers for messages and the values
// that a restart compares.
TEST(FixedValues, AndLinesOfKeysSurviveInATreeWithoutValues) {
  for (const char* name : {"reel", "hanging-line", "parted-mooring", "lazy-wave", "fenders", "winch"}) {
    const model::Case c =
        io::read_case(std::string(HAWSER_SOURCE_DIR) + "/cases/" + name + "/" + name + ".yaml");
    const model::Value less = model::without_values(*c.tree);
    EXPECT_EQ(model::fixed_values(less), model::fixed_values(*c.tree)) << name;
    int given = 0, kept = 0;
    each(*c.tree, [&](const model::Value& v) {
      given += v.given;
      for (const char* more : {"", ".no_such_key", "[7]"})
        EXPECT_EQ(less.line_of(v.where + more), c.tree->line_of(v.where + more))
            << name << " " << v.where << more;
    });
    each(less, [&](const model::Value&) { ++kept; });
    EXPECT_LT(kept, given) << name;
  }
}

// A line of a farm that is written in one row of the file is one entry of the tree.
TEST(FixedValues, KeepOneEntryOfALineInOneRow) {
  std::string text =
      "hawser: 1\nline_types: {chain: {outer_diameter: 0.1, mass_per_length: 30, EA: 1e8, bending: "
      "false}}\nlines:\n";
  for (int k = 0; k < 6; ++k)
    text += fmt::format(
        "  line {0}: {{sections: [{{type: chain, length: 100, elements: 10}}], end_a: {{anchor: [0, {0}0, "
        "0]}}, "
        "end_b: {{anchor: [90, {0}0, 0]}}}}\n",
        k);
  int kept = 0;
  each(model::without_values(*io::read_case_text(text, "rows.yaml").tree),
       [&](const model::Value&) { ++kept; });
  // hawser, line_types, lines and the root; the type with its keys that a restart compares
  EXPECT_LE(kept, 6 + 4 + 5);
}

}  // namespace
}  // namespace hawser::fixed_values_test
