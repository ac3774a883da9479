// A pipe that is bent beyond yield and straightened: moments, residual curvature, energy balance, restarts,
// ranks.
#include "hawser/kernels/plastic_bending.hpp"

#include <cmath>

#include "regression/runs.hpp"

namespace hawser::runs::plastic_bending {
namespace {

constexpr double kLength = 12, kMost = 0.06;  // m, 1/m
const double kEI = 207e9 * M_PI / 64 * (std::pow(0.2, 4) - std::pow(0.18, 4));

// A pipe is bent into an arc within 4 s and straightened again: both ends are clamped, and one moves as the
// end of an arc of constant length.
std::string bent() {
  std::string rows;
  for (int k = 0; k <= 32; ++k) {
    const double t = 0.25 * k;
    const double c = kMost * std::pow(std::sin(M_PI * t / 8), 2);
    const double turn = c * kLength;
    const double along = c > 0 ? std::sin(turn) / c : kLength;
    const double up = c > 0 ? (1 - std::cos(turn)) / c : 0;
    char row[200];
    std::snprintf(row, sizeof row, "%s[%.2f, %.9f, 0, %.9f, 0, %.9f, 0]", k ? ", " : "", t, along - kLength,
                  up, -turn * 180 / M_PI);
    rows += row;
  }
  return R"(hawser: 1
title: A pipe bent beyond yield
environment: {gravity: 0}
line_types:
  pipe:
    pipe: {outer_diameter: 0.2, wall_thickness: 0.01}
    plasticity: {ramberg_osgood: {yield_moment: 120 kN m, A: 0.4, B: 12}}
    stiffness_damping: 0.02
bodies:
  clamp:
    position: [12, 0, 0]
    motion: {table: {interpolation: spline, rows: [)" +
         rows + R"(]}}
lines:
  pipe:
    sections: [{type: pipe, length: 12, elements: 24}]
    start: straight
    end_a: {anchor: [0, 0, 0], clamped: true, direction: [1, 0, 0]}
    end_b: {body: clamp, at: [0, 0, 0], clamped: true, direction: [1, 0, 0]}
dynamics: {duration: 8, max_step: 0.02}
output: {every: 1}
contact: {between_lines: false}
)";
}

TEST(PlasticPipe, KeepsItsBend) {
  const std::string path = folder("plastic");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, bent());
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  ASSERT_EQ(r.output_times.size(), 9u);
  const auto at = [&](const char* field, size_t output, size_t node) {
    return r.fields.at(field).at(25 * output + node);
  };
  const PlasticBending law(ramberg_osgood(kEI, 120e3, 0.4, 12, 0.5, 21));
  const auto first = [&](double c) { return law.at(c, 0, nullptr).m[0]; };
  // Moments by the curve of the first bend, then by Masing's rule; the residual curvature is that after
  // elastic unloading.
  const double most = first(kMost);
  const double back = most - 2 * first(0.5 * kMost);
  const double stays = kMost - most / law.initial();
  printf("  bent: %.1f kN m (%.1f); back: %.1f kN m (%.1f), %.5f 1/m stay (%.5f)\n",
         at("bending_moment", 4, 12) / 1e3, most / 1e3, at("bending_moment", 8, 12) / 1e3, -back / 1e3,
         at("residual_curvature", 4, 12), stays);
  for (const size_t node : {0u, 12u, 24u}) {
    // In the plastic range an error of 0.05 % in the moment makes one of 0.4 % in the curvature.
    EXPECT_NEAR(at("curvature", 4, node), kMost, 5e-3 * kMost) << node;
    EXPECT_NEAR(at("bending_moment", 4, node), most, 2e-3 * most) << node;
    EXPECT_NEAR(at("bending_moment", 8, node), -back, 5e-3 * most) << node;
    EXPECT_EQ(at("residual_curvature", 0, node), 0);
    EXPECT_NEAR(at("residual_curvature", 4, node), stays, 5e-3 * kMost) << node;
  }
}

TEST(PlasticPipe, EnergyIsAccountedFor) {
  const std::string path = folder("plastic-energy");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, bent());
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto column = [&](const char* name) { return named(file, r, "energy", name); };
  const double in = column("brought_in").back();
  const double taken = column("damping").back();
  const double error = column("error").back();
  printf("  brought in %.4g J, dissipated %.4g J, not accounted for %.3g J\n", in, taken, error);
  EXPECT_GT(taken, 5e4);
  EXPECT_LT(std::abs(error), 1e-2 * taken);
}

TEST(PlasticPipe, GoesOnAfterARestart) {
  const std::string path = folder("plastic-restart");
  const std::string input = path + "/case.yaml";
  write_case(input, bent());
  run_on_all({input, path + "/whole.h5"});
  run_on_all({input, path + "/half.h5", "", 5.0});
  run_on_all({input, path + "/rest.h5", path + "/half.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results whole = read(path + "/whole.h5");
  const Results rest = read(path + "/rest.h5");
  for (const char* field : {"bending_moment", "residual_curvature"}) {
    const auto& a = whole.fields.at(field);
    const auto& b = rest.fields.at(field);
    double most = 0;
    for (const double v : a) most = std::max(most, std::abs(v));
    for (size_t n = 0; n < 25; ++n)
      EXPECT_NEAR(a[a.size() - 25 + n], b[b.size() - 25 + n], 1e-8 * most) << field;
  }
}

}  // namespace
}  // namespace hawser::runs::plastic_bending
