// First part of cases/reel-lay: a pipe is bent onto its reel beyond yield against the back tension of a
// winch. Tension by the winch's law, curvature of the drum, residual curvature.
#include <cmath>
#include <sstream>

#include "regression/runs.hpp"

namespace hawser::runs::reel_lay {
namespace {

constexpr double kRadius = 8 + 0.5 * 0.2191, kEnd = 22;  // m, s

TEST(ReelLay, ComesOntoTheReel) {
  const std::string path = folder("reel-lay");
  const std::string input = path + "/case.yaml";
  std::ostringstream text;
  text << std::ifstream(HAWSER_SOURCE_DIR "/cases/reel-lay/reel-lay.yaml").rdbuf();
  write_case(input, text.str());
  run_on_all({input, path + "/all.h5", "", kEnd});
  if (size_of(MPI_COMM_WORLD) > 1) run_on_one({input, path + "/one.h5", "", kEnd});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results all = read(path + "/all.h5");
  const auto T = named(path + "/all.h5", all, "wire_end_b_feed", "tension");
  const auto v = named(path + "/all.h5", all, "wire_end_b_feed", "feed_speed");
  // Law of the winch in the mean: damping and inertia of the wire add to it where pipe and wire vibrate.
  double law = 0;
  size_t steps = 0;
  for (size_t i = 0; i < T.size(); ++i)
    if (all.step_times[i] > 12) {
      law += std::abs(T[i] / (300e3 + v[i] / 8e-6) - 1);
      ++steps;
    }
  law /= static_cast<double>(steps);
  // Nodes on the drum away from the clamp, of the last output with 236 nodes of pipe and wire.
  const auto last = [&](const char* field, size_t node) {
    const auto& all_rows = all.fields.at(field);
    return all_rows[all_rows.size() - all_rows.size() / all.output_times.size() + node];
  };
  double off = 0, least = 1, most = 0;
  for (size_t node = 6; node < 16; ++node) {
    off = std::max(off, std::abs(last("curvature", node) * kRadius - 1));
    least = std::min(least, last("residual_curvature", node));
    most = std::max(most, last("residual_curvature", node));
  }
  printf("  law of the winch off by %.1e, curvature on the drum by %.1e, %.4f to %.4f 1/m stay\n", law, off,
         least, most);
  EXPECT_LT(law, 0.003);
  EXPECT_LT(off, 0.005);
  // Limits: residual curvature after the moment of the first bend, and after unloading by 2 % of the
  // curvature.
  EXPECT_GT(least, 1 / kRadius - 222.2e3 / 9.093e6);
  EXPECT_LT(most, 1.03 * (1 / kRadius - 199e3 / 9.093e6));
  if (size_of(MPI_COMM_WORLD) == 1) return;
  const Results one = read(path + "/one.h5");
  for (const char* field : {"position", "bending_moment", "residual_curvature"})
    EXPECT_LT(largest_difference(all.fields.at(field), one.fields.at(field)),
              1e-3 * largest(one.fields.at(field)))
        << field;
}

}  // namespace
}  // namespace hawser::runs::reel_lay
