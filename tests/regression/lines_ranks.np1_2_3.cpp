// Beams and cables without contact, cut between the ranks, at rest and in motion: results on all ranks are
// those on one within 1e-9.
#include "regression/runs.hpp"

namespace hawser::runs::lines_ranks {
namespace {

// A riser from the ground to a heaving ship, a cable from the ship to a pile, a mast on the ship: supports of
// every kind, grading, damping, a point mass, a ramped load.
const char* const kLines = R"(hawser: 1
title: lines of every kind
environment: {gravity: 9.81}
line_types:
  riser: {outer_diameter: 0.3, mass_per_length: 150, EA: 5.0e7, EI: 2.0e5, GJ: 1.5e5, stiffness_damping: 0.02}
  chain: {bending: false, outer_diameter: 0.1, mass_per_length: 40, EA: 3.0e7, stiffness_damping: 0.01}
  rod: {outer_diameter: 0.1, mass_per_length: 20, EA: 2.0e7, EI: 3.0e4, GJ: 3.0e4}
bodies:
  ship:
    position: [60, 0, 40]
    motion:
      harmonic: {amplitude: [1, 0, 1.5], period: 8, rotation_amplitude_deg: [0, 3, 0]}
      ramp: 4
lines:
  riser:
    sections:
      - {type: riser, length: 40, elements: 20, grading: 2}
      - {type: riser, length: 45, elements: 15}
    end_a: {anchor: [0, 0, 0], direction: [0, 0, 1], clamped: true}
    end_b: {body: ship, at: [0, 0, 0]}
    start: catenary
    loads:
      - {at: 50, force: [0, 2000, 0], ramp: 3}
    masses: [{at: 40, mass: 300}]
  port:
    sections: [{type: chain, length: 75, elements: 25}]
    end_a: {anchor: [20, 60, 20]}
    end_b: {body: ship, at: [0, 2, 0]}
    start: catenary
  mast:
    sections: [{type: rod, length: 12, elements: 11}]
    end_a: {body: ship, at: [2, 0, 3], direction: [1, 0, 0], clamped: true}
    end_b: free
    start: straight
contact: {between_lines: false}
dynamics: {duration: 12, step: STEP, rho_infinity: 0.8}
output:
  every: 1
  histories:
    - {line: riser, at: end_b, name: hang-off}
    - {line: port, at: end_a, name: pile}
)";

// A chain of cables with so few nodes that a rank has one or none.
const char* const kChain = R"(hawser: 1
line_types:
  chain: {bending: false, outer_diameter: 0.1, mass_per_length: 40, EA: 3.0e6}
lines:
  chain:
    sections: [{type: chain, length: 12, elements: ELEMENTS}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [10, 0, 0]}
    loads: [{per_length: [0, 200, 0], ramp: 1}]
contact: {between_lines: false}
dynamics: {duration: 2, step: 0.02}
output: {every: 0.1, histories: [{line: chain, at: end_a, name: pile}]}
)";

void compare(const std::string& which, const std::string& text, const Edits& edits, size_t outputs,
             double speed) {
  const std::string path = folder("lines_" + which);
  const std::string input = path + "/lines.yaml";
  write_case(input, text, edits);
  run_on_one({input, path + "/one.h5"});
  run_on_all({input, path + "/all.h5"});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Results one = read(path + "/one.h5");
  const Results all = read(path + "/all.h5");
  ASSERT_GT(one.step_times.size(), 50u);
  EXPECT_EQ(one.output_times.size(), outputs);
  EXPECT_EQ(one.output_times, all.output_times);
  EXPECT_LE(largest_difference(one.step_times, all.step_times), 1e-12);
  EXPECT_GE(largest(one.fields.at("velocity")), speed);  // it moves
  ASSERT_EQ(one.fields.size(), all.fields.size());
  for (const auto& [name, values] : one.fields) {
    const auto& there = all.fields.at(name);
    EXPECT_LE(largest_difference(values, there), 1e-9 * largest(values)) << name;
    std::printf("%s %.1e  ", name.c_str(),
                largest_difference(values, there) / std::max(largest(values), 1e-300));
  }
  std::printf("\n");
  for (const std::string point : {"hang-off", "pile"})
    for (size_t c = 0; one.columns.count(point) && c < one.columns.at(point); ++c) {
      const auto a = one.column(point, c);
      const auto b = all.column(point, c);
      // Values that are zero by symmetry have the round-off of the forces.
      const double round_off = 1e-13 * largest(one.series.at(point));
      EXPECT_LE(largest_difference(a, b), 1e-9 * largest(a) + round_off) << point << ' ' << c;
    }
}

TEST(LinesRanks, FixedStep) { compare("fixed", kLines, {{"STEP", "0.05"}}, 13, 1); }
TEST(LinesRanks, AutomaticStep) { compare("auto", kLines, {{"STEP", "auto"}}, 13, 1); }
TEST(LinesRanks, FewNodes) {
  compare("two", kChain, {{"ELEMENTS", "2"}}, 21, 0.1);
  compare("one", kChain, {{"ELEMENTS", "1"}, {"length: 12", "length: 9.9"}}, 21, 0);
}

}  // namespace
}  // namespace hawser::runs::lines_ranks
