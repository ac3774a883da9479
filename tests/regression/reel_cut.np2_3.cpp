// The hose reel with so many elements that it is cut between ranks (every rank solves smaller models alone,
// docs/decisions/005): on one rank, on all, and restarted on another number of ranks. Tensions differ by at
// most 1e-6 with friction and 1e-9 without.
#include "regression/runs.hpp"

namespace hawser::runs::reel_cut {
namespace {

// The hose touches the drum with friction from 2 s on. Models of up to 1000 nodes are not cut.
constexpr double kHalf = 6, kEnd = 12;  // s
const Edits kFine = {{"length: 250, elements: 250", "length: 250, elements: 1200"}};

// Largest difference of the tensions in all rows of `b`, over the largest tension. The tension of the free
// end is nearly zero, so its error is that of the line.
double tension_apart(const Results& a, const Results& b) {
  const double most = largest(a.column("fairlead", kTension));
  double apart = 0;
  for (const char* point : {"fairlead", "lower_end"}) {
    const auto there = b.column(point, kTension);
    apart = std::max(apart, largest_difference(tail(a.column(point, kTension), there), there));
  }
  const auto& f = a.fields.at("effective_tension");
  const auto& g = b.fields.at("effective_tension");
  return std::max(apart, largest_difference(tail(f, g), g)) / most;
}

void expect_same_steps(const Results& a, const Results& b) {
  EXPECT_GT(b.step_times.size(), 10u);
  EXPECT_EQ(tail(a.step_times, b.step_times), b.step_times);
  EXPECT_EQ(tail(a.output_times, b.output_times), b.output_times);
  const auto iterations = b.column("solver", 1);
  EXPECT_EQ(tail(a.column("solver", 1), iterations), iterations) << "Newton iterations";
}

void compare(const std::string& name, Edits edits, double tolerance) {
  edits.insert(edits.begin(), kFine.begin(), kFine.end());
  const std::string path = folder(name);
  const std::string here = reel(path + "/reel.yaml", edits);
  run_on_one({here, path + "/one.h5", "", kEnd});
  run_on_all({here, path + "/all.h5", "", kEnd});
  run_on_all({here, path + "/half.h5", "", kHalf});
  run_on_one({here, path + "/fewer.h5", path + "/half.h5", kEnd});
  run_on_one({here, path + "/half_one.h5", "", kHalf});
  run_on_all({here, path + "/more.h5", path + "/half_one.h5", kEnd});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Results one = read(path + "/one.h5");
  const Results all = read(path + "/all.h5");
  const Results fewer = read(path + "/fewer.h5");
  const Results more = read(path + "/more.h5");
  ASSERT_GT(one.fields.at("effective_tension").size() / one.output_times.size(), 1000u);
  EXPECT_NEAR(largest(one.column("fairlead", kTension)), 670e3, 20e3);
  EXPECT_GT(largest(one.fields.at("contact_force")), 1e3);
  expect_same_steps(one, all);
  // Restarted runs have the same steps, because they stopped at an output time.
  expect_same_steps(one, fewer);
  expect_same_steps(one, more);
  const double ranks = tension_apart(one, all);
  const double down = tension_apart(all, fewer);
  const double up = tension_apart(one, more);
  std::printf(
      "%s, 1200 elements: tensions on 1 and %d ranks differ by %.1e of the largest; gone on with on fewer "
      "ranks %.1e, on more %.1e\n",
      name.c_str(), size_of(MPI_COMM_WORLD), ranks, down, up);
  EXPECT_LE(ranks, tolerance);
  EXPECT_LE(down, 1e-9);
  EXPECT_LE(up, 1e-9);
  EXPECT_EQ(ranks > 0, size_of(MPI_COMM_WORLD) > 1) << "to the last bit only if nothing was cut";
}

TEST(ReelCut, WithFriction) { compare("reel_cut", {}, 1e-6); }

TEST(ReelCut, WithoutFriction) {
  if (size_of(MPI_COMM_WORLD) > 2 && !std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  compare("reel_cut_frictionless", {{"friction: 0.3", "friction: 0"}}, 1e-9);
}

}  // namespace
}  // namespace hawser::runs::reel_cut
