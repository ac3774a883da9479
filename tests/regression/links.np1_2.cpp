// Springs and dampers as elements in whole runs: results have their tensions, the energy balance closes, and
// a restart is exact, on one rank and on two.
#include "hawser/base/error.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::links {
namespace {

constexpr double kHalf = 6, kEnd = 12;  // s

// A load hangs under a moving crane tip on a compensator. A tugger line with a spring, which slackens, holds
// it. A second load hangs from the first on a damped link. A fender links the load to an arm on a column, and
// a brace links the column to a stay.
const char* const kCase = R"(
hawser: 1
line_types:
  wire: {bending: false, outer_diameter: 0.03, mass_per_length: 4, EA: 5e6}
  post: {outer_diameter: 0.3, mass_per_length: 100, EA: 5e8, EI: 2e7, GJ: 2e7}
bodies:
  crane: {position: [0, 0, 30], motion: {harmonic: {amplitude: [0.4, 0.3, 1], phase_deg: [0, 60, 30], period: 6}, ramp: 6}}
  load: {position: [0, 0, 10], floating: {mass: 5000, inertia: [4000, 5000, 3000], weight: true}}
  basket: {position: [0.5, 0, 4], floating: {mass: 800, inertia: [300, 300, 200], weight: true}}
  arm: {on: {line: column, at: end_b}, position: [0, 0, 0], rotation_deg: [0, 0, 0]}
lines:
  column: {sections: [{type: post, length: 12, elements: 6}], end_a: {anchor: [8, 0, 0], direction: [0, 0, 1], clamped: true}, end_b: free, start: {points: [[8, 0, 0], [8, 0, 12]]}}
  tugger: {sections: [{type: wire, length: 9, elements: 6}], end_a: {anchor: [-9, 2, 11]}, end_b: {body: load, at: [-1, 0, 0.5]}}
  stay: {sections: [{type: wire, length: 8.2, elements: 6}], end_a: {anchor: [8, -8, 8]}, end_b: {anchor: [4, -1, 8]}}
links:
  compensator: {end_a: {body: crane, at: [0, 0, 0]}, end_b: {body: load, at: [0.2, 0, 1]}, force_table: [[-3, 42e3], [0, 49e3], [3, 70e3]], damping_table: [[0.5, 2e3], [2, 12e3]]}
  sling: {end_a: {body: load, at: [0, 0, -1]}, end_b: {body: basket, at: [0, 0, 1]}, stiffness: 2e5, damping: 2e3, tension_only: true}
  fender: {end_a: {body: arm, at: [0, 0, 0.5]}, end_b: {body: load, at: [1, 0, 0]}, stiffness: 500, damping: 300, rest_length: 8}
  brace: {end_a: {line: stay, at: 4}, end_b: {line: column, at: 8}, stiffness: 3e3, damping: 100, rest_length: 4}
  sag: {end_a: {anchor: [-4, 0, 14]}, end_b: {line: tugger, at: 4.5}, stiffness: 2000, tension_only: true, rest_length: 3.7}
dynamics: {duration: 12, step: 0.01}
output: {every: 1, file: links.h5}
)";

const char* const kLinks[] = {"compensator_link", "sling_link", "fender_link", "brace_link", "sag_link"};

class Links : public ::testing::Test {
 protected:
  void SetUp() override {
    path = folder("links");
    write_case(path + "/links.yaml", kCase);
  }
  static bool first() { return rank_of(MPI_COMM_WORLD) == 0; }
  std::string path;
};

TEST_F(Links, HistoriesAndEnergy) {
  run_on_all({path + "/links.yaml", path + "/all.h5"});
  run_on_one({path + "/links.yaml", path + "/one.h5"});
  if (!first()) return;
  const Results all = read(path + "/all.h5");
  const Results one = read(path + "/one.h5");
  // At rest the compensator and the tugger carry both loads.
  const std::vector<double> tension = named(path + "/all.h5", all, kLinks[0], "tension");
  const std::vector<double> length = named(path + "/all.h5", all, kLinks[0], "length");
  const std::vector<double> speed = named(path + "/all.h5", all, kLinks[0], "speed");
  const std::vector<double> sling = named(path + "/all.h5", all, kLinks[1], "tension");
  const std::vector<double> sag = named(path + "/all.h5", all, kLinks[4], "tension");
  EXPECT_NEAR(sling.front(), 800 * 9.80665, 1e-5 * 800 * 9.80665);
  EXPECT_EQ(*std::min_element(sag.begin(), sag.end()), 0);
  EXPECT_GT(*std::max_element(sag.begin(), sag.end()), 100);
  for (size_t i = 2; i + 1 < length.size(); ++i) {
    const double by = (length[i + 1] - length[i - 1]) / (all.step_times[i + 1] - all.step_times[i - 1]);
    EXPECT_NEAR(speed[i], by, 5e-3) << all.step_times[i];  // jumps where the tugger's spring tightens
  }
  const double brought_in = largest(all.column("energy", 5));
  const double error = largest(all.column("energy", 6));
  const double damping = all.column("energy", 4).back();
  printf("  tension %.0f to %.0f N; damped %.0f J, brought in %.0f J, %.4f %% of it not accounted for\n",
         *std::min_element(tension.begin(), tension.end()), *std::max_element(tension.begin(), tension.end()),
         damping, brought_in, 100 * error / brought_in);
  EXPECT_GT(damping, 1000);
  EXPECT_LT(error, 2e-3 * brought_in);
  for (const char* link : kLinks)
    for (size_t c = 0; c < all.columns.at(link); ++c)
      EXPECT_LE(largest_difference(all.column(link, c), one.column(link, c)),
                1e-6 * (1 + largest(one.column(link, c))))
          << link << ' ' << c;
}

TEST_F(Links, GoOnAfterARestart) {
  run_on_all({path + "/links.yaml", path + "/whole.h5", "", kEnd});
  run_on_all({path + "/links.yaml", path + "/half.h5", "", kHalf});
  run_on_all({path + "/links.yaml", path + "/rest.h5", path + "/half.h5", kEnd});
  run_on_one({path + "/links.yaml", path + "/fewer.h5", path + "/half.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  const double same = size_of(MPI_COMM_WORLD) == 1 ? 0 : 1e-12;
  for (const auto& [file, tolerance] : {std::pair{"/rest.h5", same}, {"/fewer.h5", 1e-6}}) {
    const Results rest = read(path + file);
    EXPECT_EQ(rest.output_times.front(), kHalf);
    for (const char* series :
         {"energy", "compensator_link", "sling_link", "fender_link", "brace_link", "sag_link"})
      for (size_t c = 0; c < whole.columns.at(series); ++c) {
        const auto there = rest.column(series, c);
        const auto here = tail(whole.column(series, c), there);
        EXPECT_LE(largest_difference(here, there), tolerance * (1 + largest(whole.column(series, c))))
            << file << ' ' << series << ' ' << c;
      }
  }
}

// A restart rejects changed links.
TEST_F(Links, OtherLinksAreRefused) {
  run_on_all({path + "/links.yaml", path + "/half.h5", "", 0.1});
  const std::string other = path + "/other.yaml";
  for (const auto& [from, to, message] :
       {std::tuple("stiffness: 2e5", "stiffness: 3e5", "links.sling differs from the checkpoint"),
        {"[3, 70e3]", "[3, 71e3]", "links.compensator differs from the checkpoint"},
        {"end_a: {anchor: [-4, 0, 14]}", "end_a: {anchor: [-4, 0, 15]}",
         "links.sag differs from the checkpoint"},
        {"  sag: {", "  droop: {", "links.droop is not in it"}}) {
    write_case(other, kCase, {{from, to}});
    try {
      run::RunOptions o;
      o.case_path = other;
      o.output = path + "/rest.h5";
      o.restart = path + "/half.h5";
      o.quiet = true;
      run::run(MPI_COMM_WORLD, o);
      ADD_FAILURE() << message;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
    }
  }
}

}  // namespace
}  // namespace hawser::runs::links
