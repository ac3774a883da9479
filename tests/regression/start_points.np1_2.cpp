// Points of a start shape that differ from the held ends by rounding: the ends are at their anchors from
// statics on.
#include <cmath>

#include "regression/runs.hpp"

namespace hawser::runs::start_points_test {
namespace {

// A wire between two anchors; its first point is 9 cm beside the anchor, its
// second one at the anchor.
const char* const kWire = R"(hawser: 1
line_types: {wire: {outer_diameter: 0.05, mass_per_length: 10, EA: 1e8, bending: false}}
lines:
  wire:
    sections: [{type: wire, length: 100, elements: 40}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [100, 0, 0]}
    start: {points: [[0.09, 0, 0], [0, 0, 0], [100.02, 0, 0]]}
dynamics: {duration: 0.5}
output: {every: 0.1, histories: [{line: wire, at: end_a, name: a}]}
)";

TEST(StartPoints, HeldEndsAreAtTheirAnchors) {
  const std::string path = runs::folder("start-points");
  const std::string input = path + "/case.yaml";
  write_case(input, kWire, {});
  run_on_all({input, path + "/case.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results all = read(path + "/case.h5");
  const auto x = named(path + "/case.h5", all, "a", "position_x");
  const auto T = named(path + "/case.h5", all, "a", "effective_tension");
  // Shallow parabola: T³ = EA (w L)²/24, and the end has T sqrt(1 + (w L/2T)²).
  const double weight = 10 * 9.80665 * 100;
  const double level = std::cbrt(1e8 * weight * weight / 24);
  for (size_t i = 0; i < T.size(); ++i) {
    EXPECT_NEAR(x[i], 0, 1e-9);
    EXPECT_NEAR(T[i], std::hypot(level, weight / 2), 2e-3 * level) << i;
  }
}

}  // namespace
}  // namespace hawser::runs::start_points_test
