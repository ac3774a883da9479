// Histories of points between nodes, also between nodes of two ranks, against the fields of the same run.
#include <fmt/format.h>

#include "regression/runs.hpp"

namespace hawser::runs::histories {
namespace {

constexpr int kElements = 20;
constexpr double kLength = 100, kElement = kLength / kElements;
constexpr int kWeight = 12;  // node that carries the clump weight

// A point 0.3 of the way along every element, and the node with the weight itself.
std::string case_text() {
  std::string text = R"(hawser: 1
title: A chain with a clump weight whose upper end surges
environment:
  water: {}
  seabed: {depth: 90}
line_types:
  chain: {library: chain-studless, diameter: 0.06, grade: R4}
bodies:
  ship: {motion: {harmonic: {amplitude: [1, 0, 0], period: 6}, ramp: 2}}
lines:
  chain:
    sections: [{type: chain, length: 100, elements: 20}]
    end_a: {anchor: [0, 0, -60]}
    end_b: {body: ship, at: [70, 0, -5]}
    masses: [{at: 60, mass: 2000, volume: 0.2}]
dynamics: {duration: 1}
output:
  every: 0.5
  histories:
)";
  for (int e = 0; e < kElements; ++e)
    text += fmt::format("    - {{line: chain, at: {}, name: p{}}}\n", (e + 0.3) * kElement, e);
  return text + "    - {line: chain, at: 60, name: weight}\n    - {line: chain, at: end_b, name: ship end}\n";
}

TEST(Histories, PointsBetweenNodes) {
  const std::string path = folder("histories");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, case_text());
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  ASSERT_EQ(r.step_times.back(), r.output_times.back());
  const auto last = [&](const std::string& field, int node) {
    const auto& all = r.fields.at(field);
    return all.at(all.size() - static_cast<size_t>(kElements + 1 - node));
  };
  for (int e = 0; e < kElements; ++e) {
    const auto shown = [&](const std::string& column) {
      return named(file, r, "p" + std::to_string(e), column).back();
    };
    const auto between = [](double a, double b) { return 0.7 * a + 0.3 * b; };
    const double tension =
        between(last("effective_tension_after", e), last("effective_tension_before", e + 1));
    for (const char* column : {"effective_tension", "effective_tension_before", "effective_tension_after"})
      EXPECT_NEAR(shown(column), tension, 1e-9 * tension) << e << ' ' << column;
    if (e != kWeight - 1 && e != kWeight) {
      EXPECT_NEAR(shown("wall_tension"), between(last("wall_tension", e), last("wall_tension", e + 1)),
                  1e-9 * tension);
      EXPECT_NEAR(shown("declination"), between(last("declination", e), last("declination", e + 1)), 1e-9);
    }
    const auto& x = r.fields.at("position");
    const size_t row = x.size() - 3 * static_cast<size_t>(kElements + 1 - e);
    for (size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(shown(std::string("position_") + "xyz"[k]), between(x[row + k], x[row + 3 + k]), 1e-12);
  }
  // Tensions differ between both sides of the weight; points near it have the tension of their side.
  const double before = named(file, r, "weight", "effective_tension_before").back();
  const double after = named(file, r, "weight", "effective_tension_after").back();
  EXPECT_EQ(before, last("effective_tension_before", kWeight));
  EXPECT_EQ(after, last("effective_tension_after", kWeight));
  EXPECT_GT(after - before, 5e3);
  EXPECT_EQ(r.columns.at("ship_end"), r.columns.at("p3") + 8);
}

// A cantilever with a force and a torque at 5 m: a point just beyond them has neither shear nor torsion, a
// point just before them has all of both.
TEST(Histories, PointsBesideALoad) {
  const std::string path = folder("histories-beam");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A cantilever
environment: {gravity: 0}
line_types:
  pipe: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e8, EI: 1e7, GJ: 1e7}
lines:
  pipe:
    sections: [{type: pipe, length: 10, elements: 10}]
    end_a: {anchor: [0, 0, 0], direction: [1, 0, 0], clamped: true}
    end_b: free
    start: straight
    loads: [{at: 5, force: [0, 0, -1 kN]}, {at: 5, moment: [500, 0, 0]}]
output:
  histories: [{line: pipe, at: 4.5, name: before}, {line: pipe, at: 5.5, name: behind}]
)");
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  EXPECT_NEAR(named(file, r, "before", "shear_force").front(), 1000, 0.1);
  EXPECT_NEAR(named(file, r, "before", "torsion_moment").front(), 500, 0.1);
  EXPECT_NEAR(named(file, r, "before", "bending_moment").front(), 500, 0.5);
  for (const char* none : {"shear_force", "torsion_moment", "bending_moment"})
    EXPECT_NEAR(named(file, r, "behind", none).front(), 0, 0.2) << none;
}

}  // namespace
}  // namespace hawser::runs::histories
