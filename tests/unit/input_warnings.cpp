// Possible but unusual input gives a warning; ordinary input gives none.
#include "hawser/advice/input_warnings.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/longest_step.hpp"

namespace hawser::input_warnings_test {
namespace {

namespace fs = std::filesystem;

// A chain from an anchor on the bed to a vessel that heaves, in waves and a current.
const std::string kCase = R"(hawser: 1
environment:
  water: {depth: 200}
  seabed: {depth: 200, friction: 0.6}
  waves: {jonswap: {hs: 5, tp: 11}}
  current: {speed: 0.2, direction_deg: 90}
line_types:
  chain: {outer_diameter: 0.25, mass_per_length: 390, EA: 1.6e9, bending: false, breaking_load: 1.3e7}
bodies:
  vessel: {motion: {harmonic: {amplitude: [0, 0, 2], period: 10}, ramp: 10}}
lines:
  mooring:
    sections: [{type: chain, length: 760, elements: 76}]
    end_a: {anchor: [700, 0, -200]}
    end_b: {body: vessel, at: [0, 0, 0]}
dynamics: {duration: 60, step: 0.1}
output: {every: 1}
)";

using Changes = std::vector<std::pair<std::string, std::string>>;

std::vector<std::string> notes(const Changes& changes, const std::vector<std::string>& set = {}) {
  std::string text = kCase;
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  const model::Case c = io::read_case_text(text, "slips.yaml", {}, MPI_COMM_SELF, set);
  EXPECT_GE(c.notes.size(), advice::input_notes(c).size());
  return advice::input_notes(c);
}

// Expects one warning that contains `part`.
void expect_warning(const Changes& changes, const std::string& part) {
  const std::vector<std::string> found = notes(changes);
  ASSERT_EQ(found.size(), 1U) << part << "\n" << testing::PrintToString(found);
  EXPECT_NE(found.front().find(part), std::string::npos) << part << "\n" << found.front();
}

TEST(InputWarnings, NoneOfAnOrdinaryCase) { EXPECT_EQ(notes({}), std::vector<std::string>{}); }

TEST(InputWarnings, NoneOfAnyShippedCase) {
  int cases = 0;
  for (const auto& entry : fs::recursive_directory_iterator(HAWSER_SOURCE_DIR "/cases")) {
    if (entry.path().extension() != ".yaml") continue;
    ++cases;
    try {
      const model::Case c = io::read_case(entry.path().string());
      EXPECT_EQ(advice::input_notes(c), std::vector<std::string>{});
    } catch (const std::exception& e) {
      // The case needs third-party coefficients, which a user puts beside it.
      if (std::string(e.what()).find("there is no such file, which has added mass") == std::string::npos)
        throw;
      printf("excluded: %s\n", e.what());
    }
  }
  EXPECT_GE(cases, 16);
}

// In deep water, waves of 11 s have a speed of g 11/2 pi = 17.2 m/s; a current across them has no effect.
TEST(InputWarnings, LinearWavesOnACurrent) {
  const auto current = [](const std::string& with) {
    return Changes{{"{speed: 0.2, direction_deg: 90}", with}};
  };
  EXPECT_TRUE(notes(current("{speed: 1.7, ramp: 5}")).empty());
  EXPECT_TRUE(notes(current("{speed: 3, direction_deg: 90, ramp: 5}")).empty());
  expect_warning(
      current("{speed: 1.75, ramp: 5}"),
      "environment.waves.jonswap: the current of 1.75 m/s along the waves of 11 s is 10 % of "
      "their speed, and linear waves here neglect that the current makes them longer and flatter;");
  expect_warning(current("{speed: 2, direction_deg: 150, ramp: 5}"),
                 "of 1.73 m/s against the waves of 11 s is 10 % of their speed, and linear waves here "
                 "neglect that the current makes them shorter and steeper;");
  Changes stokes = current("{speed: 2, direction_deg: 180, ramp: 5}");
  stokes.push_back({"jonswap: {hs: 5, tp: 11}", "stokes: {height: 5, period: 11}"});
  EXPECT_TRUE(notes(stokes).empty());
  stokes.back().second = "sum: [{jonswap: {hs: 5, tp: 11, direction_deg: 90}}, {jonswap: {hs: 1, tp: 11}}]";
  expect_warning(stokes, "environment.waves.sum[1].jonswap: the current of 2 m/s against the waves of 11 s");
  stokes.back().second =
      "components: [{height: 1, period: 4}, {height: 5, period: 11}, {height: 1, period: 20}]";
  expect_warning(stokes, "of 2 m/s against the waves of 11 s is 12 %");
}

// The case without weight and water, in which a changed line type causes no other warnings about the line.
Changes weightless(const std::string& from, const std::string& to) {
  return {{from, to},
          {"environment:", "environment:\n  gravity: 0"},
          {"  water: {depth: 200}\n", ""},
          {"  waves: {jonswap: {hs: 5, tp: 11}}\n", ""},
          {"  current: {speed: 0.2, direction_deg: 90}\n", ""}};
}

TEST(InputWarnings, MassDiameterAndStiffness) {
  expect_warning({{"outer_diameter: 0.25", "outer_diameter: 0.14"}},
                 "slips.yaml:8: line_types.chain: 390 kg/m in a diameter of 0.14 m is a density of 25.3 "
                 "t/m³, more than steel "
                 "(7.85); for a chain give the diameter of a round bar of equal volume");
  EXPECT_TRUE(notes(weightless("outer_diameter: 0.25", "outer_diameter: 0.14")).empty());
  expect_warning(weightless("mass_per_length: 390", "mass_per_length: 390000"),
                 "is it in kg/km? ('390000 kg/km')");
  expect_warning(weightless("outer_diameter: 0.25, mass_per_length: 390, EA: 1.6e9",
                            "outer_diameter: 250, mass_per_length: 390, EA: 1.6e14"),
                 "is it in mm? ('250 mm')");
  expect_warning({{"EA: 1.6e9", "EA: 1.6e11"}},
                 "is a modulus of 3.26e+03 GPa; that of a solid steel bar is 206");
  expect_warning(weightless("EA: 1.6e9", "EA: 1.6e3"), "less than that of rubber (1 to 10)");
}

TEST(InputWarnings, ContentsAndCoatings) {
  const auto pipe = [](const std::string& more) {
    return weightless(
        "chain: {outer_diameter: 0.25, mass_per_length: 390, EA: 1.6e9, bending: false, breaking_load: "
        "1.3e7}",
        "chain: {pipe: {outer_diameter: 0.3, wall_thickness: 0.02" + more + "}");
  };
  const auto contents = [&](const std::string& density) {
    return pipe("}, contents: {density: " + density + "}");
  };
  EXPECT_EQ(notes(contents("800")), std::vector<std::string>{});
  EXPECT_EQ(notes(contents("0")), std::vector<std::string>{});  // empty
  expect_warning(contents("0.8"),
                 "slips.yaml:6: line_types.chain.contents.density: 0.8 kg/m³ is lighter than usual contents "
                 "of pipes (10 "
                 "to 5000); is it in t/m³ or g/cm³? ('800 kg/m3')");
  expect_warning(contents("8000"),
                 "8000 kg/m³ is heavier than usual contents of pipes (10 to 5000); is it meant?");
  const auto coating = [&](const std::string& thickness) {
    return pipe(", coatings: [{thickness: 3 mm, density: 900}, {thickness: " + thickness +
                ", density: 700}]}");
  };
  EXPECT_EQ(notes(coating("40 mm")), std::vector<std::string>{});
  expect_warning(
      coating("4"),
      "line_types.chain.pipe.coatings[1].thickness: a coating of 4 m is thicker than half of the pipe "
      "of 0.3 m; is it in mm? ('4 mm')");
}

// Pipes with code checks: DNV-ST-F101 5.4.6 from 15 to 45, API RP 1111 4.3.2.2 up to 50.
TEST(InputWarnings, SlendernessOfPipesByCodes) {
  const auto pipe = [](const std::string& wall, const std::string& grade = ", grade: X65") {
    return weightless(
        "chain: {outer_diameter: 0.25, mass_per_length: 390, EA: 1.6e9, bending: false, breaking_load: "
        "1.3e7}",
        "chain: {pipe: {outer_diameter: 0.3, wall_thickness: " + wall + grade + "}}");
  };
  for (const char* wall : {"0.02", "0.00666667", "0.0199"})  // 15, 45, 15.1
    EXPECT_EQ(notes(pipe(wall)), std::vector<std::string>{}) << wall;
  expect_warning(pipe("0.021"),
                 "slips.yaml:6: line_types.chain.pipe.wall_thickness: D/t is 14.3, and DNV-ST-F101's "
                 "formulas for combined loads apply from 15 to 45: 'dnv_local_buckling' does not apply to "
                 "this pipe; give it another wall thickness, or check it by other means");
  expect_warning(pipe("0.00625"), "D/t is 48, and DNV-ST-F101's formulas");
  const std::vector<std::string> both = notes(pipe("0.005"));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NE(both[1].find("D/t is 60, and API RP 1111's formula for bending with pressure applies up to 50: "
                         "'api_bending_pressure' does not apply"),
            std::string::npos)
      << both[1];
  EXPECT_EQ(notes(pipe("0.005", "")), std::vector<std::string>{});  // without code checks
}

TEST(InputWarnings, StiffnessOfTheBed) {
  const auto bed = [](const std::string& stiffness) {
    return Changes{{"friction: 0.6", "friction: 0.6, normal_stiffness: " + stiffness}};
  };
  for (const char* soil :
       {"{per_area: 100 kN/m3}", "{per_area: 5000}", "{per_length: 2 kN/m2}", "{per_length: 4200 kN/m2}"})
    EXPECT_EQ(notes(bed(soil)), std::vector<std::string>{}) << soil;
  expect_warning(bed("{per_area: 200}"),
                 "slips.yaml:4: environment.seabed.normal_stiffness: 200 N/m³ is softer than any soil; usual "
                 "values are 50 "
                 "to 10000 kN/m³; is it in kN? ('200 kN/m3')");
  expect_warning(bed("{per_length: 100}"),
                 "100 N/m² is softer than any soil; usual values are 50 to 5000 kN/m²; "
                 "is it in kN? ('100 kN/m2')");
  expect_warning(bed("{per_area: 1e11}"),
                 "1e+11 N/m³ is stiffer than any soil; usual values are 50 to 10000 kN/m³");
}

TEST(InputWarnings, TensionsOfLinesAndLengths) {
  expect_warning(
      {{"length: 760", "length: 715"}},
      "slips.yaml:13: lines.mooring.sections: a length of 715 m over a distance of 728.011 m between its "
      "ends requires a tension of at least 2.912e+04 kN, and the breaking load of 'chain' is 1.3e+04 "
      "kN");
  expect_warning({{"length: 760", "length: 715"}, {", breaking_load: 1.3e7", ""}},
                 "by 1.82 %; usual is less than 1 %");
  expect_warning({{"EA: 1.6e9", "EA: 6.0e6"}, {", breaking_load: 1.3e7", ""}},
                 "its own weight over 200 m of height requires");
  expect_warning({{"end_b: {body: vessel, at: [0, 0, 0]}",
                   "end_b: free\n    loads: [{at: end_b, force: [2.0e7, 0, 0]}]"}},
                 "lines.mooring.loads[0]: its force requires a tension of at least 2e+04 kN");
  expect_warning({{"length: 760", "length: 8000"}, {"  current: {speed: 0.2, direction_deg: 90}\n", ""}},
                 "the line is 8000 m long, 11 times the distance between its ends (728.011 m)");
  expect_warning({{"elements: 76", "elements: 2"}},
                 "lines.mooring.sections: 2 elements for a line that is 4.4 % longer than the distance "
                 "between its ends: its curved shape needs twenty elements or more");
  // The stock of a feeder does not count in the length of the span.
  expect_warning({{"length: 760", "length: 755"},
                  {"end_b: {body: vessel, at: [0, 0, 0]}",
                   "end_b: {body: vessel, at: [0, 0, 0], feed: {stock: 40, speed: 0}}"}},
                 "lines.mooring.sections: a length of 715 m over a distance of 728.011 m");
}

TEST(InputWarnings, Depths) {
  expect_warning({{"water: {depth: 200}", "water: {depth: 20}"}},
                 "slips.yaml:4: environment.seabed.depth: the seabed is 200 m below the still water, but the "
                 "water depth is 20 m");
  expect_warning(
      {{"  seabed: {depth: 200, friction: 0.6}\n", ""}, {"anchor: [700, 0, -200]", "anchor: [700, 0, 200]"}},
      "is 200 m above the water, whose depth is 200 m: z points up; is -200 meant?");
  expect_warning({{"anchor: [700, 0, -200]", "anchor: [700, 0, -160]"}},
                 "is 40 m above the seabed, which is at z = -200 m");
  expect_warning({{"water: {depth: 200}", "water: {}"}, {"depth: 200, friction", "depth: 2000, friction"}},
                 "no line reaches the seabed at z = -2000 m: the deepest, if it hung straight down, would "
                 "reach z = -480 m");
}

TEST(InputWarnings, SlackOnTheBedInACurrent) {
  expect_warning({{"length: 760", "length: 880"}}, "bends them about 17 m sideways");  // a run: 17.1 m
  EXPECT_TRUE(
      notes({{"length: 760", "length: 880"}, {"direction_deg: 90", "direction_deg: 90, ramp: 20"}}).empty());
  EXPECT_TRUE(notes({{"length: 760", "length: 880"}, {"direction_deg: 90", "direction_deg: 0"}}).empty());
  EXPECT_TRUE(notes({{"length: 760", "length: 880"},
                     {"speed: 0.2, direction_deg: 90", "speed: 0.2, exponent: 1/7, direction_deg: 90"}})
                  .empty());
}

TEST(InputWarnings, Times) {
  expect_warning({{"step: 0.1", "step: 1"}},
                 "dynamics.step: 1 s is 10 steps in a period of the motion of body vessel (10 s)");
  expect_warning(
      {{"{harmonic: {amplitude: [0, 0, 2], period: 10}, ramp: 10}", "{velocity: [0.01, 0, 0], ramp: 10}"},
       {"  waves: {jonswap: {hs: 5, tp: 11}}\n", ""},
       {"step: 0.1", "step: 12"}},
      "steps in the longest natural period of line mooring");
  expect_warning({{"every: 1", "every: 100"}}, "output.every: 100 s is longer than the run (60 s)");
  expect_warning({{"every: 1", "every: 8"}},
                 "8 s is 1.2 outputs in a period of the motion of body vessel (10 s)");
  expect_warning(
      {{"period: 10}, ramp: 10}", "period: 10}}"}},
      "bodies.vessel.motion: starts at t = 0 with 1.26 m/s, which is an impact on the lines at rest");
  expect_warning({{"{harmonic: {amplitude: [0, 0, 2], period: 10}, ramp: 10}",
                   "{table: {rows: [[0, 0, 0, 0], [30, 9, 0, 0], [60, 18, 0, 0]]}}"}},
                 "starts at t = 0 with 0.3 m/s");
  const auto drift = [](const std::string& of) {
    return Changes{{"period: 10}, ramp: 10}", "period: 10}, ramp: 10, drift: {" + of + "}}"}};
  };
  expect_warning(drift("harmonic: {amplitude: [9, 0, 0], period: 90}"),
                 "slips.yaml:10: bodies.vessel.motion.drift: starts at t = 0 with 0.628 m/s, which is an "
                 "impact on the lines at rest");
  for (const char* smooth : {"harmonic: {amplitude: [9, 0, 0], period: 90}, ramp: 30", "offset: [9, 0, 0]",
                             "harmonic: {amplitude: [9, 0, 0], period: 90, phase_deg: [90, 0, 0]}"})
    EXPECT_EQ(notes(drift(smooth)), std::vector<std::string>{}) << smooth;
  EXPECT_TRUE(notes({{"{harmonic: {amplitude: [0, 0, 2], period: 10}, ramp: 10}",
                      "{table: {rows: [[0, 0, 0, 0], [1, 0, 0, 0], [30, 9, 0, 0], [60, 18, 0, 0]], "
                      "interpolation: monotone}}"}})
                  .empty());
}

TEST(InputWarnings, Releases) {
  const Changes parts = {
      {"output: {every: 1}", "events: [{release: {line: mooring, end: end_b}, time: 30}]"}};
  expect_warning(parts, "events[0]: line type chain has no 'stiffness_damping'");
  Changes damped = parts;
  damped.push_back({"bending: false,", "bending: false, stiffness_damping: 0.001,"});
  EXPECT_TRUE(notes(damped).empty());
}

// End B of the line in the case, with stiffness-proportional damping.
TEST(InputWarnings, FeedersThatStartAtOnce) {
  const auto fed = [](const std::string& feed, const std::string& damping) {
    return Changes{{"end_b: {", "end_b: {feed: {stock: 31, " + feed + "}, "},
                   {"bending: false,", "bending: false," + damping}};
  };
  const std::string damped = " stiffness_damping: 0.01,";
  expect_warning(fed("speed: 0.5", damped), "lines.mooring.end_b.feed: the speed jumps by 0.5 m/s");
  EXPECT_TRUE(notes(fed("speed: 0.5", "")).empty());
  EXPECT_TRUE(notes(fed("speed_table: [[0, 0], [2, 0.5]]", damped)).empty());
  EXPECT_TRUE(notes(fed("tension: 4e5", damped)).empty());
  const auto event = [&](const std::string& more) {
    Changes out = fed("speed: 0", damped);
    out.push_back({"output: {every: 1}",
                   "events: [{feed: {line: mooring, end: end_b, speed: -0.5" + more + "}, time: 30}]"});
    return out;
  };
  expect_warning(event(""), "events[0]: the speed jumps by 0.5 m/s");
  EXPECT_TRUE(notes(event(", ramp: 2")).empty());
}

// Attachments at other places than their nodes: elements of 10 m, from an anchor to a vessel.
TEST(InputWarnings, PlacesBetweenNodes) {
  const auto line = [](const std::string& more) {
    return Changes{{"elements: 76}]", "elements: 76}]\n    " + more}};
  };
  const std::string mass = "mass: 1000, volume: 0.2, Ca: 0.5";
  for (const char* at : {"330", "333.3", "755", "end_b", "0"})
    EXPECT_EQ(notes(line("masses: [{at: " + std::string(at) + ", " + mass + "}]")),
              std::vector<std::string>{})
        << at;
  // Two attachments in the last element share one node.
  expect_warning(
      line("masses: [{at: 752, " + mass + "}, {at: 755, " + mass + "}]"),
      "lines.mooring.masses: the attachment at 755 m of line mooring is moved to the nearest node, at "
      "752 m; use shorter elements, or end a section at 755 m, to have a node there");
  const auto few = [](const std::string& more) {
    return Changes{{"length: 760, elements: 76}]",
                    "length: 380, elements: 38}, {type: chain, length: 380, elements: 1}]" + more}};
  };
  expect_warning(
      few("\n    loads: [{at: 500, force: [0, 0, 1.0e4]}]"),
      "lines.mooring.loads[0]: the attachment at 500 m of line mooring is moved to the nearest node");
  Changes linked = few("");
  linked.push_back(
      {"dynamics:",
       "links: {k: {end_a: {line: mooring, at: 500}, end_b: {anchor: [0, 0, 0]}, stiffness: 1}}\n"
       "dynamics:"});
  expect_warning(linked, "links.k: the attachment at 500 m of line mooring is moved to the nearest node");
  // The end of a section has a node.
  EXPECT_EQ(
      notes({{"[{type: chain, length: 760, elements: 76}]",
              "[{type: chain, length: 333.3, elements: 33}, {type: chain, length: 426.7, elements: 43}]\n"
              "    masses: [{at: 333.3, mass: 1000, volume: 0.2, Ca: 0.5}]"}}),
      std::vector<std::string>{});
}

TEST(InputWarnings, BuoysWithoutDragAndAddedMass) {
  const auto buoy = [](const std::string& more) {
    return Changes{
        {"elements: 76}]", "elements: 76}]\n    masses: [{at: 300, mass: 1000, volume: 8" + more + "}]"}};
  };
  expect_warning(
      buoy(""),
      "lines.mooring.masses: 8 m³ at 300 m of line mooring have neither 'drag_area' nor 'Ca': no drag and "
      "no added mass; a ball of that volume has about 2.4 m² and 0.5");
  for (const char* more : {", Ca: 0.5", ", drag_area: 2"})
    EXPECT_EQ(notes(buoy(more)), std::vector<std::string>{}) << more;
}

TEST(InputWarnings, RotationsOfATurnedBody) {
  const auto turned = [](const std::string& heading, const std::string& motion) {
    return Changes{{"vessel: {motion: {harmonic: {amplitude: [0, 0, 2], period: 10}, ramp: 10}}",
                    "vessel: {rotation_deg: [0, 0, " + heading + "], motion: {" + motion + ", ramp: 10}}"}};
  };
  const std::string roll = "harmonic: {rotation_amplitude_deg: [5, 0, 0], period: 10}",
                    yaw = "harmonic: {rotation_amplitude_deg: [0, 0, 5], period: 10}",
                    table = "table: {rows: [[0, 0, 0, 0, 0, 0, 0], [60, 0, 0, 0, 5, 0, 0]]}";
  expect_warning(
      turned("90", roll),
      "slips.yaml:10: bodies.vessel.motion.harmonic: turns the body about (1, 0, 0) in space, and that is "
      "(0, -1, 0) of its own axes by its 'rotation_deg'; is it meant?");
  expect_warning(turned("30", table), "bodies.vessel.motion.table: turns the body about (1, 0, 0) in space");
  EXPECT_EQ(notes(turned("0", roll)), std::vector<std::string>{});
  EXPECT_EQ(notes(turned("90", yaw)), std::vector<std::string>{});
}

// A line that is too short moves a body with mass, so there is no warning of its tension.
TEST(InputWarnings, NoTensionOfALineToABodyThatGivesWay) {
  const Changes shorter = {{"length: 760", "length: 715"},
                           {"{motion: {harmonic: {amplitude: [0, 0, 2], period: 10}, ramp: 10}}",
                            "{floating: {mass: 1e6, inertia: [1e8, 1e8, 1e8]}}"}};
  for (const std::string& note : notes(shorter))
    EXPECT_EQ(note.find("requires a tension"), std::string::npos) << note;
}

// Notes on a hemisphere of 5 m by coefficients, with wave forces at 5 and 6 s.
std::vector<std::string> notes_of_platform(const std::string& environment, const std::string& inertia,
                                           const std::string& more = "") {
  const fs::path folder = fs::path(testing::TempDir()) / "hawser_warnings_platform";
  fs::create_directories(folder);
  for (const char* ending : {"1", "hst"})
    fs::copy_file(std::string(HAWSER_SOURCE_DIR "/tests/data/hemisphere.") + ending,
                  folder / (std::string("float.") + ending), fs::copy_options::overwrite_existing);
  std::ofstream(folder / "float.3") << "5 0 3 1 0 1 0\n6 0 3 1 0 1 0\n";
  const std::string text = "hawser: 1\nenvironment: {gravity: 9.81, water: {density: 1000, depth: 100}" +
                           environment +
                           "}\nbodies:\n  float: {floating: {mass: 261800, inertia: " + inertia +
                           ", hydrodynamics: {wamit: " + (folder / "float").string() + ", length_scale: 5" +
                           more + "}}}\nstatics: false\ndynamics: {duration: 20}\n";
  return advice::input_notes(io::read_case_text(text, "float.yaml", {}, MPI_COMM_SELF));
}

TEST(InputWarnings, Platforms) {
  const std::string sphere = "[2.6e6, 2.6e6, 2.6e6]";
  EXPECT_EQ(notes_of_platform("", sphere), std::vector<std::string>{});
  const auto expect = [](const std::vector<std::string>& found, const std::string& part) {
    ASSERT_EQ(found.size(), 1U) << part << "\n" << testing::PrintToString(found);
    EXPECT_NE(found.front().find(part), std::string::npos) << part << "\n" << found.front();
  };
  expect(notes_of_platform("", "[1e6, 2e6, 3.03e6]"),
         "bodies.float.floating.inertia: the largest principal moment, 3.03e+06 kg m², is 1 % above");
  expect(notes_of_platform(", current: {speed: 1}", sphere),
         "bodies.float.floating.hydrodynamics: the current acts on lines but not on this body");
  EXPECT_EQ(notes_of_platform(", waves: {regular: {height: 0.1, period: 5}}", sphere),
            std::vector<std::string>{});
  expect(notes_of_platform(", waves: {stokes: {height: 0.1, period: 5}}", sphere),
         "bodies.float.floating.hydrodynamics: its coefficients are those of linear waves");
  const std::string drift_damping = ", wave_drift_damping: {rows: [[5, 100, 100, 100], [6, 100, 100, 100]]}";
  expect(notes_of_platform("", sphere, drift_damping),
         "bodies.float.floating.hydrodynamics.wave_drift_damping: has no effect, since it is multiplied by");
  EXPECT_EQ(notes_of_platform(", waves: {regular: {height: 0.1, period: 5}}", sphere, drift_damping),
            std::vector<std::string>{});
}

// 1154 kN and three elements of chain of 33 kN press on 100 kN/m³ times 0.25 m over 2 sqrt(H/k) = 15 m, with
// H = 1.4 MN of the chain without the mass: 3.3 m. Runs of a chain of 310 m to a point 240 m away and 100 m
// up with 50 t at 100 m, elements of 5 m: 3.9 m (reported 4.3), 20 t: 1.87 m (1.9).
TEST(InputWarnings, MassesThatSinkIntoTheBed) {
  const auto clump = [](const std::string& volume) {
    return Changes{{"elements: 76}]",
                    "elements: 76}]\n    masses: [{at: 300, mass: 1.3e5, volume: " + volume + ", Ca: 0.5}]"}};
  };
  expect_warning(clump("12"),
                 "lines.mooring.masses: on the seabed, 1.3e+05 kg at 300 m of line mooring penetrates by "
                 "about 3.3 m, since the element of 'chain' that carries it is only 0.25 m in diameter");
  EXPECT_EQ(notes(clump("40")), std::vector<std::string>{});   // a light sphere of 4.2 m
  EXPECT_EQ(notes(clump("130")), std::vector<std::string>{});  // it floats
  Changes out_of_reach = clump("12");
  out_of_reach.push_back({"seabed: {depth: 200, friction: 0.6}", "seabed: {depth: 2000, friction: 0.6}"});
  out_of_reach.push_back({"water: {depth: 200}", "water: {}"});
  const std::vector<std::string> found = notes(out_of_reach);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found.front().find("no line reaches the seabed"), std::string::npos) << found.front();
}

TEST(InputWarnings, StiffenersOfTooFewElements) {
  const auto stiffener = [](const std::string& rows) {
    return Changes{
        {"bending: false,", "EI: 1e5, GJ: 1e5,"},
        {"elements: 76}]", "elements: 76}]\n    bend_stiffeners: [{at: end_b, EI: " + rows + "}]"}};
  };
  expect_warning(stiffener("[[0, 1e6], [12, 0]]"),
                 "lines.mooring.bend_stiffeners[0]: its 12 m are 1.2 elements, each with one bending "
                 "stiffness: use 6 elements or more");
  EXPECT_EQ(notes(stiffener("[[0, 1e6], [30, 0]]")), std::vector<std::string>{});
}

TEST(InputWarnings, ManyOfAKindAreCutShort) {
  std::string lines;
  for (int i = 0; i < 5; ++i)
    lines += "\n  chain" + std::to_string(i) +
             ": {outer_diameter: 0.14, mass_per_length: 390, EA: 1.6e9, bending: false}";
  const std::vector<std::string> found = notes({{"line_types:", "line_types:" + lines}});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_TRUE(found.back().ends_with("(and 2 more like it)")) << found.back();
}

TEST(InputWarnings, OfWhatIsSet) {
  const std::vector<std::string> found = notes({}, {"dynamics.step=1"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found.front().starts_with("slips.yaml with --set: dynamics.step: 1 s is 10 steps"))
      << found.front();
}

TEST(InputWarnings, SlowestPeriodOfATautString) {
  // T = 1e6 N, m = 100 kg/m, L = 100 m: 2 L sqrt(m/T) = 2 s, without gravity.
  const model::Case c = io::read_case_text(
      "hawser: 1\nenvironment: {gravity: 0}\nline_types: {wire: {outer_diameter: 0.1, mass_per_length: 100, "
      "EA: 1e9, "
      "bending: false}}\nlines: {wire: {sections: [{type: wire, length: 100, elements: 10}], end_a: {anchor: "
      "[0, 0, "
      "0]}, end_b: {anchor: [100.1, 0, 0]}}}\n",
      "wire.yaml");
  EXPECT_NEAR(slowest_period(c, c.lines.front()), 2, 1e-3);
}

TEST(InputWarnings, SlowestPeriodOfACantilever) {
  // EI = 1e5 N m², m = 10 kg/m, L = 10 m: 2 pi L² sqrt(m/EI) / 1.8751² = 1.787 s, without gravity.
  const model::Case c = io::read_case_text(
      "hawser: 1\nenvironment: {gravity: 0}\nline_types: {beam: {outer_diameter: 0.1, mass_per_length: 10, "
      "EA: "
      "1e9, EI: 1e5, GJ: 1e5}}\nlines: {beam: {sections: [{type: beam, length: 10, elements: 10}], end_a: "
      "{anchor: [0, 0, 0], clamped: true, direction: [1, 0, 0]}, end_b: free}}\n",
      "beam.yaml");
  EXPECT_NEAR(slowest_period(c, c.lines.front()), 1.787, 1e-3);
}

}  // namespace
}  // namespace hawser::input_warnings_test
