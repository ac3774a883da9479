// The hose reel on one rank and on all: the same steps, and fields and tensions within 1e-8 of their range
// (docs/user-guide/running.md, "Several processes").
#include "regression/same_fields.hpp"

namespace hawser::runs::reel_ranks {
namespace {

// End of the run [s]: the first half turn, or all five turns with HAWSER_FULL.
double stop_at() { return std::getenv("HAWSER_FULL") ? 0 : 35; }

void compare(const std::string& name, const Edits& edits) {
  const std::string path = folder(name);
  const std::string here = reel(path + "/reel.yaml", edits);
  run_on_one({here, path + "/one.h5", "", stop_at()});
  run_on_all({here, path + "/all.h5", "", stop_at()});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Results one = read(path + "/one.h5");
  const Results all = read(path + "/all.h5");

  EXPECT_GT(one.step_times.size(), 60u);
  EXPECT_EQ(one.output_times, all.output_times);
  EXPECT_EQ(one.step_times, all.step_times);
  EXPECT_EQ(one.column("solver", 1), all.column("solver", 1)) << "Newton iterations";
  const double most = largest(one.column("fairlead", kTension));
  EXPECT_NEAR(most, 670e3, 20e3);  // weight of the hanging hose, 273.4 kg/m of 250 m
  for (const char* point : {"fairlead", "lower_end"}) {
    const auto a = one.column(point, kTension);
    const auto b = all.column(point, kTension);
    EXPECT_LE(largest_difference(a, b), 1e-8 * most) << point;
  }
  const double apart = expect_same_fields(one, all, 1e-8);
  std::printf("%s on %d ranks: %zu steps, fields differ by at most %.1e of their range\n", name.c_str(),
              size_of(MPI_COMM_WORLD), one.step_times.size(), apart);
}

TEST(ReelRanks, WithFriction) { compare("reel_friction", {}); }

TEST(ReelRanks, ContactAtTheNodes) { compare("reel_nodes", {{"method: line", "method: nodes"}}); }

TEST(ReelRanks, WithoutFriction) { compare("reel_frictionless", {{"friction: 0.3", "friction: 0"}}); }

}  // namespace
}  // namespace hawser::runs::reel_ranks
