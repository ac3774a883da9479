// Lines that cross on the bed, and a line across a pipeline: which one is on top at rest.
#include <fmt/format.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "support/rig.hpp"

namespace hawser::test::lines_that_cross {
namespace {

// A chain of 84 mm across a pipeline of 24 in on the bed: a line with a straight or automatic start shape, or
// a volume. By hand: the axis of the chain is half of both contact diameters above that of the pipe, and the
// suspended parts on both sides press on it with 2 sqrt(2 h w T) for the height h above the bed.
std::string field(const std::string& pipeline, const std::string& contact = "") {
  return "hawser: 1\nenvironment: {water: {depth: 100}, seabed: {depth: 100, friction: 0.6}}\nline_types:\n"
         "  chain: {library: chain-studless, diameter: 84 mm, grade: R3}\n"
         "  pipe: {pipe: {outer_diameter: 0.61, wall_thickness: 0.02}, contents: {density: 800}}\n" +
         contact +
         "lines:\n  chain: {sections: [{type: chain, length: 500, elements: 250}], end_a: {anchor: [0, 0, "
         "-10]}, "
         "end_b: {anchor: [480, 0, -100]}}\n" +
         pipeline;
}

std::string pipeline(const char* start) {
  return fmt::format(
      "  pipeline: {{sections: [{{type: pipe, length: 200, element_length: 2}}], end_a: {{anchor: [400, "
      "-100, -99.695]}}, end_b: {{anchor: [400, 100, -99.695]}}{}}}\n",
      start);
}

// Height of the chain's axis at x = 400.
double height(Simulation& sim) {
  const std::vector<Vec3>& x = sim.state().x;
  for (size_t n = 1; n < 251; ++n)
    if (x[n - 1].x() <= 400 && x[n].x() > 400) {
      const double t = (400 - x[n - 1].x()) / (x[n].x() - x[n - 1].x());
      return x[n - 1].z() + t * (x[n].z() - x[n - 1].z());
    }
  return NAN;
}

TEST(LinesThatCross, ChainOverAPipelineOnTheBed) {
  for (const char* start : {", start: straight", ""}) {
    Simulation sim(PETSC_COMM_SELF, io::read_case_text(field(pipeline(start)), "cross.yaml"));
    const double radii = 0.305 + 0.5 * sim.model().line_types.front().contact_diameter;
    sim.solve_statics();
    // The chain presses the pipe into the bed.
    const double pipe = sim.state().x[251 + 50].z();
    EXPECT_NEAR(pipe, -99.695, 0.1) << start;
    EXPECT_NEAR(height(sim) - pipe, radii, 0.02 * radii) << start;
    // 2 sqrt(2 h w T): h 0.61 m, w 1.197 kN/m, T 325 kN, which is 433 kN less 108 kN of friction.
    EXPECT_NEAR(sim.line_pairs()->normal_force(), 43.6e3, 0.05 * 43.6e3) << start;
  }
}

TEST(LinesThatCross, ChainOverAVolumeOnTheBed) {
  const model::Case c = io::read_case_text(
      "hawser: 1\nenvironment: {water: {depth: 100}, seabed: {depth: 100, friction: 0.6}}\nline_types:\n"
      "  chain: {library: chain-studless, diameter: 84 mm, grade: R3}\n"
      "volumes: {pipe: {shape: {capsule: {from: [400, -100, -99.695], to: [400, 100, -99.695], "
      "radius: 0.305}}}}\n"
      "lines:\n  chain: {sections: [{type: chain, length: 500, elements: 250}], end_a: {anchor: [0, 0, "
      "-10]}, "
      "end_b: {anchor: [480, 0, -100]}}\n",
      "over.yaml");
  Simulation sim(PETSC_COMM_SELF, c, run::surfaces(run::load_volumes(c)));
  EXPECT_TRUE(sim.warnings().empty());
  sim.solve_statics();
  EXPECT_NEAR(height(sim), -99.695 + 0.305 + 0.5 * sim.model().line_types.front().contact_diameter, 0.05);
}

// Two chains that lie on the bed over their whole length: without an order in the case there is an error.
TEST(LinesThatCross, OrderIsAskedFor) {
  const auto chains = [](const std::string& contact) {
    return "hawser: 1\nenvironment: {water: {depth: 100}, seabed: {depth: 100}}\nline_types:\n"
           "  chain: {library: chain-studless, diameter: 84 mm, grade: R3}\n" +
           contact +
           "lines:\n  one: {sections: [{type: chain, length: 100, elements: 50}], end_a: {anchor: [-50, 0, "
           "-100]}, "
           "end_b: {anchor: [50, 0, -100]}}\n  two: {sections: [{type: chain, length: 100, elements: 50}], "
           "end_a: "
           "{anchor: [0, -50, -100]}, end_b: {anchor: [0, 50, -100]}}\n";
  };
  try {
    Simulation sim(PETSC_COMM_SELF, io::read_case_text(chains(""), "ask.yaml"));
    ADD_FAILURE() << "not asked for";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("over: [[two, one]]"), std::string::npos) << e.what();
  }
  for (const bool two_over : {true, false}) {
    Simulation sim(PETSC_COMM_SELF,
                   io::read_case_text(chains(fmt::format("contact: {{between_lines: {{over: [[{}]]}}}}\n",
                                                         two_over ? "two, one" : "one, two")),
                                      "over.yaml"));
    sim.solve_statics();
    const double one = sim.state().x[25].z();
    const double two = sim.state().x[51 + 25].z();
    const double radii = sim.model().line_types.front().contact_diameter;
    EXPECT_NEAR(two - one, two_over ? radii : -radii, 0.1 * radii);
  }
}

}  // namespace
}  // namespace hawser::test::lines_that_cross
