// Notes on constant loads of platforms and on centres of mass below the bottom of the water.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/io/case_reader.hpp"

namespace hawser::platform_inputs_test {
namespace {

std::vector<std::string> notes(const std::string& bodies) {
  return advice::input_notes(io::read_case_text(
      "hawser: 1\nenvironment: {gravity: 9.81, water: {density: 1000, depth: 100}}\nbodies:\n" + bodies +
          "statics: false\ndynamics: {duration: 10, step: 0.1}\noutput: {every: 1}\n",
      "platform.yaml", {}, MPI_COMM_SELF));
}

// A hemisphere of radius 5 m, with a weight of 2.57 MN.
std::vector<std::string> notes_of_loads(const std::string& loads) {
  return notes(
      "  float: {floating: {mass: 261800, centre_of_mass: [0, 0, -1], inertia: [2.6e6, 2.6e6, 2.6e6], "
      "stiffness: "
      "[1e4, 1e4, 0], turning_stiffness: [0, 0, 1e6], loads: [" +
      loads +
      "], hydrodynamics: {wamit: " HAWSER_SOURCE_DIR
      "/tests/data/hemisphere, length_scale: 5, displaced_volume: 261.8}}}\n");
}

TEST(PlatformInputs, ConstantForcesOutOfProportion) {
  for (const auto& [force, text] : {std::pair("2.4", "a force of 2.4 N is 9.3e-07 times the weight"),
                                    {"3e8", "a force of 3e+08 N is 1.2e+02 times the weight"}}) {
    const std::vector<std::string> found = notes_of_loads(fmt::format("{{force: [{}, 0, 0]}}", force));
    ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
    EXPECT_NE(found[0].find(fmt::format("bodies.float.floating.loads[0]: {} of the body", text)),
              std::string::npos)
        << found[0];
  }
  const std::vector<std::string> none;
  for (const char* loads : {"{force: [2.4e4, 0, 0]}", "{force: [2.4, 0, 0], moment: [0, 1e6, 0]}",
                            "{table: {rows: [[0, 0, 0, 0], [10, 2.4, 0, 0]]}}"})
    EXPECT_EQ(notes_of_loads(loads), none) << loads;
}

// A pile in springs of the soil, with its origin at the bottom; one that nothing holds there.
TEST(PlatformInputs, CentresOfMassInTheSoil) {
  const auto pile = [](const std::string& stiffness) {
    return notes(
        "  pile: {position: [0, 0, -99], floating: {mass: 1e5, inertia: [4e6, 4e6, 1e6], centre_of_mass: [0, "
        "0, "
        "-10]" +
        stiffness + "}}\n");
  };
  EXPECT_EQ(pile(", stiffness: [1e7, 1e7, 1e7]"), std::vector<std::string>{});
  const std::vector<std::string> found = pile("");
  ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
  EXPECT_NE(found[0].find("is at z = -109 m, below the bottom of the water at z = -100 m"), std::string::npos)
      << found[0];
}

}  // namespace
}  // namespace hawser::platform_inputs_test
