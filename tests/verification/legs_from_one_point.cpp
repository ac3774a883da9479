// Lines from one point at a small angle: near the point their round sections overlap, which is not contact.
#include <fmt/format.h>

#include <cmath>

#include "hawser/io/case_reader.hpp"
#include "support/rig.hpp"

namespace hawser::test::legs_from_one_point {
namespace {

// Legs of 50 m of chain from one point, taut (0.1 % longer than their chords) or slack (3 %), `degrees`
// apart.
std::string legs(double degrees, double slack, const char* contact) {
  const double half = degrees * M_PI / 360;
  const auto leg = [&](const char* name, double side) {
    return fmt::format(
        "  {}: {{sections: [{{type: chain, length: {}, elements: 100}}], end_a: {{anchor: [0, 0, -50]}}, "
        "end_b: {{anchor: [{}, {}, -50]}}}}\n",
        name, 50 * (1 + slack), 50 * std::cos(half), side * 50 * std::sin(half));
  };
  return "hawser: 1\nenvironment: {water: {depth: 200}}\nline_types:\n  chain: {library: chain-studless, "
         "diameter: 100 mm, grade: R4}\nlines:\n" +
         leg("p", 1) + leg("q", -1) + contact;
}

std::vector<Vec3> at_rest(const std::string& text) {
  Simulation sim(PETSC_COMM_SELF, io::read_case_text(text, "legs.yaml"));
  sim.solve_statics();
  return sim.state().x;
}

// The shape at rest is that without contact between lines.
TEST(LegsFromOnePoint, AreNotPriedApart) {
  for (const double degrees : {40.0, 20.0, 6.0})
    for (const double slack : {0.001, 0.03}) {
      const std::vector<Vec3> with = at_rest(legs(degrees, slack, ""));
      const std::vector<Vec3> without = at_rest(legs(degrees, slack, "contact: {between_lines: false}\n"));
      ASSERT_EQ(with.size(), without.size());
      double most = 0;
      for (size_t n = 0; n < with.size(); ++n) most = std::max(most, (with[n] - without[n]).norm());
      EXPECT_LT(most, 1e-6) << degrees << " degrees, slack " << slack;
    }
}

// A cut event in the future does not change statics: the line has two parts, whose new ends do not exist yet.
TEST(LegsFromOnePoint, NorWhereOneIsCutLater) {
  const char* cut = "dynamics: {duration: 2}\nevents: [{cut: {line: p, at: 25.025}, time: 1.9}]\n";
  const std::vector<Vec3> whole = at_rest(legs(6, 0.001, ""));
  const std::vector<Vec3> parts = at_rest(legs(6, 0.001, cut));
  ASSERT_GE(parts.size(), whole.size());
  for (size_t n = 0; n < 40; ++n) EXPECT_LT((parts[n] - whole[n]).norm(), 1e-6) << n;
}

}  // namespace
}  // namespace hawser::test::legs_from_one_point
