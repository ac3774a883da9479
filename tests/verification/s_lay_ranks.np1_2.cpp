// Roller boxes in whole runs on 1 and 2 ranks: reactions of V rollers by closed form, also on a moving body,
// equal on all ranks; errors and notes for lines off the end of a roller and below one.
#include "../regression/runs.hpp"
#include "hawser/base/error.hpp"

namespace hawser::s_lay_ranks_test {
namespace {

constexpr double kWeight = 1000, kAngle = 25 * M_PI / 180;  // N/m

// 40 m of pipe from (-20, 0, 0.325 / cos 25 deg) to (20, 0, ...) over boxes about the origin, on a barge
// rotated by 180 degrees.
std::string beam(const std::string& boxes, const std::string& more, double z = 0.325 / std::cos(kAngle)) {
  const std::string height = std::to_string(z);
  return "hawser: 1\nenvironment: {gravity: 10}\n"
         "line_types: {pipe: {outer_diameter: 0.25, mass_per_length: 100, EA: 2e9, EI: 1.6e7, GJ: 1e7}}\n"
         "bodies: {barge: {position: [5, 0, 0], rotation_deg: [0, 0, 180],\n"
         "  motion: {harmonic: {amplitude: [0, 0, 0.02], period: 20}, ramp: 20}}}\n"
         "supports: {ramp: {body: barge, path: {from: [22, 0, 0], direction: [-1, 0, 0],\n"
         "  segments: [{length: 24}]}, boxes: [" +
         boxes +
         "]}}\nlines: {pipe: {sections: [{type: pipe, length: 40, elements: 80}], end_a: {anchor: [-20, 0, " +
         height + "]}, end_b: {anchor: [20, 0, " + height + "]}" + more +
         "}}\ncontact: {between_lines: false}\n";
}

const std::string kV = "{at: [4, 12, 20], type: V, angle_deg: 25, roller_diameter: 0.4, roller_length: 1}";

std::string messages(const std::string& path) {
  const io::h5::Id file = io::h5::open_read(path);
  std::string all;
  if (io::h5::exists(file, "messages"))
    for (const std::string& m : io::h5::read_texts(file, "messages")) all += m + "\n";
  return all;
}

TEST(SLayRanks, ReactionsOfAV) {
  const std::string folder = runs::folder("s_lay_v");
  const std::string path = folder + "/v.yaml";
  runs::write_case(path, beam(kV, "") + "dynamics: {duration: 5, step: 0.25}\n");
  runs::run_on_all({path, folder + "/all.h5"});
  runs::run_on_one({path, folder + "/one.h5"});
  if (runs::rank_of(MPI_COMM_WORLD) != 0) return;
  const runs::Results all = runs::read(folder + "/all.h5");
  const runs::Results one = runs::read(folder + "/one.h5");
  double carried = 0;
  for (const char* box : {"ramp_1", "ramp_2", "ramp_3"}) {
    const auto of = [&](const char* column) { return runs::named(folder + "/all.h5", all, box, column); };
    const std::vector<double> up = of("force_z");
    const std::vector<double> left = of("left_force_z");
    const std::vector<double> right = of("right_force_y");
    const std::vector<double> side = of("left_force_y");
    const std::vector<double> height = of("height");
    const std::vector<double> offset = of("offset");
    ASSERT_GT(up.size(), 20u);
    carried += up.front();
    for (size_t i = 0; i < up.size(); ++i) {
      EXPECT_GT(up[i], 1000);
      EXPECT_NEAR(left[i], 0.5 * up[i], 1e-6 * up[i]);
      // Each roller exerts W / (2 cos 25 deg) towards the middle.
      EXPECT_NEAR(side[i], -0.5 * up[i] * std::tan(kAngle), 1e-4 * up[i]);
      EXPECT_NEAR(right[i], -side[i], 1e-6 * up[i]);
      EXPECT_NEAR(offset[i], 0, 1e-9);
      EXPECT_LT(height[i], 0);
      EXPECT_GT(height[i], -1e-3);
    }
    const std::vector<double>& a = all.series.at(box);
    const std::vector<double>& b = one.series.at(box);
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-6 * (1 + std::abs(up.front()))) << i;
  }
  const auto end = [&](const char* which) {
    const io::h5::Id file = io::h5::open_read(folder + "/all.h5");
    const auto forces = io::h5::read_row(file, "ends/force", 0).values;
    return forces[which[0] == 'a' ? 2 : 5];
  };
  // Balance of the rollers' and the ends' forces; the ends include their share of weight.
  EXPECT_NEAR(carried - end("a") - end("b"), 40 * kWeight, 1e-5 * 40 * kWeight);
}

TEST(SLayRanks, OffTheEndOfARoller) {
  const std::string folder = runs::folder("s_lay_off");
  const std::string path = folder + "/off.yaml";
  const std::string flat = "{at: [12], type: flat, roller_diameter: 0.4, roller_length: 2}";
  // The ends of the line are 1.5 m beside the roller, or 0.5 m within it.
  for (const bool off : {true, false}) {
    const std::string y = off ? "1.5" : "0.5";
    std::string text = beam(flat, ", start: straight", 0.325);
    for (const char* x : {"[-20, 0,", "[20, 0,"})
      text.replace(text.find(x), std::string(x).size(),
                   std::string(x).substr(0, std::string(x).size() - 2) + y + ",");
    runs::write_case(path, text);
    runs::run_on_all({path, folder + "/off.h5"});
    if (runs::rank_of(MPI_COMM_WORLD) != 0) continue;
    const bool message =
        messages(folder + "/off.h5").find("line pipe is beyond the end of the rollers of support ramp 1") !=
        std::string::npos;
    EXPECT_EQ(message, off) << messages(folder + "/off.h5");
    const runs::Results r = runs::read(folder + "/off.h5");
    EXPECT_NEAR(runs::named(folder + "/off.h5", r, "ramp_1", "offset").front(), off ? 1.5 : 0.5, 1e-6);
  }
}

TEST(SLayRanks, BelowARoller) {
  const std::string folder = runs::folder("s_lay_below");
  const std::string path = folder + "/below.yaml";
  runs::write_case(
      path, beam(kV, ", start: {points: [[-20, 0, 0.3586], [-10, 0, -1.2], [10, 0, -1.2], [20, 0, 0.3586]]}",
                 0.3586));
  run::RunOptions o;
  o.case_path = path;
  o.output = folder + "/below.h5";
  o.quiet = true;
  std::string why;
  try {
    run::run(MPI_COMM_WORLD, o);
  } catch (const InputError& e) {
    why = e.what();
  }
  EXPECT_NE(why.find("lines.pipe: starts on the wrong side of support 'ramp 1'"), std::string::npos) << why;
}

}  // namespace
}  // namespace hawser::s_lay_ranks_test
