// The schema of case files is consistent; its units, and messages with suggestions.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::model::case_schema_test {
namespace {

// Properties of a schema that the checker and the documents require.
void inspect(const Key& k, const std::string& path) {
  using Type = Key::Type;
  EXPECT_FALSE(k.required && (k.fallback || !k.fallback_note.empty())) << path << ": needed and with default";
  EXPECT_EQ(k.about.find('\n'), std::string::npos) << path;
  std::set<std::string> names;
  if (k.type == Type::map)
    for (const Key& c : k.keys) {
      EXPECT_TRUE(names.insert(c.name).second) << path << " has two keys " << c.name;
      EXPECT_FALSE(c.about.empty()) << path << "." << c.name << " has no description";
    }
  for (const Group& g : k.groups) {
    for (const std::string& key : g.keys) EXPECT_TRUE(names.count(key)) << path << ": no key " << key;
    for (const std::string& key : g.needed)
      EXPECT_TRUE(std::count(g.keys.begin(), g.keys.end(), key)) << path << ": " << key;
  }
  if (k.type == Type::one_of) {
    std::set<int> forms;  // the checker chooses among alternatives by their form, so these must differ
    for (const Key& a : k.keys) {
      const int form = a.type == Type::list || a.type == Type::vec3         ? 1
                       : a.type == Type::map || a.type == Type::map_by_name ? 2
                       : a.type == Type::number || a.type == Type::integer  ? 3
                       : a.type == Type::boolean                            ? 4
                                                                            : 5;
      EXPECT_TRUE(forms.insert(form).second) << path;
    }
  }
  for (const Key& c : k.keys) inspect(c, path + "." + c.name);
}

TEST(CaseSchema, IsWellMade) { inspect(case_schema(), "case"); }

// Paths of numbers for which words name the two ends of a line.
void arc_lengths(const Key& k, const std::string& path, std::set<std::string>& to) {
  const auto ends = [](const Key& a) { return a.words == std::vector<std::string>{"end_a", "end_b"}; };
  const auto number = [](const Key& a) { return a.type == Key::Type::number; };
  if (k.type == Key::Type::one_of && std::any_of(k.keys.begin(), k.keys.end(), ends) &&
      std::any_of(k.keys.begin(), k.keys.end(), number))
    to.insert(path);
  for (const Key& inner : k.keys) arc_lengths(inner, path + (inner.name.empty() ? "" : "." + inner.name), to);
}

// model/cut_lines.cpp has a line for each of these arc lengths. A new key for an arc length must be added
// there and here.
TEST(CaseSchema, ArcLengthsAreThoseThatACutRenumbers) {
  std::set<std::string> found;
  arc_lengths(case_schema(), "", found);
  const std::set<std::string> renumbered = {".bodies.<body>.on.at",      ".events.when.position.at",
                                            ".events.when.tension.at",   ".lines.<line>.bend_stiffeners.at",
                                            ".lines.<line>.buried.from", ".lines.<line>.buried.to",
                                            ".lines.<line>.loads.at",    ".lines.<line>.loads.from",
                                            ".lines.<line>.loads.to",    ".lines.<line>.masses.at",
                                            ".links.<link>.end_a.at",    ".links.<link>.end_b.at",
                                            ".output.histories.at"};
  EXPECT_EQ(found, renumbered);
}

TEST(CaseUnits, NumbersWithAndWithoutUnit) {
  using enum Dimension;
  const auto si = [](const char* text, Dimension d) {
    const Quantity q = parse_quantity(text, d);
    EXPECT_EQ(q.status, Quantity::Status::ok) << text;
    return q.si;
  };
  EXPECT_EQ(si("0.85", length), 0.85);
  EXPECT_EQ(si("850 mm", length), 0.85);
  EXPECT_EQ(si("850mm", length), 0.85);
  EXPECT_EQ(si("20 in", length), 0.508);
  EXPECT_EQ(si("+1.5e3", length), 1500);
  EXPECT_EQ(si(" .5 ", length), 0.5);
  EXPECT_EQ(si("-10 kN", force), -1e4);
  EXPECT_EQ(si("1 tf", force), 9806.65);
  EXPECT_EQ(si("0.2734 t/m", mass_per_length), 273.4);
  for (const char* text : {"10 kN m^2", "10 kN m2", "10 kN.m²", "10 kNm2", "10 kN·m^2"})
    EXPECT_EQ(si(text, bending_stiffness), 1e4) << text;
  EXPECT_EQ(si("100 kN/m/m", line_stiffness), 1e5);
  EXPECT_EQ(si("100 kPa", line_stiffness), 1e5);
  EXPECT_EQ(si("100 kN/m^3", area_stiffness), 1e5);
  EXPECT_DOUBLE_EQ(si("180", angle), 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(si("2 rad", angle), 2);
  EXPECT_DOUBLE_EQ(si("30 rpm", angular_velocity), 3.14159265358979323846);
  EXPECT_EQ(si("30 %", none), 0.3);
  EXPECT_EQ(si("1/7", none), 1.0 / 7);
  EXPECT_EQ(si(" 2.5/1e1 ", none), 0.25);
  EXPECT_DOUBLE_EQ(si("18 km/h", velocity), 5);
}

TEST(CaseUnits, WhatIsNoNumber) {
  using enum Dimension;
  using Status = Quantity::Status;
  for (const char* text :
       {"", " ", "x", "-", "+", "+-1", "1,5", "1.2.3", "infinity", "e5", "--1", "1_000", "12:30"})
    EXPECT_EQ(parse_quantity(text, length).status, Status::not_a_number) << text;
  for (const char* text : {".nan", ".inf", "-.inf", "nan", "inf", "1e999", "-1e999"})
    EXPECT_EQ(parse_quantity(text, length).status, Status::not_finite) << text;
  for (const char* text : {"1/", "1/x", "1/7/2", "1//7", "1/7 %"})
    EXPECT_EQ(parse_quantity(text, none).status, Status::not_a_number) << text;
  EXPECT_EQ(parse_quantity("1/0", none).status, Status::not_finite);
  EXPECT_EQ(parse_quantity("1/7", length).status, Status::wrong_unit);
  EXPECT_EQ(parse_quantity("1e306 km", length).status, Status::not_finite);
  for (const char* text : {"1 kg", "1 M", "1 mN", "1 1", "0x10", "1 m^2"})
    EXPECT_EQ(parse_quantity(text, length).status, Status::wrong_unit) << text;
  EXPECT_EQ(parse_quantity("1 m", none).status, Status::wrong_unit);
}

TEST(CaseUnits, EveryDimensionHasItsBaseUnitFirst) {
  for (int i = 0; i <= static_cast<int>(Dimension::inertia_per_length); ++i) {
    const Dimension d = static_cast<Dimension>(i);
    const Quantity bare = parse_quantity("2", d);
    EXPECT_EQ(bare.status, Quantity::Status::ok);
    if (d == Dimension::none) continue;
    const Quantity named = parse_quantity("2 " + std::string(base_unit(d)), d);  // as the tables print it
    EXPECT_EQ(named.status, Quantity::Status::ok) << base_unit(d);
    EXPECT_EQ(named.si, bare.si) << base_unit(d);
  }
}

TEST(CaseNearest, FindsWhatWasMeant) {
  const std::vector<std::string> keys = {"EA", "EI", "GA", "GJ", "length", "element_length", "elements"};
  EXPECT_EQ(nearest("lenght", keys), "length");
  EXPECT_EQ(nearest("ea", keys), "EA");
  EXPECT_EQ(nearest("Ei", keys), "EI");
  EXPECT_EQ(nearest("element", keys), "elements");
  EXPECT_EQ(nearest("volume", keys), "");
  EXPECT_EQ(nearest("anything", std::vector<std::string>{}), "");
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("abc", "acb"), 1);
  EXPECT_EQ(quote("a\nb"), "'a?b'");
  EXPECT_EQ(enumerate({"a", "b", "c"}), "a, b or c");
}

TEST(CaseValue, LinesOfPaths) {
  Value root, list, inner;
  inner.kind = Value::Kind::scalar;
  inner.line = 7;
  list.kind = Value::Kind::list;
  list.line = 5;
  list.items = {inner, inner};
  root.kind = Value::Kind::map;
  root.line = 1;
  root.keys = {"a"};
  root.items = {list};
  EXPECT_EQ(root.line_of("a[1]"), 7);
  EXPECT_EQ(root.line_of("a[1].deeper.still"), 7);
  EXPECT_EQ(root.line_of("a[9]"), 5);
  EXPECT_EQ(root.line_of("b"), 1);
  EXPECT_THROW(root["b"], std::out_of_range);
}

}  // namespace
}  // namespace hawser::model::case_schema_test
