// Messages before a run begins: notes that are grouped, the expected cost and the expected memory.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/notes.hpp"
#include "hawser/run/cost.hpp"
#include "hawser/run/simulation.hpp"
#include "hawser/run/volumes.hpp"

namespace hawser::run::notes_and_cost_test {
namespace {

TEST(Notes, OfVolumesAreGrouped) {
  std::vector<std::string> notes{"lines.a: something else"};
  for (int i = 1; i <= 18; ++i)
    notes.push_back("volume roller_" + std::to_string(i) + ": normal stiffness 1e+06 N/m per m: because");
  notes.insert(notes.begin() + 3, "volume deck: normal stiffness 2e+06 N/m per m: because");
  notes.push_back("volumes.port: 3 triangles excluded");
  notes.push_back("volumes.starboard: 3 triangles excluded");
  notes.push_back("contact between lines: a note");
  notes.push_back("contact between lines: a note");
  const std::vector<std::string> expected{
      "lines.a: something else",
      "volumes roller_1 ... roller_18 (18 in all): normal stiffness 1e+06 N/m per m: because",
      "volume deck: normal stiffness 2e+06 N/m per m: because",
      "volumes port and starboard: 3 triangles excluded",
      "contact between lines: a note",
      "contact between lines: a note"};
  EXPECT_EQ(model::grouped_notes(notes), expected);
  EXPECT_TRUE(model::grouped_notes({}).empty());
}

// The weight of a hanging chain of 20 m and wire of 100 m is that of (20 x 50 + 100 x 2) kg; 120 m of chain
// would have five times as much.
TEST(Notes, TensionOfAnAutomaticStiffnessIsTheWeightOfAllSections) {
  const model::Case c = io::read_case_text(R"(
hawser: 1
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 50, EA: 1.0e8, bending: false}
  wire: {outer_diameter: 0.1, mass_per_length: 2, EA: 1.0e8, bending: false}
volumes: {deck: {shape: {plane: {point: [0, 0, -100], normal: [0, 0, 1]}}}}
lines:
  mixed:
    sections: [{type: chain, length: 20, elements: 2}, {type: wire, length: 100, elements: 5}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [100, 0, 0]}
)",
                                           "/nowhere/case.yaml");
  const std::vector<LoadedVolume> volumes = load_volumes(c, MPI_COMM_SELF);
  const Simulation sim(MPI_COMM_SELF, c, surfaces(volumes));
  std::string all;
  for (const std::string& n : sim.notes()) all += n + "\n";
  EXPECT_NE(all.find("a tension of 1.18e+04 N (the line's weight)"), std::string::npos) << all;
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

model::Case rod(int elements, const std::string& between = "false") {
  std::string text = kCase;
  text.replace(text.find("ELEMENTS"), 8, std::to_string(elements));
  text.replace(text.find("BETWEEN"), 7, between);
  return io::read_case_text(text, "/nowhere/case.yaml");
}

// Expected cost: a short run is computed completely by the trial; a longer one is extrapolated at the rate of
// the second half of the trial; without an equilibrium it is 60 static iterations, and 4 iterations for each
// step of half the longest length.
TEST(Cost, ByATrial) {
  TrialRun t;
  t.duration = t.reached = 100;
  t.longest = 0.1;
  t.spent = 3.7;
  t.rate = 7;
  EXPECT_NEAR(expected_cost(t), 3.7, 1e-12);
  EXPECT_EQ(cost_sentence(t), "expected cost: about 3.7 CPU s");
  t.reached = 40;
  t.rate = 0.05;
  EXPECT_NEAR(expected_cost(t), 3.7 + 60 * 0.05, 1e-12);
  EXPECT_EQ(cost_sentence(t), "expected cost: about 6.7 CPU s, by its first 40 of 100 s");
  t.reached = 0;
  t.iteration = 0.01;
  EXPECT_NEAR(expected_cost(t), 0.01 * (60 + 4 * 2000), 1e-12);
  EXPECT_EQ(cost_sentence(t), "expected cost: about 81 CPU s, by the first iterations of statics");
  t.duration = 0;
  EXPECT_EQ(cost_sentence(t), "expected cost: less than 1 CPU s, by the first iterations of statics");
  t.failure = "statics: no way";
  EXPECT_EQ(cost_sentence(t), "a trial run stops: statics: no way");
}

TEST(Cost, ATrialEndsWithItsBudget) {
  const model::Case few = rod(8);
  model::Case many = rod(200);
  many.dynamics.duration = 1e4;
  Simulation small(MPI_COMM_SELF, few);
  Simulation large(MPI_COMM_SELF, many);
  Simulation again(MPI_COMM_SELF, many);
  const TrialRun whole = trial_run(small, few, 100);
  const TrialRun part = trial_run(large, many, 1);
  const TrialRun nothing = trial_run(again, many, 0);
  EXPECT_EQ(whole.failure + part.failure + nothing.failure, "");
  EXPECT_EQ(whole.reached, 100);
  EXPECT_EQ(whole.longest, 0.1);
  EXPECT_EQ(expected_cost(whole), whole.spent);
  EXPECT_GT(part.reached, 0);
  EXPECT_LT(part.reached, 1e4);
  EXPECT_GT(part.rate, 0);
  EXPECT_EQ(part.iteration, 0);
  EXPECT_GT(expected_cost(part), 3 * expected_cost(whole));
  EXPECT_GT(nothing.iteration, 0);
  EXPECT_EQ(nothing.reached, 0);
  EXPECT_GT(expected_cost(nothing), expected_cost(part) / 10);
  EXPECT_LT(expected_cost(nothing), expected_cost(part) * 10);
}

// One iteration is not sufficient for equilibrium: the trial has the message of the run.
TEST(Cost, ATrialReportsWhyTheRunStops) {
  model::Case c = rod(8);
  c.statics.max_iterations = 1;
  c.statics.relaxation = model::Relaxation::never;
  Simulation sim(MPI_COMM_SELF, c);
  const TrialRun trial = trial_run(sim, c, 100);
  EXPECT_EQ(trial.failure.find(
                "statics: Newton's method does not converge within 1 iteration ('max_iterations'): "),
            0U)
      << trial.failure;
  EXPECT_EQ(trial.reached, 0);
}

// The trial refuses what a run refuses at its start, and has the events of the run.
TEST(Cost, ATrialHasTheEventsOfTheRun) {
  const auto cut = [](const std::string& limit) {
    model::Case c = io::read_case_text(R"(hawser: 1
environment: {gravity: 9.80665}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, bending: false}
lines:
  chain:
    sections: [{type: chain, length: 20, elements: 20}]
    end_a: free
    end_b: {anchor: [0, 0, 100]}
dynamics: {duration: 0.1}
events: [{cut: {line: chain, at: 10}, )" + limit +
                                           "}]\ncontact: {between_lines: false}\n",
                                       "/nowhere/case.yaml");
    Simulation sim(MPI_COMM_SELF, c);
    const TrialRun trial = trial_run(sim, c, 100);
    EXPECT_EQ(trial.failure, "");
    EXPECT_NEAR(trial.reached, 0.1, 1e-9);
    const Kinematics rest = sim.state().at_rest();
    const Kinematics end = sim.dynamics().committed_kinematics();
    double fallen = 0;  // centre of mass of the lower part: elements of equal mass
    for (size_t n = 0; n <= 10; ++n) fallen += (n % 10 == 0 ? 0.05 : 0.1) * (rest.x[n].z() - end.x[n].z());
    return fallen;
  };
  try {
    cut("tension: 900");
    FAIL() << "980 N at rest";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("; give another limit, or 'time: 0'"), std::string::npos)
        << e.what();
  }
  EXPECT_NEAR(cut("time: 0.02"), 9.80665 * 0.08 * 0.08 / 2, 1e-9);
}

// Writing of results adds 6 MB. The third row has statics only in the trial.
TEST(Cost, MemoryOfARun) {
  EXPECT_EQ(memory_sentence({43e6, 43e6, 43e6}, 1, 1), "expected memory: about 0.049 GB");
  EXPECT_EQ(memory_sentence({57e6, 61e6, 451e6}, 1, 1), "expected memory: about 0.46 GB");
  EXPECT_EQ(memory_sentence({43e6, 43e6, 316e6, false}, 1, 1), "expected memory: about 0.4 GB");
  // Each of 8 ranks has 143 MB and 11 MB for results and messages, the rest is distributed: 200 x 1.05/8.
  // Reading may take more.
  EXPECT_EQ(memory_sentence({43e6, 143e6, 343e6}, 1.05, 8), "expected memory: about 0.18 GB on each rank");
  EXPECT_EQ(memory_sentence({200e6, 143e6, 343e6}, 1.05, 8), "expected memory: about 0.21 GB on each rank");
  // One rank has all the work.
  EXPECT_EQ(memory_sentence({43e6, 143e6, 343e6}, 2, 2), "expected memory: about 0.35 GB on each rank");
  const double before = peak_memory();
  EXPECT_GT(before, 1e7);
  const std::vector<char> block(static_cast<size_t>(before) + 100'000'000, 1);
  EXPECT_GT(peak_memory(), before + 5e7);
  EXPECT_GT(memory_now(), before);
  EXPECT_LE(memory_now(), peak_memory() + 1e7);
}

TEST(Details, ReportTheStiffnessOfALineWithItself) {
  const auto message = [](const std::string& between) {
    const Simulation sim(MPI_COMM_SELF, rod(10, between));
    for (const std::string& n : sim.details())
      if (n.starts_with("contact of line rod with itself: a normal stiffness of ")) {
        EXPECT_TRUE(
            n.find(" N/m per m, chosen by weight and EA. contact.between_lines.normal_stiffness sets ") !=
            std::string::npos)
            << n;
        return true;
      }
    return false;
  };
  EXPECT_TRUE(message("true"));
  EXPECT_FALSE(message("false"));
  EXPECT_FALSE(message("{normal_stiffness: {per_length: 1e6}}"));
}

}  // namespace
}  // namespace hawser::run::notes_and_cost_test
