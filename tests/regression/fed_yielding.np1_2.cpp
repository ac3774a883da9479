// Pipes that yield while they are paid out and hauled in: residual curvature moves with the material; energy
// balance, restarts in the middle of an element, ranks.
#include <algorithm>
#include <cmath>

#include "hawser/kernels/plastic_bending.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::fed_yielding {
namespace {

const std::vector<PlasticBending::Row> kRows{{0.02, 100e3}, {0.06, 140e3}, {0.5, 200e3}};  // 1/m, N m

// An end moment bends the outside part into one arc. The clamp pays out 3.8 m more and hauls them in, twice.
constexpr double kMoment = 150e3, kEI = 5e6;                      // N m, N m²
constexpr double kBent = 0.06 + (kMoment - 140e3) * 0.44 / 60e3;  // 1/m, on the curve
constexpr double kStays = kBent - kMoment / kEI;
const char* const kArc = R"(hawser: 1
title: A pipe bent beyond yield as it leaves a clamp
environment: {gravity: 0}
line_types:
  pipe:
    outer_diameter: 0.2
    mass_per_length: 50
    EA: 1e9
    EI: 5e6
    GJ: 4e6
    plasticity: {table: [[0.02, 100e3], [0.06, 140e3], [0.5, 200e3]]}
lines:
  pipe:
    sections: [{type: pipe, length: 16, elements: 32}]
    end_a:
      anchor: [0, 0, 0]
      direction: [1, 0, 0]
      clamped: true
      feed: {stock: 12, speed_table: [[1, 0], [3, 0.2], [20, 0.2], [24, -0.2], [41, -0.2], [45, 0.2], [62, 0.2], [64, 0]]}
    end_b: free
    start: straight
    loads: [{at: end_b, moment: [0, 150e3, 0]}]
dynamics: {duration: 65, step: 0.02}
output: {every: 1, histories: [{line: pipe, at: end_b, name: tip}]}
contact: {between_lines: false}
)";

// The movement of its end bends 6 m into an arc and straightens it; the pipe is then paid out by 3.25 m and
// hauled in.
std::string carried() {
  constexpr double length = 6, most = 0.1;
  std::string rows;
  char row[200];
  for (int k = 0; k <= 32; ++k) {
    const double t = 0.25 * k;
    const double c = most * std::pow(std::sin(M_PI * t / 8), 2);
    const double turn = c * length;
    const double along = c > 0 ? std::sin(turn) / c : length;
    const double up = c > 0 ? (1 - std::cos(turn)) / c : 0;
    std::snprintf(row, sizeof row, "%s[%.2f, %.9f, 0, %.9f, 0, %.9f, 0]", k ? ", " : "", t, along - length,
                  up, -turn * 180 / M_PI);
    rows += row;
  }
  // The end moves by the length paid out.
  const auto ramped = [](double t, double from) {  // integral of a speed that rises to 0.5 m/s within 1 s
    const double s = std::clamp(t - from, 0.0, 1.0);
    return 0.25 * s * s + 0.5 * std::max(t - from - 1, 0.0);
  };
  for (double t = 8.25; t <= 27; t += 0.25) {
    const double x = ramped(t, 9) - ramped(t, 15.5) - ramped(t, 18) + ramped(t, 24.5);
    std::snprintf(row, sizeof row, ", [%.2f, %.9f, 0, 0, 0, 0, 0]", t, x);
    rows += row;
  }
  return R"(hawser: 1
title: A bent stretch of pipe carried away from a clamp
environment: {gravity: 0}
line_types:
  pipe:
    outer_diameter: 0.2
    mass_per_length: 50
    EA: 1e8
    EI: 5e6
    GJ: 4e6
    plasticity: {table: [[0.02, 100e3], [0.06, 140e3], [0.5, 200e3]]}
bodies:
  clamp: {position: [6, 0, 0], motion: {table: {interpolation: spline, rows: [)" +
         rows + R"(]}}}
lines:
  pipe:
    sections: [{type: pipe, length: 16, elements: 32}]
    end_a:
      anchor: [0, 0, 0]
      direction: [1, 0, 0]
      clamped: true
      feed: {stock: 10, speed_table: [[9, 0], [10, 0.5], [15.5, 0.5], [16.5, 0], [18, 0], [19, -0.5], [24.5, -0.5], [25.5, 0]]}
    end_b: {body: clamp, at: [0, 0, 0], direction: [1, 0, 0], clamped: true}
    start: straight
dynamics: {duration: 26, step: 0.02}
output: {every: 1}
contact: {between_lines: false}
)";
}

double at(const Results& r, const char* field, size_t output, size_t node) {
  return r.fields.at(field).at(33 * output + node);
}

TEST(FedYielding, LeavesAClampInAnArc) {
  const std::string path = folder("fed-yielding-arc");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kArc);
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto out = named(file, r, "pipe_end_a_feed", "paid_out");
  const auto damping = named(file, r, "energy", "damping");
  const auto error = named(file, r, "energy", "error");
  // After paying out, hauling in and paying out again, all of the material that was outside has the curvature
  // of the curve.
  double off = 0, curve = 0;
  for (const size_t output : {22u, 43u, 64u})
    for (size_t node = 25; node < 32; ++node) {
      off = std::max(off, std::abs(at(r, "residual_curvature", output, node) / kStays - 1));
      curve = std::max(curve, std::abs(at(r, "curvature", output, node) / kBent - 1));
    }
  for (size_t node = 18; node < 25; ++node)
    for (const size_t output : {22u, 64u})
      off = std::max(off, std::abs(at(r, "residual_curvature", output, node) / kStays - 1));
  // Dissipation: the first bend of all material that has left, and straightening and bending again of what
  // was hauled in.
  const PlasticBending law(kRows);
  std::vector<double> set(law.memory(), 0);
  const double first = law.bend(kBent, 0, set.data());
  law.bend(0, 0, set.data());
  const double again = law.bend(kBent, 0, set.data());
  const double paid = *std::max_element(out.begin(), out.end());
  printf("  residual curvature off by %.2e, curvature by %.2e; lost %.0f J of %.0f + %.0f J; energy %.2g J\n",
         off, curve, damping.back(), first * paid, again * paid, largest(error));
  EXPECT_LT(off, 0.01);
  EXPECT_LT(curve, 0.005);
  EXPECT_NEAR(damping.back(), (first + again) * paid, 0.01 * damping.back());
  EXPECT_LT(largest(error), 1e-3 * damping.back());
}

TEST(FedYielding, BendsTravelWithTheMaterial) {
  const std::string path = folder("fed-yielding-carried");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, carried());
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  // Nodes 20 to 32 were outside during bending. At 17 s 3.25 m more are outside; at 26 s all is hauled in.
  // Near the clamps the straightened pipe yields again, because it pulls against them.
  const double bent = at(r, "residual_curvature", 8, 26);
  double away = 0, back = 0, straight = 0;
  for (size_t node = 22; node <= 28; ++node) {
    const double then = at(r, "residual_curvature", 8, node);
    away = std::max(away, std::abs(at(r, "residual_curvature", 17, node) - then));
    back = std::max(back, std::abs(at(r, "residual_curvature", 26, node) - then));
  }
  for (size_t node = 15; node < 19; ++node)
    straight = std::max(straight, at(r, "residual_curvature", 17, node));
  printf("  %.5f 1/m stay; away %.1e, back %.1e, what was straight %.1e\n", bent, away, back, straight);
  EXPECT_GT(bent, 0.02);
  EXPECT_LT(away, 0.01 * bent);
  EXPECT_LT(back, 0.01 * bent);
  EXPECT_LT(straight, 0.02 * bent);
}

TEST(FedYielding, GoOnInTheMiddleOfAnElement) {
  const std::string path = folder("fed-yielding-restart");
  const std::string input = path + "/case.yaml";
  const std::string whole = path + "/whole.h5";
  const std::string half = path + "/half.h5";
  const std::string rest = path + "/rest.h5";
  write_case(input, kArc, {{"duration: 65", "duration: 34"}});
  run_on_all({input, whole});
  for (const double time : {13.3, 29.7}) {  // while paying out; while hauling in
    run_on_all({input, half, "", time});
    run_on_all({input, rest, half});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results a = read(whole);
    const Results b = read(rest);
    for (const char* field : {"position", "residual_curvature", "bending_moment"}) {
      const auto& x = a.fields.at(field);
      const auto& y = b.fields.at(field);
      const size_t row = x.size() / a.output_times.size();
      const std::vector<double> u(x.end() - static_cast<std::ptrdiff_t>(row), x.end());
      const std::vector<double> v(y.end() - static_cast<std::ptrdiff_t>(row), y.end());
      EXPECT_LT(largest_difference(u, v), 1e-7 * largest(u)) << field << " from " << time;
    }
  }
}

TEST(FedYielding, AreTheSameOnAllRanks) {
  if (size_of(MPI_COMM_WORLD) == 1) GTEST_SKIP() << "one rank";
  const std::string path = folder("fed-yielding-ranks");
  const std::string input = path + "/case.yaml";
  const std::string all = path + "/all.h5";
  const std::string one = path + "/one.h5";
  write_case(input, kArc, {{"duration: 65", "duration: 34"}});
  run_on_all({input, all});
  run_on_one({input, one});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results a = read(all);
  const Results b = read(one);
  for (const char* field : {"position", "residual_curvature", "bending_moment"})
    EXPECT_LT(largest_difference(a.fields.at(field), b.fields.at(field)), 1e-5 * largest(b.fields.at(field)))
        << field;
}

}  // namespace
}  // namespace hawser::runs::fed_yielding
