// The spooled hose, which may touch itself and so is not cut, on one rank and on all: the same steps, fields
// within 1e-8 of their range; penetration and energy error are small.
#include "regression/same_fields.hpp"

namespace hawser::runs::spool_ranks {
namespace {

bool whole() { return std::getenv("HAWSER_FULL") != nullptr; }

TEST(SpoolRanks, TheSameAsOnOne) {
  const std::string path = folder(whole() ? "spool_whole" : "spool");
  const std::string input = path + "/spool.yaml";
  const std::string source = HAWSER_SOURCE_DIR "/cases/spool/";
  std::ostringstream text;
  text << std::ifstream(source + "spool.yaml").rdbuf();
  write_case(input, text.str(), {{"guide.txt", source + "guide.txt"}});
  const double until = whole() ? 0 : 70;  // the whole run; one and a half turns
  run_on_one({input, path + "/one.h5", "", until});
  if (size_of(MPI_COMM_WORLD) > 1) run_on_all({input, path + "/all.h5", "", until});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Results one = read(path + "/one.h5");
  const double most = largest(one.column("fairlead", kTension));
  EXPECT_NEAR(most, 675e3, 20e3);  // weight of the hanging hose, 273.4 kg/m of 250 m
  EXPECT_LT(largest(one.fields.at("penetration")), 0.02 * 0.425);
  EXPECT_LT(largest(one.fields.at("line_penetration")), 0.02 * 0.425);
  EXPECT_GT(largest(one.fields.at("line_penetration")), 1e-5);  // the hose lies on itself
  // Energy error at every step over the work brought in.
  const double brought = largest(one.column("energy", 5));
  const double error = largest(one.column("energy", 6));
  EXPECT_GT(brought, 1e4);
  EXPECT_LT(error, 0.01 * brought);
  std::printf(
      "spool: %zu steps, %.2f mm into the reel, %.2f mm into itself; of %.3g J not accounted for %.1e\n",
      one.step_times.size(), 1e3 * largest(one.fields.at("penetration")),
      1e3 * largest(one.fields.at("line_penetration")), brought, error / brought);
  if (whole()) {
    EXPECT_GT(largest(one.fields.at("line_contact_normal_force")), 1e3);  // N: hose on hose
  }
  if (size_of(MPI_COMM_WORLD) == 1) return;
  const Results all = read(path + "/all.h5");
  EXPECT_EQ(one.step_times, all.step_times);
  EXPECT_LE(largest_difference(one.column("fairlead", kTension), all.column("fairlead", kTension)),
            1e-8 * most);
  expect_same_fields(one, all, 1e-8);
}

}  // namespace
}  // namespace hawser::runs::spool_ranks
