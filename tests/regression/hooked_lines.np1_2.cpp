// Two ropes that are held at all ends and hang in each other, by warnings and by hand.
#include <fmt/format.h>

#include <cmath>

#include "hawser/io/hdf5.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::hooked_lines {
namespace {

// Legs of 2.5 m at 30 degrees to the vertical, in planes at right angles. Each axis bends at the distance 0.2
// m, the sum of the radii, round the middle of the other one. The length of its tangents and arc is 5.25500
// m, and the ropes are shorter by a strain of 1 %: 100 kN without weight, by hand.
const char* const kHooked = R"(hawser: 1
environment: {gravity: 0}
line_types: {rope: {outer_diameter: 0.2, mass_per_length: 0.01, EA: 10 MN, bending: false}}
contact: {between_lines: {normal_stiffness: {per_length: 1.0e9}}}
lines:
  upper:
    sections: [{type: rope, length: 5.20297417, elements: ELEMENTS}]
    end_a: {anchor: [-1.25, 0, 2.16506351]}
    end_b: {anchor: [1.25, 0, 2.16506351]}
    start: {points: [[-1.25, 0, 2.16506351], [0, 0, -DEPTH], [1.25, 0, 2.16506351]]}
  lower:
    sections: [{type: rope, length: 5.20297417, elements: ELEMENTS}]
    end_a: {anchor: [0, -1.25, -2.16506351]}
    end_b: {anchor: [0, 1.25, -2.16506351]}
    start: {points: [[0, -1.25, -2.16506351], [0, 0, DEPTH], [0, 1.25, -2.16506351]]}
)";
const double kByHand = 100e3;  // N

struct Ropes {
  double end_a = 0, end_b = 0;  // N, tensions of the upper rope, on rank 0
  std::vector<std::string> warnings{};

  double largest() const { return std::max(end_a, end_b); }
  double least() const { return std::min(end_a, end_b); }
  // Percentage in the warning about the upper rope with this text; 0: none.
  double percent(const std::string& text, const std::string& before) const {
    for (const std::string& w : warnings)
      if (w.find(text) != std::string::npos) {
        const size_t at = w.find(before);
        return at == std::string::npos ? 100 : std::stod(w.substr(at + before.size()));
      }
    return 0;
  }
  double turn() const { return percent("line upper turns by", " N, "); }
  double length() const { return percent("the straight elements of line upper over a line", "by about "); }
};

Ropes run(int elements, const std::string& depth) {
  const std::string path = folder("hooked-lines");
  const std::string n = std::to_string(elements);
  write_case(path + "/case.yaml", kHooked,
             {{"ELEMENTS", n}, {"DEPTH", depth}, {"ELEMENTS", n}, {"DEPTH", depth}});
  run_on_all({path + "/case.yaml", path + "/all.h5"});
  run_on_one({path + "/case.yaml", path + "/one.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return {};
  const auto read = [&](const std::string& name) {
    const io::h5::Id file = io::h5::open_read(path + name);
    const std::vector<double> tension = io::h5::read_array(file, "fields/effective_tension").values;
    Ropes out{.end_a = tension.front(), .end_b = tension[static_cast<size_t>(elements)]};
    if (!io::h5::exists(file, "messages")) return out;
    for (const std::string& m : io::h5::read_texts(file, "messages"))
      if (m.starts_with("warning")) out.warnings.push_back(m);
    return out;
  };
  const Ropes all = read("/all.h5");
  const Ropes one = read("/one.h5");
  // Rounding decides which of two equal elements a warning names.
  EXPECT_EQ(all.warnings.size(), one.warnings.size());
  EXPECT_EQ(all.turn(), one.turn());
  EXPECT_EQ(all.length(), one.length());
  EXPECT_NEAR(all.end_a, one.end_a, 1e-6 * kByHand);
  EXPECT_NEAR(all.end_b, one.end_b, 1e-6 * kByHand);
  return all;
}

// A rope has the same tension in both legs. By elements of twice the radius of the bend it has not, and by
// those of 1.3 times the radius twice that by hand.
TEST(HookedLines, ElementsThatAreTooLongAreReported) {
  const Ropes uneven = run(13, "0.296");
  const Ropes longer = run(20, "0.102");
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_GT(uneven.largest(), 1.3 * uneven.least());
  EXPECT_NEAR(uneven.turn(), 100 * (1 - uneven.least() / uneven.largest()), 4);
  EXPECT_GT(longer.largest(), 1.5 * kByHand);
  EXPECT_NEAR(longer.least(), longer.largest(), 0.001 * kByHand);
  EXPECT_GT(longer.length(), 40);
}

// With elements of 0.65 radii of the bend the tension is 21 % too high.
TEST(HookedLines, TheReportedErrorIsThatOfTheTension) {
  const Ropes coarse = run(40, "0.102");
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const double error = 100 * (1 - kByHand / coarse.largest());
  EXPECT_GT(error, 10);
  EXPECT_NEAR(coarse.length(), error, 0.4 * error);
}

// Elements of 0.16 radii, with 1.2 kN less by the penetration of 0.5 mm.
TEST(HookedLines, ShortElementsHaveTheTensionByHand) {
  const Ropes fine = run(160, "0.102");
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_NEAR(fine.largest(), kByHand, 0.02 * kByHand);
  EXPECT_NEAR(fine.least(), fine.largest(), 0.001 * kByHand);
  EXPECT_EQ(fine.warnings, std::vector<std::string>());
}

}  // namespace
}  // namespace hawser::runs::hooked_lines
