// The history of what a volume exerts on lines: the weight of what lies on it, with its moment about the
// origin of the body that carries it; a mesh of rollers like the boxes of `supports`, on one rank and on two.
#include "regression/runs.hpp"

namespace hawser::runs::volume_histories {
namespace {

// A bar of 10 m and 500 kg lies across a cradle on a barge that heaves: two drums, 3 m before and after its
// middle.
const char* const kCase = R"(hawser: 1
environment: {gravity: 10}
line_types:
  bar: {outer_diameter: 0.2, mass_per_length: 50, EA: 1.0e7, EI: 1.0e6, GJ: 1.0e6, stiffness_damping: 0.01}
bodies:
  barge: {position: [2, 0, 0], motion: {harmonic: {amplitude: [0, 0, 0.05], period: 4}, ramp: 4}}
volumes:
  aft: {body: barge, shape: {cylinder: {from: [-3, -1, -0.6], to: [-3, 1, -0.6], radius: 0.5}}, normal_stiffness: {per_length: 1.0e6}, friction: 0.2}
  fore: {body: barge, shape: {cylinder: {from: [3, -1, -0.6], to: [3, 1, -0.6], radius: 0.5}}, normal_stiffness: {per_length: 1.0e6}, friction: 0.2}
lines:
  bar:
    sections: [{type: bar, length: 10, elements: 20}]
    end_a: {anchor: [-3, 0, 0], direction: [1, 0, 0], clamped: true}
    end_b: free
    start: straight
dynamics: {duration: 2, step: 0.02}
output: {every: 1, histories: [{volume: aft}, {volume: fore, name: second}, {line: bar, at: end_a, name: root}]}
)";

TEST(VolumeHistories, ForceAndMoment) {
  const std::string path = folder("volume_histories");
  write_case(path + "/case.yaml", kCase);
  run_on_all({path + "/case.yaml", path + "/all.h5"});
  run_on_one({path + "/case.yaml", path + "/one.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results all = read(path + "/all.h5"), one = read(path + "/one.h5");
  const auto of = [&](const char* series, const char* column) {
    return named(path + "/all.h5", all, series, column);
  };
  const std::vector<double> aft = of("aft", "force_z"), fore = of("second", "force_z"),
                            root = of("root", "end_force_z"), moment = of("second", "moment_y"),
                            along = of("second", "force_x");
  // At rest all of it is carried.
  EXPECT_NEAR(aft.front() + fore.front() - root.front(), 5000, 5);
  EXPECT_GT(fore.front(), 1000);
  // The drum's place is 3 m before the body's origin, the axis of the bar near its height.
  for (size_t i = 0; i < fore.size(); ++i)
    EXPECT_NEAR(moment[i], -3 * fore[i], 0.05 * std::abs(fore[i]) + 0.2 * std::abs(along[i]) + 1) << i;
  EXPECT_GT(*std::max_element(fore.begin(), fore.end()), 1.01 * fore.front());
  for (const char* series : {"aft", "second"})
    for (size_t c = 0; c < 6; ++c)
      EXPECT_LE(largest_difference(all.column(series, c), one.column(series, c)),
                1e-6 * (1 + largest(one.column(series, c))))
          << series << ' ' << c;
}

}  // namespace
}  // namespace hawser::runs::volume_histories
