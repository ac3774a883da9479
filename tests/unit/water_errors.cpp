// Warnings about elements that are too long for a current or for waves, against hand calculations.
#include "hawser/record/water_errors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::record::water_errors_test {
namespace {

// Warnings for a cable with the keys `more` in its start position, after a step that ends at `time`; time =
// 0: without a step.
std::vector<std::string> warnings(const std::string& sea, const std::string& line, double time = 0) {
  const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
environment: {{gravity: 9.81, water: {{density: 1000, depth: 1000}}, {}}}
line_types:
  rope: {{outer_diameter: 0.3, mass_per_length: 70.6858, EA: 1.0e7, bending: false, Cd_normal: 1.2, Ca_normal: 1}}
  bar: {{outer_diameter: 0.3, mass_per_length: 70.6858, EA: 1.0e9, bending: false, Cd_normal: 1.2}}
  chain: {{outer_diameter: 0.3, mass_per_length: 170.6858, EA: 1.0e7, bending: false, Cd_normal: 1.2}}
  rod: {{outer_diameter: 0.3, mass_per_length: 70.6858, EA: 1.0e7, EI: 1.0e4, GJ: 1.0e4, Cd_normal: 0, Ca_normal: 1, Ca_axial: 1}}
lines: {}
)",
                                                       sea, line),
                                           "/nowhere/case.yaml");
  run::Simulation sim(MPI_COMM_SELF, c);
  WaterErrors errors(c, sim.system());
  State& s = sim.state();
  s.time = time;
  errors.update(time > 0 ? s.after_step(0.1) : s.at_rest());
  return errors.warnings();
}

std::string upright(double length, const std::string& type = "rope", const std::string& name = "l") {
  return fmt::format(
      "{{{}: {{sections: [{{type: {}, length: {}, elements: 1}}], start: straight, end_a: {{anchor: [0, 0, "
      "-10]}}, end_b: {{anchor: [0, 0, 0]}}}}}}",
      name, type, length);
}

const char* const kJet =
    "current: {profile: [{depth: 0, speed: 0}, {depth: 5, speed: 1}, {depth: 10, speed: 0}]}";

// A jet between two nodes: the drag is 1/2 rho Cd D times the integral of u², 10/3 m³/s². An element has none
// of it, two elements of half the length have it all.
TEST(WaterErrors, CurrentBetweenTheNodes) {
  const std::vector<std::string> all = warnings(kJet, upright(10));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(
      all.front(),
      "line l has elements of 10 m at arc length 5 m (5 m below the still water, t = 0 s), between whose "
      "nodes the current is not linear, and the hydrodynamic forces on the elements of the line are "
      "wrong by about 100 % of their largest sum, 0.6 kN: use elements of 5 m there");
  EXPECT_EQ(warnings(kJet, upright(10, "rod")).size(), 0U);  // no drag
  // A current that is linear between nodes causes no error.
  EXPECT_TRUE(
      warnings("current: {profile: [{depth: 0, speed: 2}, {depth: 10, speed: 1}]}", upright(10)).empty());
  EXPECT_TRUE(warnings("current: {speed: 1}", upright(10)).empty());
}

// 600 N change the direction of a tension of 10 MN or more by less than 1e-4: the tension of the bar is 53
// MN, that of the rope 0.53 MN.
TEST(WaterErrors, OfNoMatterBesideTheTension) {
  EXPECT_EQ(warnings(kJet, upright(9.5)).size(), 1U);
  EXPECT_TRUE(warnings(kJet, upright(9.5, "bar")).empty());
}

// A level element that has 0.09 of 0.1233 m²/s² misses 600 N of drag. The chain weighs 98 kN in water.
TEST(WaterErrors, OfNoMatterBesideTheWeight) {
  const auto level = [](const std::string& type) {
    return warnings(
               "current: {profile: [{depth: 10, speed: 0.3}, {depth: 11, speed: 0.4}, {depth: 12, speed: "
               "0.3}]}",
               fmt::format(
                   "{{l: {{sections: [{{type: {}, length: 100, elements: 1}}], start: straight, end_a: "
                   "{{anchor: [0, 0, -10]}}, end_b: {{anchor: [0, 99.98, -12]}}}}}}",
                   type))
        .size();
  };
  EXPECT_EQ(level("rope"), 1U);
  EXPECT_EQ(level("chain"), 0U);
}

// A current that differs by a twentieth in the middle of an element: the missing 0.407 m³/s² are compared
// with 8.407 on the lower line, and with 44.407 on both lines if they are joined.
TEST(WaterErrors, LinesThatAreJoinedBearTogether) {
  const auto both = [](const std::string& end, const std::string& joints) {
    return warnings(
        "current: {profile: [{depth: 0, speed: 2}, {depth: 10, speed: 2}, {depth: 11, speed: 2.1}, "
        "{depth: 12, speed: 2}]}",
        fmt::format("{{high: {{sections: [{{type: rope, length: 9, elements: 9}}], start: straight, "
                    "end_a: {{anchor: [0, 0, -1]}}, end_b: {{{0}}}}}, deep: {{sections: [{{type: rope, "
                    "length: 2, elements: 1}}], start: straight, end_a: {{{0}}}, end_b: {{anchor: [0, "
                    "0, -12]}}}}}}{1}",
                    end, joints));
  };
  EXPECT_TRUE(both("joint: knot", "\njoints: {knot: {start: [0, 0, -10]}}").empty());
  const std::vector<std::string> apart = both("anchor: [0, 0, -10]", "");
  ASSERT_EQ(apart.size(), 1U);
  EXPECT_TRUE(apart.front().starts_with("line deep has elements of 2 m at arc length 1 m (11 m below"))
      << apart.front();
  EXPECT_NE(apart.front().find("wrong by about 4.8 %"), std::string::npos) << apart.front();
}

// A level line far below the surface in a wave of 100 m, whose acceleration has a constant magnitude and
// rotates by phi between nodes. An element has cos(phi/2) of the force, four elements a quarter as long have
// sin(phi/2)/4 tan(phi/8), each cos(phi/8).
TEST(WaterErrors, WavesBetweenTheNodes) {
  const double period = std::sqrt(2 * M_PI * 100 / 9.81);
  const auto level = [&](int elements, double time = 40) {
    return warnings(
        fmt::format("waves: {{regular: {{height: 0.5, period: {:.12g}}}}}", period),
        fmt::format("{{l: {{sections: [{{type: rod, length: 200, elements: {}}}], start: straight, end_a: "
                    "{{anchor: [0, 0, -10]}}, end_b: {{anchor: [200, 0, -10]}}}}}}",
                    elements),
        time);
  };
  const std::vector<std::string> all = level(16);
  ASSERT_EQ(all.size(), 1U);
  const double phi = M_PI / 4;
  const double percent =
      100 * (std::sin(phi / 2) / (4 * std::tan(phi / 8)) - std::cos(phi / 2)) / std::cos(phi / 8);
  EXPECT_NE(all.front().find(fmt::format("wrong by about {:.1f} %", percent)), std::string::npos)
      << all.front();
  EXPECT_NE(all.front().find("between whose nodes the waves are not linear"), std::string::npos)
      << all.front();
  EXPECT_TRUE(all.front().ends_with("use elements of 3.1 m there")) << all.front();
  EXPECT_TRUE(level(32).empty());     // 1.2 %
  EXPECT_EQ(level(2).size(), 1U);     // as long as the wave: the motion is the same at all nodes
  EXPECT_TRUE(level(16, 0).empty());  // waves act in dynamics only
}

}  // namespace
}  // namespace hawser::record::water_errors_test
