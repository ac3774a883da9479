// What a run says of itself before it begins: notes by group, and what it will cost.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hawser/app/cost.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/notes.hpp"

namespace hawser::app::notes_and_cost_test {
namespace {

TEST(Notes, OfVolumesAreGrouped) {
  std::vector<std::string> notes{"lines.a: something else"};
  for (int i = 1; i <= 18; ++i)
    notes.push_back("volume roller_" + std::to_string(i) + ": normal stiffness 1e+06 N/m per m: because");
  notes.insert(notes.begin() + 3, "volume deck: normal stiffness 2e+06 N/m per m: because");
  notes.push_back("volumes.port: 3 triangles left out");
  notes.push_back("volumes.starboard: 3 triangles left out");
  notes.push_back("contact between lines: a note");
  notes.push_back("contact between lines: a note");
  const std::vector<std::string> expected{
      "lines.a: something else",
      "volumes roller_1 ... roller_18 (18 in all): normal stiffness 1e+06 N/m per m: because",
      "volume deck: normal stiffness 2e+06 N/m per m: because",
      "volumes port and starboard: 3 triangles left out",
      "contact between lines: a note",
      "contact between lines: a note"};
  EXPECT_EQ(model::grouped_notes(notes), expected);
  EXPECT_TRUE(model::grouped_notes({}).empty());
}

const std::string kCase = R"(
hawser: 1
line_types: {rod: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e7, EI: 3.0e4, GJ: 3.0e4, Cd_normal: 1.2}}
lines:
  rod:
    sections: [{type: rod, length: 12, elements: ELEMENTS}]
    end_a: {anchor: [0, 0, -5], direction: [1, 0, 0], clamped: true}
    end_b: free
    start: straight
contact: {between_lines: BETWEEN}
dynamics: {duration: 100, step: 0.05}
)";

model::Case rod(int elements, const std::string& between = "false", const std::string& waves = "") {
  std::string text = kCase;
  if (!waves.empty()) text += "environment: {water: {depth: 100}, waves: {" + waves + "}}\n";
  text.replace(text.find("ELEMENTS"), 8, std::to_string(elements));
  text.replace(text.find("BETWEEN"), 7, between);
  return io::read_case_text(text, "/nowhere/case.yaml");
}

// 2000 steps of 4 residuals and 2 tangents, a third more for the rest; 60 iterations of statics.
TEST(Cost, ByStepsAndWhatTheyNeed) {
  CostParts p;
  p.residual = 1e-4, p.tangent = 5e-4, p.duration = 100, p.step = 0.05;
  EXPECT_NEAR(expected_cost(p), 2000 * 1.3 * 1.4e-3, 1e-12);
  p.statics = true;
  EXPECT_NEAR(expected_cost(p), 2000 * 1.3 * 1.4e-3 + 60 * 7e-4, 1e-12);
  EXPECT_EQ(cost_sentence(p), "expected cost: about 3.7 CPU s, if steps are of about 0.05 s");
  p.meshes = true;
  EXPECT_NEAR(expected_cost(p), 3 * (2000 * 1.3 * 1.4e-3 + 60 * 7e-4), 1e-12);
  p.meshes = false;
  p.flow = 1e-3;
  EXPECT_NEAR(expected_cost(p), 2000 * (1.3 * 1.4e-3 + 1e-3) + 60 * 7e-4, 1e-12);
  p.flow = 0;
  p.step = 5;
  EXPECT_EQ(cost_sentence(p), "expected cost: less than 1 CPU s, if steps are of about 5 s");
  p.duration = 0;
  EXPECT_EQ(cost_sentence(p), "expected cost: less than 1 CPU s");
}

// What is measured grows with the elements, and leaves the simulation as it was.
TEST(Cost, PartsAreMeasured) {
  Simulation small(MPI_COMM_SELF, rod(50)), large(MPI_COMM_SELF, rod(2000));
  const std::vector<Vec3> before = large.state().x;
  const CostParts a = measured_parts(small), b = measured_parts(large);
  EXPECT_EQ(large.state().x, before);
  EXPECT_GT(a.residual, 0);
  EXPECT_GT(b.residual, 5 * a.residual);
  EXPECT_GT(b.tangent, 5 * a.tangent);
  EXPECT_EQ(b.step, 0.05);
  EXPECT_EQ(b.duration, 100);
  EXPECT_TRUE(b.statics);
}

// The flow of a sea is found once a step, and is most of what a step costs.
TEST(Cost, WavesAreMeasured) {
  const std::string sea = "jonswap: {hs: 3, tp: 9, direction_deg: 0, components: ";
  Simulation few(MPI_COMM_SELF, rod(500, "false", sea + "20}")),
      many(MPI_COMM_SELF, rod(500, "false", sea + "400}"));
  const double a = measured_parts(few).flow, b = measured_parts(many).flow;
  EXPECT_GT(a, 0);
  EXPECT_GT(b, 5 * a);
  EXPECT_GT(b, measured_parts(many).residual);
}

// What a run of 10^5 beam elements took, 938 MB, and one of as many of cables, 643 MB, from what was measured
// before them: within a tenth.
TEST(Cost, MemoryOfARun) {
  EXPECT_EQ(memory_sentence(43e6, 43e6), "expected memory: about 0.043 GB");
  EXPECT_EQ(memory_sentence(43e6, 492e6), "expected memory: about 1 GB");
  EXPECT_EQ(memory_sentence(43e6, 316e6), "expected memory: about 0.64 GB");
  const double before = peak_memory();
  EXPECT_GT(before, 1e7);
  const std::vector<char> block(static_cast<size_t>(before) + 100'000'000, 1);
  EXPECT_GT(peak_memory(), before + 5e7);
}

TEST(Notes, TellTheStiffnessOfALineWithItself) {
  const auto told = [](const std::string& between) {
    const Simulation sim(MPI_COMM_SELF, rod(10, between));
    for (const std::string& n : sim.notes())
      if (n.starts_with("contact of line rod with itself: normal stiffness ")) return true;
    return false;
  };
  EXPECT_TRUE(told("true"));
  EXPECT_FALSE(told("false"));
  EXPECT_FALSE(told("{normal_stiffness: {per_length: 1e6}}"));
}

}  // namespace
}  // namespace hawser::app::notes_and_cost_test
