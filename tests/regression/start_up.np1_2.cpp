// First seconds of cases/s-lay/startup.yaml on longer elements, with an earlier start of the barge: a tug in
// waves holds the head of a pipe, which the tensioner of the barge pays out over its rollers.
#include <cmath>
#include <sstream>

#include "regression/runs.hpp"

namespace hawser::runs::start_up {
namespace {

constexpr double kWet = 359.09, kDry = 852.5;  // N/m, of the pipe
constexpr double kTop = 10.325, kEnd = 12.5;   // m, height of the tensioner; s
constexpr double kCompared = 4;                // s, compared between one rank and several

TEST(StartUp, ATugHoldsTheHead) {
  const std::string folder = HAWSER_SOURCE_DIR "/cases/s-lay/";
  const std::string path = runs::folder("start-up");
  const std::string input = path + "/case.yaml";
  const std::string all_h5 = path + "/all.h5";
  std::ostringstream text;
  text << std::ifstream(folder + "startup.yaml").rdbuf();
  write_case(input, text.str(),
             {{"file: barge.rao", "file: " + folder + "barge.rao"},
              {"file: tug.rao", "file: " + folder + "tug.rao"},
              {"seed: 1", "seed: 1, components: 20"},
              {"duration: 580", "duration: 20"},
              {"rows: [[0, 0, 0, 0], [10, 0, 0, 0], [20, 2.5, 0, 0], [30, 7.5, 0, 0]",
               "rows: [[0, 0, 0, 0], [2, 0, 0, 0], [6, 1, 0, 0], [8, 2, 0, 0]"},
              {"element_length: 1}", "element_length: 2}"},
              {"length: 430, elements: 86", "length: 430, elements: 43"}});
  // Several ranks are compared with one while the pipe is paid out; other checks run on one rank.
  const bool several = size_of(MPI_COMM_WORLD) > 1;
  run_on_all({input, all_h5, "", several ? kCompared : kEnd});
  if (several) run_on_one({input, path + "/one.h5", "", kCompared});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results all = read(all_h5);
  if (several) {
    const Results one = read(path + "/one.h5");
    for (const char* field : {"position", "bending_moment", "effective_tension"})
      EXPECT_LT(largest_difference(all.fields.at(field), one.fields.at(field)),
                1e-3 * largest(one.fields.at(field)))
          << field;
    return;
  }
  const auto of = [&](const char* series, const char* column) { return named(all_h5, all, series, column); };

  // At rest the tension is the target; at the head it is smaller by the weight over the height difference,
  // because there is no friction. The feeder's tension includes M²/2EI of its clamp.
  const auto T = of("pipe_end_a_feed", "tension");
  const auto v = of("pipe_end_a_feed", "feed_speed");
  const auto head = of("head", "effective_tension_before");
  const auto z = of("head", "position_z");
  EXPECT_NEAR(T.front(), 150e3, 15);
  EXPECT_NEAR(head.front(), T.front() - kDry * kTop + kWet * z.front(), 150);

  // In motion: the law of the tensioner, from its start on.
  size_t working = 0;
  for (size_t i = 0; i < T.size(); ++i) {
    if (all.step_times[i] < 10) continue;
    ++working;
    EXPECT_NEAR(T[i], 150e3 + v[i] / 5e-5, 100) << all.step_times[i];
  }
  EXPECT_GT(working, 50u);
  EXPECT_GT(of("pipe_end_a_feed", "paid_out").back(), 1.5);

  // The stern of the tug moves with the waves and keeps its mean position.
  const auto x = of("tug", "position_x");
  const auto up = of("tug", "position_z");
  double moves = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(x[i], -546, 0.5);
    moves = std::max(moves, std::abs(up[i] - 3));
  }
  EXPECT_GT(moves, 0.02);
  EXPECT_LT(moves, 0.6);

  // The pipe stays between the rollers at the sides, 2 m apart and 1 m high.
  double carried = 0;
  for (int box = 1; box <= 11; ++box) {
    const std::string name = "stinger_" + std::to_string(box);
    const auto offset = of(name.c_str(), "offset");
    const auto height = of(name.c_str(), "height");
    for (size_t i = 0; i < offset.size(); ++i) {
      EXPECT_LT(std::abs(offset[i]), 1 - 0.125 + 0.003) << name;
      EXPECT_LT(height[i], 1 - 0.125) << name;
    }
    carried += of(name.c_str(), "force_z").front();
  }
  // At rest rollers and tension carry about the weight of the pipe between tensioner and head.
  EXPECT_GT(carried, 100e3);

  const auto error = of("energy", "error");
  const auto in = of("energy", "brought_in");
  double work = 0;
  for (size_t i = 1; i < in.size(); ++i) work += std::abs(in[i] - in[i - 1]);
  EXPECT_LT(std::abs(error.back()), 0.002 * work);
  printf("  head %.0f N, tug moves %.3f m, energy off by %.1e of the work\n", head.front(), moves,
         error.back() / work);
}

}  // namespace
}  // namespace hawser::runs::start_up
