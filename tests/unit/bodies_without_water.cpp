// A floating body that no force of the water acts on is noted in waves and currents.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/io/case_reader.hpp"

namespace hawser::bodies_without_water_test {
namespace {

const std::string kShip =
    "mass: 2e7, inertia: [1e10, 1e10, 1e10], stiffness: [1e5, 1e5, 1e6], turning_stiffness: [1e9, 1e9, 1e9]";

// Notes on a ship with these keys besides its mass and springs.
std::vector<std::string> notes(const std::string& environment, const std::string& floating = "",
                               const std::string& body = "", const std::string& others = "") {
  const std::string text = "hawser: 1\nenvironment: {water: {depth: 200}" + environment +
                           "}\nbodies:\n  ship: {floating: {" + kShip + floating + "}" + body + "}\n" +
                           others + "dynamics: {duration: 100, step: 0.25}\noutput: {every: 1}\n";
  return advice::input_notes(io::read_case_text(text, "ship.yaml", {}, MPI_COMM_SELF));
}

const char* const kWaves = ", waves: {regular: {height: 4, period: 10}}";
const char* const kNone = "bodies.ship.floating: neither waves nor current act on it";

TEST(BodiesWithoutWater, InWavesAndCurrents) {
  for (const char* flow : {kWaves, ", current: {speed: 1}"}) {
    const std::vector<std::string> found = notes(flow);
    ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
    EXPECT_NE(found.front().find(kNone), std::string::npos) << found.front();
  }
  EXPECT_EQ(notes(""), std::vector<std::string>{});
}

TEST(BodiesWithoutWater, OnceForAllBodies) {
  const std::string more = "  one: {position: [500, 0, 0], floating: {" + kShip +
                           "}}\n  two: {position: [900, 0, 0], floating: {" + kShip + "}}\n";
  const std::vector<std::string> found = notes(kWaves, "", "", more);
  ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
  EXPECT_NE(found.front().find(std::string(kNone) + " and 2 other bodies"), std::string::npos)
      << found.front();
}

// Water on members or by a table, contact only, a prescribed motion in place of the waves, a table of forces,
// and a load in air.
TEST(BodiesWithoutWater, NoneIfTheWaterIsThere) {
  const std::vector<std::string> none;
  EXPECT_EQ(notes(kWaves, ", members: [{from: [0, 0, -10], to: [0, 0, 5], diameter: 10}]"), none);
  EXPECT_EQ(notes(kWaves, "", "",
                  "volumes:\n  side: {shape: {box: {centre: [0, 0, 0], size: [100, 20, 10]}}, body: ship}\n"),
            none);
  EXPECT_EQ(notes(kWaves, "", ", motion: {harmonic: {amplitude: [0, 0, 1], period: 10}, ramp: 10}"), none);
  EXPECT_EQ(notes(kWaves, ", loads: [{table: {rows: [[0, 0, 0, 0], [10, 1e5, 0, 0]]}}]"), none);
  EXPECT_EQ(notes(kWaves, ", weight: true", ", position: [0, 0, 3]"), none);
}

// Members have drag, but nothing carries the weight of their body.
TEST(BodiesWithoutWater, MembersHaveNoBuoyancy) {
  const auto spar = [](const std::string& weight) {
    return "  spar: {position: [300, 0, 0], floating: {mass: 1e6, inertia: [1e8, 1e8, 1e8], weight: " +
           weight + ", members: [{from: [0, 0, -10], to: [0, 0, 5], diameter: 10}]}}\n";
  };
  const std::vector<std::string> found = notes("", "", "", spar("true"));
  ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
  EXPECT_NE(found.front().find("bodies.spar.floating.members: have drag and added mass, but no buoyancy"),
            std::string::npos)
      << found.front();
  EXPECT_EQ(notes("", "", "", spar("false")), std::vector<std::string>{});
}

}  // namespace
}  // namespace hawser::bodies_without_water_test
