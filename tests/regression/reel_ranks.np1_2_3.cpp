// The hose reel on one rank and on all: the same steps and histories, to the last bit (docs/user-guide/
// running.md, "Several processes").
#include "regression/runs.hpp"

namespace hawser::runs {
namespace {

// The first half turn, or all five.
double stop_at() { return std::getenv("HAWSER_FULL") ? 0 : 35; }

void compare(const std::string& name, const Edits& edits) {
  const std::string path = folder(name), here = reel(path + "/reel.yaml", edits);
  run_on_one({here, path + "/one.h5", "", stop_at()});
  run_on_all({here, path + "/all.h5", "", stop_at()});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Results one = read(path + "/one.h5"), all = read(path + "/all.h5");

  EXPECT_GT(one.step_times.size(), 60u);
  EXPECT_EQ(one.output_times, all.output_times);
  EXPECT_EQ(one.step_times, all.step_times);
  EXPECT_EQ(one.column("solver", 1), all.column("solver", 1)) << "Newton iterations";
  const double most = largest(one.column("fairlead", kTension));
  EXPECT_NEAR(most, 670e3, 20e3);  // the hanging hose's weight, 273.4 kg/m of 250 m
  for (const char* point : {"fairlead", "lower_end"}) {
    const auto a = one.column(point, kTension), b = all.column(point, kTension);
    EXPECT_EQ(largest_difference(a, b), 0) << point;
  }
  const auto &x = one.fields.at("position"), &y = all.fields.at("position");
  EXPECT_EQ(largest_difference(x, y), 0);
  const auto &te = one.fields.at("effective_tension"), &tf = all.fields.at("effective_tension");
  EXPECT_EQ(largest_difference(te, tf), 0);
  std::printf("%s on %d ranks: %zu steps, tensions differ by %.1e of the largest, positions by %.1e m\n",
              name.c_str(), size_of(MPI_COMM_WORLD), one.step_times.size(), largest_difference(te, tf) / most,
              largest_difference(x, y));
}

TEST(ReelRanks, WithFriction) { compare("reel_friction", {}); }

TEST(ReelRanks, ContactAtTheNodes) { compare("reel_nodes", {{"method: line", "method: nodes"}}); }

TEST(ReelRanks, WithoutFriction) { compare("reel_frictionless", {{"friction: 0.3", "friction: 0"}}); }

}  // namespace
}  // namespace hawser::runs
