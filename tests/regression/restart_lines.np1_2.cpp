// Restarts of buried lines, warm lines, lines in irregular waves, and a platform with radiation memory: equal
// to the uninterrupted run to the last bit on the same number of ranks, within 5e-8 of the range of each
// field on another.
#include <set>

#include "regression/same_fields.hpp"

namespace hawser::runs::restart_lines_test {
namespace {

constexpr double kHalf = 4, kEnd = 8;  // s

struct Kind {
  const char* name;
  const char* text;
  const char *field, *history;  // the field that must be significant; what makes it another run
  const char* other;
};

// A chain in soil so weak that its anchored end yields as the ship moves; a hot pipe on the bed, pulled back
// and forth at one end and too stiff to buckle (round-off would select one of several shapes); a mooring line
// whose ship moves in irregular waves.
const Kind kKinds[] = {{"buried",
                        R"(hawser: 1
environment: {water: {depth: 200}, seabed: {depth: 200, friction: 0.6}}
line_types: {chain: {outer_diameter: 0.216, mass_per_length: 286, EA: 1.2e9, bending: false}}
bodies: {ship: {position: [760, 0, -14], motion: {harmonic: {amplitude: [3, 4, 2], period: 9}, ramp: 2}}}
lines:
  chain:
    sections: [{type: chain, length: 850, elements: 170}]
    end_a: {anchor: [-20, 0, -215]}
    end_b: {body: ship, at: [0, 0, 0]}
    buried: [{to: 25, resistance: {axial: 10 kN/m, normal: 50 kN/m}}]
contact: {between_lines: false}
dynamics: {duration: 8, step: 0.1}
output: {every: 0.5, histories: [{line: chain, at: end_b, name: fairlead}]}
)",
                        "soil_force", "resistance: {axial: 10 kN/m", "resistance: {axial: 11 kN/m"},
                       {"warm",
                        R"(hawser: 1
environment: {water: {depth: 50}, seabed: {depth: 50, friction: {axial: 0.5, lateral: 0.5, mobilisation_length: 5 mm}}}
line_types: {pipe: {outer_diameter: 0.3, mass_per_length: 100, EA: 5e8, EI: 2e7, GJ: 2e7, thermal_expansion: 1.17e-5}}
bodies: {hand: {position: [300, 0, -49.95], motion: {harmonic: {amplitude: [0.1, 0.2, 0], period: 6}, ramp: 2}}}
lines:
  pipe:
    sections: [{type: pipe, length: 300, elements: 150}]
    end_a: free
    end_b: {body: hand, at: [0, 0, 0]}
    start: {points: [[0, 0, -49.95], [300, 0, -49.95]]}
    temperature_change: [[0, 20], [300, 60]]
contact: {between_lines: false}
dynamics: {duration: 8, step: 0.1}
output: {every: 0.5, histories: [{line: pipe, at: end_b, name: fairlead}]}
)",
                        "seabed_friction", "[300, 60]", "[300, 61]"},
                       {"waves",
                        R"(hawser: 1
environment:
  water: {depth: 100}
  seabed: {depth: 100, friction: 0.6}
  waves: {jonswap: {hs: 4, tp: 8, direction_deg: 30, spreading: 10}}
line_types: {chain: {outer_diameter: 0.216, mass_per_length: 286, EA: 1.2e9, bending: false}}
bodies: {ship: {position: [330, 0, -4], motion: {harmonic: {amplitude: [3, 4, 2], period: 9}, ramp: 2}}}
lines:
  chain:
    sections: [{type: chain, length: 370, elements: 74}]
    end_a: {anchor: [0, 0, -100]}
    end_b: {body: ship, at: [0, 0, 0]}
    masses: [{at: 300, mass: 1000, volume: 4}]
contact: {between_lines: false}
dynamics: {duration: 8, step: 0.1}
output: {every: 0.5, histories: [{line: chain, at: end_b, name: fairlead}]}
)",
                        "wall_tension", "hs: 4", "hs: 4.1"},
                       {"platform",
                        R"(hawser: 1
environment: {gravity: 9.81, water: {density: 1000, depth: 50}, seabed: {depth: 50, friction: 0.6}}
line_types: {chain: {outer_diameter: 0.1, mass_per_length: 60, EA: 2e8, bending: false}}
bodies:
  sphere:
    position: [0, 0, 1]
    floating:
      mass: 261800
      inertia: [2.6e6, 2.6e6, 2.6e6]
      stiffness_matrix: [[1e4, 0, 0, 0, 1e4, 0], [0, 1e4, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [1e4, 0, 0, 0, 5e5, 0], [0, 0, 0, 0, 0, 1e5]]
      damping_matrix: [[2e4, 0, 0, 0, 1e4, 0], [0, 1e4, 0, 0, 0, 0], [0, 0, 1e4, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 1e5, 0], [0, 0, 0, 0, 0, 1e5]]
      hydrodynamics: {wamit: )" HAWSER_SOURCE_DIR R"(/tests/data/hemisphere, length_scale: 5}
      loads: [{force: [5e4, 0, 0]}]
lines:
  chain:
    sections: [{type: chain, length: 160, elements: 80}]
    end_a: {anchor: [-145, 0, -50]}
    end_b: {body: sphere, at: [-5, 0, 0]}
contact: {between_lines: false}
statics: false
dynamics: {duration: 8, step: 0.1}
output: {every: 0.5, histories: [{line: chain, at: end_b, name: fairlead}]}
)",
                        "effective_tension", "force: [5e4", "force: [6e4"}};

// With other round-off Newton's iteration ends at another point within its tolerance, 1e-8 of the forces.
constexpr double kNewton = 5e-8;

// Fields and histories are equal to this fraction of their range; 0: to the last bit. `sums`: tolerance of
// energies, which are sums over ranks and time.
void expect_same(const Results& whole, const Results& rest, double share, double sums) {
  ASSERT_EQ(rest.output_times.size(), 9u);
  EXPECT_EQ(rest.output_times.front(), kHalf);
  EXPECT_EQ(tail(whole.step_times, rest.step_times), rest.step_times);
  for (const auto& [name, values] : whole.fields) {
    const auto& there = rest.fields.at(name);
    EXPECT_LE(largest_difference(tail(values, there), there), share * range(values)) << name;
  }
  for (const auto& [name, values] : whole.series) {
    const auto& there = rest.series.at(name);
    const double tolerance = name == "energy" ? sums * largest(values) : share * range(values);
    EXPECT_LE(largest_difference(tail(values, there), there), tolerance) << name;
  }
}

class RestartLines : public ::testing::TestWithParam<Kind> {
 protected:
  // Made once per kind: the whole run, and its first half on all ranks and on one.
  void SetUp() override {
    path = folder(std::string("restart_") + GetParam().name);
    input = path + "/case.yaml";
    static std::set<std::string> made;
    if (!made.insert(path).second) return;
    write_case(input, GetParam().text);
    run_on_all({input, path + "/whole.h5", "", kEnd});
    run_on_all({input, path + "/half.h5", "", kHalf});
    run_on_one({input, path + "/half_one.h5", "", kHalf});
  }
  static bool first() { return rank_of(MPI_COMM_WORLD) == 0; }
  std::string path, input;
};

TEST_P(RestartLines, SameRanks) {
  run_on_all({input, path + "/rest.h5", path + "/half.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  const Results rest = read(path + "/rest.h5");
  EXPECT_GT(largest(whole.fields.at(GetParam().field)), 1e3);
  // Friction energy increases all the time, so the friction history is not that of the rest state.
  const auto taken = whole.column("energy", 3);
  EXPECT_GT(taken.back(), 1.01 * taken[taken.size() / 2]);
  EXPECT_GT(taken[taken.size() / 2], 1);
  expect_same(whole, rest, 0, 1e-14);
}

TEST_P(RestartLines, OtherRanks) {
  run_on_one({input, path + "/fewer.h5", path + "/half.h5", kEnd});
  run_on_all({input, path + "/more.h5", path + "/half_one.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  expect_same(whole, read(path + "/fewer.h5"), kNewton, 1e-8);
  expect_same(whole, read(path + "/more.h5"), kNewton, 1e-8);
}

// After a restart with a changed case (more soil resistance, a warmer pipe) the run differs.
TEST_P(RestartLines, OfAnotherCaseIsRefused) {
  const std::string changed = path + "/changed.yaml";
  write_case(changed, GetParam().text, {{GetParam().history, GetParam().other}});
  run_on_all({changed, path + "/other.h5", path + "/half.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  const Results other = read(path + "/other.h5");
  const auto& there = other.fields.at("position");
  EXPECT_GT(largest_difference(tail(whole.fields.at("position"), there), there), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Lines, RestartLines, ::testing::ValuesIn(kKinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace hawser::runs::restart_lines_test
