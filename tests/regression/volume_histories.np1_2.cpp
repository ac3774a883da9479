// History of the force and moment of a volume on lines: the weight on it, with its moment about the origin of
// the body that carries it, on one rank and on two.
#include "regression/runs.hpp"

namespace hawser::runs::volume_histories {
namespace {

// A bar of 10 m and 500 kg is held at one end and lies, except for its first metre, on a deck, and on a drum
// that rises above the deck, on a heaving barge; it lies on the nodes of every rank.
const char* const kCase = R"(hawser: 1
environment: {gravity: 10}
line_types:
  bar: {outer_diameter: 0.2, mass_per_length: 50, EA: 1.0e7, EI: 1.0e6, GJ: 1.0e6, stiffness_damping: 0.01}
bodies:
  barge: {position: [-1, 0, 0], motion: {harmonic: {amplitude: [0, 0, 0.05], period: 2}, ramp: 1}}
volumes:
  deck: {body: barge, shape: {box: {centre: [3.5, 0, -0.6], size: [9, 1, 1]}}, normal_stiffness: {per_length: 1.0e6}, friction: 0.2}
  drum: {body: barge, shape: {cylinder: {from: [3, -1, -0.58], to: [3, 1, -0.58], radius: 0.5}}, normal_stiffness: {per_length: 1.0e6}, friction: 0.2}
lines:
  bar:
    sections: [{type: bar, length: 10, elements: 20}]
    end_a: {anchor: [-3, 0, 0], direction: [1, 0, 0], clamped: true}
    end_b: free
    start: straight
contact: {between_lines: false}
dynamics: {duration: 3, step: 0.02}
output: {every: 1, histories: [{volume: deck}, {volume: drum, name: second}, {line: bar, at: end_a, name: root}]}
)";

TEST(VolumeHistories, ForceAndMoment) {
  const std::string path = folder("volume_histories");
  write_case(path + "/case.yaml", kCase);
  run_on_all({path + "/case.yaml", path + "/all.h5"});
  run_on_one({path + "/case.yaml", path + "/one.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results all = read(path + "/all.h5");
  const Results one = read(path + "/one.h5");
  const auto of = [&](const char* series, const char* column) {
    return named(path + "/all.h5", all, series, column);
  };
  const std::vector<double> deck = of("deck", "force_z");
  const std::vector<double> drum = of("second", "force_z");
  const std::vector<double> root = of("root", "end_force_z");
  const std::vector<double> moment = of("second", "moment_y");
  const std::vector<double> along = of("second", "force_x");
  // At rest volumes and support carry the whole weight.
  EXPECT_NEAR(deck.front() + drum.front() - root.front(), 5000, 5);
  EXPECT_GT(drum.front(), 1000);
  // The drum is 3 m from the body's origin; the axis of the bar is near the origin's height.
  for (size_t i = 0; i < drum.size(); ++i)
    EXPECT_NEAR(moment[i], -3 * drum[i], 0.05 * std::abs(drum[i]) + 0.2 * std::abs(along[i]) + 1) << i;
  EXPECT_GT(*std::max_element(drum.begin(), drum.end()), 1.01 * drum.front());
  for (const char* series : {"deck", "second"})
    for (size_t c = 0; c < 6; ++c)
      EXPECT_LE(largest_difference(all.column(series, c), one.column(series, c)),
                1e-6 * (1 + largest(one.column(series, c))))
          << series << ' ' << c;
}

}  // namespace
}  // namespace hawser::runs::volume_histories
