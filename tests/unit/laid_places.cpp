// Laid positions of lines of a frame whose ends support each other along very many paths: the lines remain at
// their start positions on the bed.
#include "hawser/solve/laid_places.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "hawser/io/case_reader.hpp"

namespace hawser::test::laid_places_test {
namespace {

constexpr int kBays = 40;  // more than 2^40 paths from one end of the ladder to the other

// Two rails along x held at one end, with rungs along y, all on the bed at z = -50.
std::string ladder() {
  std::string joints;
  std::string lines;
  const auto add = [&](const std::string& name, const std::string& a, const std::string& b) {
    lines += fmt::format(
        "  {}: {{sections: [{{type: rope, length: 10, elements: 2}}], end_a: {}, end_b: {}}}\n", name, a, b);
  };
  for (int i = 1; i <= kBays; ++i) {
    for (const int side : {0, 1}) {
      joints += fmt::format("  j{}_{}: {{start: [{}, {}, -50]}}\n", side, i, 10 * i, 10 * side);
      const std::string before = i == 1 ? fmt::format("{{anchor: [0, {}, -50]}}", 10 * side)
                                        : fmt::format("{{joint: j{}_{}}}", side, i - 1);
      add(fmt::format("rail{}_{}", side, i), before, fmt::format("{{joint: j{}_{}}}", side, i));
    }
    add(fmt::format("rung{}", i), fmt::format("{{joint: j0_{}}}", i), fmt::format("{{joint: j1_{}}}", i));
  }
  return "hawser: 1\nenvironment: {seabed: {depth: 50, normal_stiffness: {per_area: 1e5}, friction: 0.5}}\n"
         "line_types: {rope: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, bending: false}}\n"
         "joints:\n" +
         joints + "lines:\n" + lines;
}

TEST(LaidPlaces, OfALadderOnTheBed) {
  const std::string path = testing::TempDir() + "ladder.yaml";
  std::ofstream(path) << ladder();
  const model::Case c = io::read_case(path);
  std::vector<std::vector<Vec3>> starts;
  for (int i = 1; i <= kBays; ++i) {
    for (const double y : {0.0, 10.0})
      starts.push_back({{10.0 * i - 10, y, -50}, {10.0 * i - 5, y, -50}, {10.0 * i, y, -50}});
    starts.push_back({{10.0 * i, 0, -50}, {10.0 * i, 5, -50}, {10.0 * i, 10, -50}});
  }
  const std::vector<std::vector<Vec3>> laid = laid_places(c, build_mesh(c), starts);
  ASSERT_EQ(laid.size(), starts.size());
  // The bed is lowered at anchors, which moves the lines slightly.
  for (size_t l = 0; l < laid.size(); ++l)
    for (size_t i = 0; i < 3; ++i) EXPECT_LT((laid[l][i] - starts[l][i]).norm(), 0.01) << l << " " << i;
}

}  // namespace
}  // namespace hawser::test::laid_places_test
