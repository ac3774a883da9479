// A line is paid out over a crossing line and hauled in, in contact with it in the element at the feed point:
// friction, energy balance, restarts, ranks.
#include "regression/runs.hpp"

namespace hawser::runs::fed_crossing {
namespace {

// The rail crosses 0.5 m from the winch; the element at the feed point is 0.2 to 0.75 m long.
const char* const kCrossing = R"(hawser: 1
title: A rope is drawn over another at the winch that it comes from
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 4, EA: 1e6, bending: false, stiffness_damping: 0.02}
  rail: {outer_diameter: 0.1, mass_per_length: 4, EA: 1e6, bending: false, stiffness_damping: 0.02}
lines:
  rope:
    sections: [{type: rope, length: 16, elements: 32}]
    end_a: {anchor: [0, 0, 0], feed: {stock: 3.5, speed_table: [[0, 0], [1, 0.5], [4, 0.5], [6, -0.5], [9, -0.5]]}}
    end_b: {anchor: [10.05, 0, 0], feed: {stock: 2.5, speed_table: [[0, 0], [1, -0.5], [4, -0.5], [6, 0.5], [9, 0.5]]}}
    start: straight
  rail:
    sections: [{type: rail, length: 3.98, elements: 11}]
    end_a: {anchor: [0.5, -2, -0.05]}
    end_b: {anchor: [0.5, 2, -0.05]}
dynamics: {duration: 9}
output: {every: 0.25}
contact: {between_lines: {friction: 0.3}}
)";

const Edits kKept{{"stock: 2.5, speed_table: [[0, 0], [1, -0.5], [4, -0.5], [6, 0.5], [9, 0.5]]",
                   "stock: 2.5, tension: 5 kN, speed_per_tension: 1e-3, max_speed: 1"}};
// The feeder at the crossing keeps a tension: only the rank of its feed point has its speed.
const Edits kPulled{{"stock: 3.5, speed_table: [[0, 0], [1, 0.5], [4, 0.5], [6, -0.5], [9, -0.5]]",
                     "stock: 3.5, tension: 5 kN, speed_per_tension: 1e-3, max_speed: 1"}};
const Edits kPipe{{"bending: false, stiffness_damping: 0.02}", "EI: 2000, GJ: 2000}"},
                  {"anchor: [0, 0, 0]", "anchor: [0, 0, 0], direction: [1, 0, 0], clamped: true"},
                  {"anchor: [10.05, 0, 0]", "anchor: [10.05, 0, 0], direction: [1, 0, 0], clamped: true"}};

// Friction on the rail is mu N except near the reversal, and the energy balance with the work of the feeders
// on the sliding material closes.
TEST(FedCrossing, FrictionAndEnergy) {
  const std::string path = folder("fed-crossing");
  for (const auto& [name, edits] : {std::pair{"rope", Edits{}}, {"kept", kKept}, {"pipe", kPipe}}) {
    const std::string input = path + "/" + name + ".yaml";
    const std::string file = path + "/" + name + ".h5";
    write_case(input, kCrossing, edits);
    run_on_all({input, file});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results r = read(file);
    constexpr size_t kNodes = 45, kRail = 33;
    const auto& f = r.fields.at("line_friction_force");
    const auto& n = r.fields.at("line_contact_normal_force");
    double off = 0, least = HUGE_VAL, most = 0;
    for (size_t i = 0; i < r.output_times.size(); ++i) {
      const double t = r.output_times[i];
      double drag = 0, pressed = 0;
      for (size_t k = kRail; k < kNodes; ++k) {
        drag += f[3 * (kNodes * i + k)];
        pressed += n[kNodes * i + k];
      }
      least = std::min(least, pressed);
      most = std::max(most, pressed);
      const double mu = t < 5 ? 0.3 : -0.3;
      if (t > 0.3 && std::abs(t - 5) > 0.3) off = std::max(off, std::abs(drag / (mu * pressed) - 1));
    }
    const auto error = named(file, r, "energy", "error");
    const auto friction = named(file, r, "energy", "friction");
    printf("  %s: %.0f to %.0f N on the rail, friction off by %.1e; %.1f J of friction, error %.2f J\n", name,
           least, most, off, friction.back(), largest(error));
    EXPECT_GT(least, 50);
    EXPECT_LT(off, 0.01);
    EXPECT_GT(friction.back(), 200);
    EXPECT_LT(largest(error), 5e-3 * friction.back());
  }
}

void expect_same(const std::string& a, const std::string& b) {
  const Results whole = read(a);
  const Results rest = read(b);
  for (const char* field : {"position", "line_friction_force"}) {
    const auto& there = rest.fields.at(field);
    EXPECT_LT(largest_difference(tail(whole.fields.at(field), there), there), 1e-6 * largest(there))
        << b << field;
  }
  const auto e = named(a, whole, "energy", "friction");
  const auto g = named(b, rest, "energy", "friction");
  EXPECT_NEAR(e.back(), g.back(), 1e-6 * e.back());
}

// Restarts in the middle of an element while paying out (one rank) and hauling in; equal results on all
// ranks.
TEST(FedCrossing, RestartsAndRanks) {
  const std::string path = folder("fed-crossing-again");
  for (const auto& [name, edits] : {std::pair{"rope", Edits{}}, {"kept", kKept}, {"pulled", kPulled}}) {
    const std::string base = path + "/" + name;
    const std::string input = base + ".yaml";
    write_case(input, kCrossing, edits);
    run_on_all({input, base + ".h5"});
    for (const double stop : {2.25, 7.25}) {
      if (stop < 5 && size_of(MPI_COMM_WORLD) > 1 && !std::getenv("HAWSER_FULL")) continue;
      run_on_all({input, base + "-half.h5", "", stop});
      run_on_all({input, base + "-rest.h5", base + "-half.h5"});
      if (rank_of(MPI_COMM_WORLD) == 0) expect_same(base + ".h5", base + "-rest.h5");
    }
    if (size_of(MPI_COMM_WORLD) == 1) continue;
    run_on_one({input, base + "-one.h5"});
    if (rank_of(MPI_COMM_WORLD) == 0) expect_same(base + "-one.h5", base + ".h5");
  }
}

}  // namespace
}  // namespace hawser::runs::fed_crossing
