// Lines and bodies of a case file are stored as bytes: unpacked, they equal the original, with the line
// numbers of the file and as checked.
#include "hawser/model/packed_value.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "hawser/io/case_reader.hpp"
#include "hawser/io/yaml_document.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::packed_value_test {
namespace {

using model::Value;

void expect_same(const Value& a, const Value& b) {
  EXPECT_EQ(a.kind, b.kind) << a.text;
  EXPECT_EQ(a.text, b.text);
  EXPECT_EQ(a.quoted, b.quoted) << a.text;
  EXPECT_EQ(a.line, b.line) << a.text;
  EXPECT_EQ(a.keys, b.keys);
  ASSERT_EQ(a.items.size(), b.items.size()) << a.text;
  for (size_t i = 0; i < a.items.size(); ++i) expect_same(a.items[i], b.items[i]);
}

// Long texts and lists, empty ones, quotes, and an alias of an earlier entry.
TEST(PackedValue, ComesBackAsItWas) {
  std::string text =
      "first: &one {a: [1, 2],\n  b: {c: 'd'}}\nmany:\n  quoted: \"0\"\n  none:\n  empty: [[], {}]\n  "
      "long: " +
      std::string(20000, 'x') + "\n  list:\n";
  for (int k = 0; k < 300; ++k) text += fmt::format("    - [{}, 1 m]\n", k);
  text += "  alias: *one\n  last: true\n";
  const Value root = io::parse_yaml(text, "any.yaml");
  Value packed = root;
  model::pack(packed);
  EXPECT_EQ(packed.kind, Value::Kind::packed);
  EXPECT_TRUE(packed.items.empty());
  expect_same(model::unpacked(packed), root);
  expect_same(*model::find_entry(packed, "first"), root["first"]);
  EXPECT_FALSE(model::find_entry(packed, "second"));
}

const std::string kCase = R"(hawser: 1
line_types: {chain: {outer_diameter: 0.1, mass_per_length: 30, EA: 1e8, bending: false}}
bodies: {buoy: {position: [0, 40, 0]}}
lines:
  chain:
    sections:
      - {type: chain, length: 0.1 km, elements: 10}
    end_a:
      {anchor: [0, 5, 0]}
    end_b:
      anchor: [90,
               5, 0]
)";

TEST(PackedValue, EntriesOfACaseAreOpenedAsTheyWereChecked) {
  const model::Case c = io::read_case_text(kCase, "packed.yaml");
  const Value& lines = (*c.tree)["lines"];
  EXPECT_EQ(lines.items[0].kind, Value::Kind::packed);
  EXPECT_EQ((*c.tree)["bodies"].items[0].kind, Value::Kind::packed);
  EXPECT_EQ((*c.tree)["line_types"].items[0].kind, Value::Kind::map);
  const model::Entry chain(lines, 0);
  const Value& length = (*chain)["sections"].items[0]["length"];
  EXPECT_EQ(length.number, 100);
  EXPECT_EQ(length.where, "lines.chain.sections[0].length");
  EXPECT_EQ(length.line, 7);
  EXPECT_FALSE((*chain)["masses"].given);
  EXPECT_EQ((*chain)["end_b"]["anchor"].items[1].where, "lines.chain.end_b.anchor[1]");
  EXPECT_EQ(c.tree->line_of("lines.chain.end_b.anchor[1]"), 12);
  EXPECT_EQ(c.tree->line_of("lines.chain.end_a"), 8);
  EXPECT_EQ(c.lines[0].sections[0].length, 100);
}

// A tree that is reduced to what a run needs stores its line numbers in a few bytes if each object is in one
// line of the file.
TEST(PackedValue, ReducedTreesHavePackedMaps) {
  std::string text = kCase.substr(0, kCase.find("bodies:")) + "lines:\n";
  for (int k = 0; k < 100; ++k)
    text += fmt::format(
        "  line {}: {{sections: [{{type: chain, length: 100, elements: 10}}], end_a: {{anchor: [0, {}, 0]}}, "
        "end_b: {{anchor: [90, {}, 0]}}}}\n",
        k, 10 * k, 10 * k);
  const Value less = model::without_values(*io::read_case_text(text, "rows.yaml").tree);
  EXPECT_EQ(less["lines"].kind, Value::Kind::packed);
  EXPECT_LT(less["lines"].text.size(), 100u * 15);
  EXPECT_EQ(less.line_of("lines.line 42.end_a.anchor"), 46);
  EXPECT_EQ(model::find_entry(less["lines"], "line 99")->line, 103);
}

}  // namespace
}  // namespace hawser::packed_value_test
