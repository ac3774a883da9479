// A run restarted from its checkpoint continues as the uninterrupted run: bit for bit on the same number of
// ranks, within 1e-9 on another.
#include "hawser/run/restart.hpp"

#include <set>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::restart {
namespace {

constexpr double kHalf = 12, kEnd = 18;  // s; the hose touches the drum with friction from 2 s on

// Compares the second half of `whole` with `rest`, relative to the largest of each quantity; 0: bit for bit.
void expect_same(const Results& whole, const Results& rest, double tolerance) {
  ASSERT_GT(rest.output_times.size(), 5u);
  EXPECT_EQ(tail(whole.output_times, rest.output_times), rest.output_times);
  EXPECT_EQ(tail(whole.step_times, rest.step_times), rest.step_times);
  for (const auto& [name, values] : whole.fields) {
    const auto& there = rest.fields.at(name);
    const auto here = tail(values, there);
    EXPECT_LE(largest_difference(here, there), tolerance * largest(here)) << name;
  }
  for (const auto& [name, values] : whole.series) {
    if (name == "energy") continue;
    for (size_t c = 0; c < whole.columns.at(name); ++c) {
      const auto there = rest.column(name, c);
      const auto here = tail(whole.column(name, c), there);
      // The error of the nearly zero forces of the free end is that of the line.
      const double scale = largest(c < kTension || name == "solver" ? here : whole.column("fairlead", c));
      // Values that are zero by symmetry have the round-off of lengths of 250 m; accelerations have that of
      // gravity.
      EXPECT_LE(largest_difference(here, there), tolerance * std::max(scale, 1.0)) << name << ' ' << c;
    }
  }
  // The energy balance continues: friction, damping and work of the drum since the start of the run.
  const double brought_in = largest(whole.column("energy", 5));
  for (size_t c = 0; c < whole.columns.at("energy"); ++c) {
    const auto there = rest.column("energy", c);
    const auto here = tail(whole.column("energy", c), there);
    EXPECT_LE(largest_difference(here, there), tolerance * (c == 2 ? largest(here) : brought_in))
        << "energy " << c;
  }
  expect_same_clashes(whole, rest, tolerance);
  ASSERT_EQ(whole.summary.size(), rest.summary.size());
  // Place and time of extremes are compared bit for bit only: two places may have the same extreme within
  // round-off.
  for (size_t i = 0; i<whole.summary.size(); i += tolerance> 0 ? 3 : 1)
    EXPECT_LE(std::abs(whole.summary[i] - rest.summary[i]), tolerance * largest(whole.summary)) << i;
}

// For each method of contact: nodes, line.
class Restart : public ::testing::TestWithParam<const char*> {
 protected:
  // Made once per method: the whole run, and its first half on all ranks and on one.
  void SetUp() override {
    path = folder(std::string("restart_") + GetParam());
    input = path + "/reel.yaml";
    static std::set<std::string> made;
    if (!made.insert(path).second) return;
    reel(input, method());
    run_on_all({input, path + "/whole.h5", "", kEnd});
    run_on_all({input, path + "/half.h5", "", kHalf});
    run_on_one({input, path + "/half_one.h5", "", kHalf});
  }
  static Edits method() { return {{"method: line", std::string("method: ") + GetParam()}}; }
  static bool first() { return rank_of(MPI_COMM_WORLD) == 0; }
  std::string path, input;
};

TEST_P(Restart, SameRanksBitForBit) {
  run_on_all({input, path + "/rest.h5", path + "/half.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  const Results rest = read(path + "/rest.h5");
  EXPECT_EQ(rest.output_times.front(), kHalf);
  EXPECT_GT(largest(whole.fields.at("friction_force")), 0);
  expect_same(whole, rest, 0);
}

TEST_P(Restart, InTheSameFile) {
  if (first())
    std::filesystem::copy_file(path + "/half.h5", path + "/on.h5",
                               std::filesystem::copy_options::overwrite_existing);
  MPI_Barrier(MPI_COMM_WORLD);
  run_on_all({input, path + "/on.h5", path + "/on.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  const Results on = read(path + "/on.h5");
  EXPECT_EQ(on.output_times.front(), 0);
  EXPECT_EQ(on.output_times.size(), whole.output_times.size());
  EXPECT_GT(largest(on.clash_counts), 0);
  expect_same(whole, on, 0);
}

// A restart from the last output: of a killed run without a summary, it writes the summary; of an ended run
// it changes nothing.
TEST_P(Restart, FromTheEnd) {
  run_on_all({input, path + "/whole.h5", path + "/whole.h5", kEnd});
  run_on_all({input, path + "/again.h5", path + "/whole.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  const Results again = read(path + "/again.h5");
  EXPECT_EQ(whole.output_times.size(), 19u);
  EXPECT_EQ(again.output_times, std::vector<double>{kEnd});
  EXPECT_EQ(again.summary, whole.summary);
  const auto& there = again.fields.at("effective_tension");
  const auto here = tail(whole.fields.at("effective_tension"), there);
  EXPECT_EQ(here, there);
}

TEST_P(Restart, OtherRanks) {
  run_on_one({input, path + "/fewer.h5", path + "/half.h5", kEnd});
  run_on_all({input, path + "/more.h5", path + "/half_one.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  expect_same(whole, read(path + "/fewer.h5"), 1e-9);
  expect_same(whole, read(path + "/more.h5"), 1e-9);
}

// Without friction after the restart the run differs, so the friction history matters.
TEST_P(Restart, FrictionHistoryMatters) {
  const std::string smooth = path + "/smooth.yaml";
  Edits edits = method();
  edits.push_back({"friction: 0.3", "friction: 0"});
  reel(smooth, edits);
  run_on_all({smooth, path + "/other.h5", path + "/half.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  const Results other = read(path + "/other.h5");
  const auto& a = whole.fields.at("position");
  const auto& b = other.fields.at("position");
  EXPECT_GT(largest_difference(tail(a, b), b), 1e-6);
}

TEST_P(Restart, OtherQuantitiesAreRefused) {
  const model::Case c = io::read_case(input);
  const auto volumes = run::load_volumes(c, PETSC_COMM_WORLD);
  run::Simulation s(PETSC_COMM_WORLD, c, run::surfaces(volumes), run::skeletons(c, volumes));
  io::Checkpoint k = run::read_restart(path + "/half.h5", s);
  const std::string name = "line contact";
  run::check_records(k, s.system(), path + "/half.h5");
  k.records.at(name).kinds.at(0).quantities.at(0).unit = "mm";
  try {
    run::check_records(k, s.system(), path + "/half.h5");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("with other quantities of " + name + "; start from its last shape"),
              std::string::npos)
        << e.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Contact, Restart, ::testing::Values("nodes", "line"));

}  // namespace
}  // namespace hawser::runs::restart
