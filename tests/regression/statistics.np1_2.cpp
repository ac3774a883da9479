// Statistics over all steps in the results file against the histories of the same run, on other ranks, and
// after a restart; histories of touchdown points; a first output at rest.
#include "regression/runs.hpp"

namespace hawser::runs::statistics {
namespace {

const char* const kCase = R"(hawser: 1
title: A chain whose fairlead surges in a sea
environment:
  water: {}
  seabed: {depth: 40}
  waves: {jonswap: {hs: 3, tp: 8, seed: 2}}
line_types:
  chain: {library: chain-studless, diameter: 0.08, grade: R4}
bodies:
  ship: {motion: {harmonic: {amplitude: [1, 0, 0], period: 6}, ramp: 4}}
lines:
  chain:
    sections: [{type: chain, length: 160, elements: 32}]
    end_a: {anchor: [0, 0, -40]}
    end_b: {body: ship, at: [145, 0, -5]}
dynamics: {duration: 12}
output:
  every: 3
  histories: [{line: chain, at: 160, name: fairlead}, {line: chain, at: 95, name: middle}]
)";

struct Statistics {
  std::vector<double> values;
  double at(size_t node, size_t which) const { return values.at(6 * node + which); }
};

Statistics statistics(const std::string& path, const std::string& field) {
  const auto file = io::h5::open_read(path);
  return {io::h5::read_array(file, "statistics/" + field).values};
}

class StatisticsRanks : public ::testing::Test {
 protected:
  void SetUp() override {
    path = folder("statistics");
    input = path + "/case.yaml";
    static bool made = false;
    if (std::exchange(made, true)) return;
    write_case(input, kCase);
    run_on_all({input, path + "/whole.h5"});
  }
  std::string path, input;
};

// Reference: trapezoidal mean, extremes and their times of the histories, which have every step.
TEST_F(StatisticsRanks, AreThoseOfTheHistories) {
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const std::string file = path + "/whole.h5";
  const Results r = read(file);
  for (const auto& [series, node] : {std::pair{"fairlead", size_t{32}}, {"middle", size_t{19}}})
    for (const char* field : {"effective_tension", "wall_tension", "declination", "utilisation"}) {
      const std::vector<double> v = named(file, r, series, field);
      const auto low = std::min_element(v.begin(), v.end());
      const auto high = std::max_element(v.begin(), v.end());
      double mean = 0, square = 0;
      for (size_t i = 1; i < v.size(); ++i) {
        const double h = r.step_times[i] - r.step_times[i - 1];
        mean += h * (v[i] + v[i - 1]) / 2;
        square += h * (v[i] * v[i] + v[i] * v[i - 1] + v[i - 1] * v[i - 1]) / 3;
      }
      mean /= r.step_times.back();
      square /= r.step_times.back();
      const Statistics s = statistics(file, field);
      EXPECT_EQ(s.at(node, 0), *low) << field;
      EXPECT_EQ(s.at(node, 1), r.step_times[static_cast<size_t>(low - v.begin())]) << field;
      EXPECT_EQ(s.at(node, 2), *high) << field;
      EXPECT_EQ(s.at(node, 3), r.step_times[static_cast<size_t>(high - v.begin())]) << field;
      EXPECT_NEAR(s.at(node, 4), mean, 1e-12 * std::abs(mean)) << field;
      EXPECT_NEAR(s.at(node, 5), std::sqrt(square - mean * mean), 1e-6 * std::abs(mean)) << field;
      EXPECT_GT(s.at(node, 2) - s.at(node, 0), 1e-4 * std::abs(mean)) << field;
    }
  // The acceleration is that of the ship's surge, after its ramp.
  const auto a = named(file, r, "fairlead", "acceleration_x");
  const auto x = named(file, r, "fairlead", "position_x");
  for (size_t i = 0; i < a.size(); ++i)
    if (r.step_times[i] > 4) {
      EXPECT_NEAR(a[i], -std::pow(2 * M_PI / 6, 2) * (x[i] - 145), 1e-6);
    }
}

TEST_F(StatisticsRanks, GoOnAfterARestart) {
  run_on_all({input, path + "/half.h5", "", 6});
  run_on_all({input, path + "/rest.h5", path + "/half.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  for (const char* field : {"effective_tension", "declination"})
    EXPECT_EQ(statistics(path + "/whole.h5", field).values, statistics(path + "/rest.h5", field).values);
}

TEST_F(StatisticsRanks, AreTheSameOnOneRank) {
  run_on_one({input, path + "/one.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Statistics all = statistics(path + "/whole.h5", "effective_tension");
  const Statistics one = statistics(path + "/one.h5", "effective_tension");
  for (size_t n = 0; n <= 32; ++n)
    for (const size_t which : {0u, 2u, 4u, 5u})
      EXPECT_NEAR(all.at(n, which), one.at(n, which), 1e-6 * one.at(32, 2)) << n << ' ' << which;
}

// The first output and the first row are the static equilibrium, although the ship has an initial velocity.
TEST_F(StatisticsRanks, BeginAtRest) {
  write_case(path + "/rest.yaml", kCase, {{"dynamics: {duration: 12}\n", ""}});
  run_on_all({path + "/rest.yaml", path + "/static.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results still = read(path + "/static.h5");
  const Results moving = read(path + "/whole.h5");
  const auto& t = still.fields.at("effective_tension");
  const std::vector<double> first(moving.fields.at("effective_tension").begin(),
                                  moving.fields.at("effective_tension").begin() + 33);
  ASSERT_EQ(t.size(), 33u);
  EXPECT_LE(largest_difference(t, first), 1e-9 * largest(t));
  EXPECT_NEAR(named(path + "/whole.h5", moving, "fairlead", "effective_tension").front(), t.back(),
              1e-9 * t.back());
}

// The touchdown point moves with the ship.
TEST_F(StatisticsRanks, TouchdownPointsMove) {
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const std::string file = path + "/whole.h5";
  const Results r = read(file);
  const auto arc = named(file, r, "touchdown", "end_b_arc_length");
  const auto laid = named(file, r, "touchdown", "laid_length");
  const auto x = named(file, r, "touchdown", "end_b_position_x");
  const auto z = named(file, r, "touchdown", "end_b_position_z");
  ASSERT_EQ(arc.size(), r.step_times.size());
  const auto [least, most] = std::minmax_element(arc.begin(), arc.end());
  EXPECT_GT(*least, 60);
  EXPECT_LT(*most, 120);
  EXPECT_GT(*most - *least, 1);
  for (size_t i = 0; i < arc.size(); ++i) {
    EXPECT_NEAR(x[i], arc[i], 1.5);
    EXPECT_NEAR(z[i], -40, 0.6);
    EXPECT_NEAR(laid[i], arc[i], 2.6);  // half an element
  }
}

}  // namespace
}  // namespace hawser::runs::statistics
