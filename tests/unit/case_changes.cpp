// Changes of a case by --set: the changed places, and messages about changes that are not possible.
#include "hawser/io/case_changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/io/yaml_document.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::case_changes_test {
namespace {

const std::string kCase = R"(hawser: 1
title: two lines
environment:
  water: {depth: 100}
  waves: {jonswap: {hs: 2, tp: 9}}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e7, bending: false}
lines:
  long rope:
    sections: [{type: rope, length: 100, elements: 10}, {type: rope, length: 20, elements: 2}]
    end_a: {anchor: [0, 0, -60]}
    end_b: {anchor: [80, 0, -10]}
  other:
    sections: [{type: rope, length: 60, elements: 6}]
    end_a: {anchor: [0, 50, -40]}
    end_b: {anchor: [40, 50, -10]}
statics: {tolerance: 1.0e-8}
dynamics: {duration: 1, step: 0.1}
)";

model::Case read(const std::vector<std::string>& changes) {
  return io::read_case_text(kCase, "two.yaml", {}, MPI_COMM_SELF, changes);
}

std::string message_of(const std::string& change) {
  try {
    read({change});
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(CaseChanges, AreMadeInTheDocument) {
  const std::vector<std::string> changes{"lines.long rope.sections[1].length=25",
                                         "lines[1].end_b.anchor[0]=42 m",
                                         "dynamics.duration=0.5",
                                         "environment.waves={regular: {height: 1, period: 8}}",
                                         "output.every=0.25",
                                         "statics=null",
                                         "contact.between_lines.friction=0.2",
                                         "dynamics.duration=0.75"};
  const model::Case c = read(changes);
  EXPECT_EQ(c.lines[0].sections[1].length, 25);
  EXPECT_EQ(c.lines[1].end_b.at, Vec3(42, 50, -10));
  EXPECT_EQ(c.dynamics.duration, 0.75);
  ASSERT_EQ(c.environment.water.waves.systems.size(), 1U);
  EXPECT_EQ(c.environment.water.waves.systems[0].kind, model::WaveSystem::Kind::regular);
  EXPECT_EQ(c.output.every, 0.25);
  EXPECT_EQ(c.contact.between_lines.general.friction, 0.2);
  EXPECT_EQ(c.changes, changes);
  EXPECT_EQ(c.text, kCase);
  const std::vector<std::string> notes{
      "--set lines.long rope.sections[1].length=25 (in the file 20)",
      "--set lines.other.end_b.anchor[0]=42 m (in the file 40)",
      "--set dynamics.duration=0.5 (in the file 1)",
      "--set environment.waves={regular: {height: 1, period: 8}} (given in line 5 of the file)",
      "--set output.every=0.25 (not in the file)",
      "--set statics=null (given in line 17 of the file)",
      "--set contact.between_lines.friction=0.2 (not in the file)",
      "--set dynamics.duration=0.75 (set before)"};
  EXPECT_EQ(c.change_notes, notes);
  for (const std::string& n : c.notes) EXPECT_FALSE(n.starts_with("--set")) << n;
}

// If the search finds other lengths, the case repeats the notes about its changes, and their warnings appear
// once.
TEST(CaseChanges, AreReportedForACaseWithOtherLengths) {
  const model::Case c = read({"dynamics.step=0.5"});
  const auto warnings = [](const model::Case& of) {
    return std::count_if(of.notes.begin(), of.notes.end(), [](const std::string& n) {
      return n.starts_with("two.yaml with --set: dynamics.step: 0.5 s is 18 steps");
    });
  };
  EXPECT_EQ(warnings(c), 1);
  const model::Case other = io::with_lengths(c, {{"lines.other.sections[0]", 61}});
  EXPECT_EQ(other.lines[1].sections[0].length, 61);
  EXPECT_EQ(other.change_notes, std::vector<std::string>{"--set dynamics.step=0.5 (in the file 0.1)"});
  EXPECT_EQ(warnings(other), 1);
}

TEST(CaseChanges, LeaveAllElseAsItIs) {
  model::Value root = io::parse_yaml(kCase, "two.yaml");
  const std::vector<std::string> keys = model::find_entry(root["lines"], "other")->keys;
  io::change_document(root, {"lines.other.end_a.clamped=false", "lines.other.end_a.clamped=null"},
                      "two.yaml");
  EXPECT_EQ(root["lines"]["other"].keys, keys);
  EXPECT_FALSE(root["lines"]["other"]["end_a"].has("clamped"));
  EXPECT_EQ(root["lines"]["other"]["end_a"]["anchor"].items[1].text, "50");
  EXPECT_EQ(root["lines"]["other"]["end_a"].line, 15);
}

TEST(CaseChanges, ThatCannotBeMadeAreRefusedWithOneSentence) {
  struct Refusal {
    const char* change;
    std::vector<std::string> parts;
  };
  const Refusal refusals[] = {
      {"dynamics.duration", {"two.yaml with --set dynamics.duration: is not KEY=VALUE"}},
      {"=3", {"is not KEY=VALUE"}},
      {"dynamics.duration=", {"has nothing after the '='"}},
      {"dynamics.duration=[1",
       {"'[1' is not a YAML value: the bracket [ that opens in this line is not closed"}},
      {"dynamics..duration=1", {"a name is missing in the key"}},
      {"lines.other.sections[x].length=1", {"brackets hold the number of a place in a list"}},
      {"dynamics.duratoin=1", {"dynamics: unknown key 'duratoin'; did you mean 'duration'?"}},
      {"dynamic.duration=1", {"unknown key 'dynamic'; did you mean 'dynamics'?"}},
      {"environment.waves.Hs=4", {"did you mean 'environment.waves.jonswap.hs'?"}},
      {"lines.other.length=70", {"did you mean 'lines.other.sections[0].length'?"}},
      {"lines.othr.sections[0].length=70",
       {"lines: there is no 'othr'; did you mean 'other'? (there are: long rope and other)"}},
      {"lines[2].sections[0].length=70", {"lines: has no [2]: there are 2, from [0] to [1]"}},
      {"lines.other.sections.length=70", {"is a list: give a place in it, 'lines.other.sections[0]'"}},
      {"lines.other.sections[1].length=70",
       {"lines.other.sections: has no [1]: there are 1, from [0] to [0]"}},
      {"lines.other.sections[0]=null", {"'null' removes keys, not entries of lists"}},
      {"lines.other.end_a[1]=3", {"lines.other.end_a: is 'free' or a map with the keys anchor,"}},
      {"dynamics.step.length=1", {"dynamics.step", "has no keys"}},
      {"title.short=1", {"title: is text, which has no keys"}},
      {"dynamics.duration=long",
       {"two.yaml with --set: dynamics.duration: expected a number [s], found 'long'"}},
      {"dynamics.duration=10 kg", {"two.yaml with --set: dynamics.duration: wrong unit 'kg'"}},
      {"dynamics={durations: 3}",
       {"two.yaml with --set: dynamics.durations: unknown key; did you mean 'duration'?"}},
      {"lines.other.end_a.anchor=1,2,3",
       {"lines.other.end_a.anchor: expected a list of 3 numbers [m], found '1,2,3'; a list stands in "
        "brackets, "
        "for the shell in quotes: --set 'KEY=[1, 2, 3]'"}},
      {"dynamics.duration=null", {"dynamics.duration: required key is missing"}},
      {"environment.waves.regular={height: 1, period: 8}", {"'regular' and 'jonswap' exclude each other"}},
      {"lines.other.sections[0].length=4",
       {"the line is 4 m long but its ends are 50 m apart",
        "(the case is changed by --set lines.other.sections[0].length=4)"}},
  };
  for (const Refusal& r : refusals) {
    const std::string message = message_of(r.change);
    EXPECT_FALSE(message.empty()) << r.change << " was accepted";
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const std::string& part : r.parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
  }
}

TEST(CaseChanges, KeysFurtherDownAreFound) {
  const model::Key& root = model::case_schema();
  EXPECT_EQ(model::place_below(root, "HS"), "environment.waves.jonswap.hs");
  EXPECT_EQ(model::place_below(root, "duration"), "dynamics.duration");
  EXPECT_EQ(model::place_below(root, "nowhere"), "");
  EXPECT_EQ(model::place_below(root, "dynamics"), "") << "is a key of its own";
}

}  // namespace
}  // namespace hawser::case_changes_test
