// Two risers cross under a vessel and clash in waves and current: at the program's own steps the energy
// balance with contact and friction closes within 5e-4 of the work.
#include "regression/runs.hpp"

namespace hawser::runs::crossing_risers {
namespace {

const char* const kRisers = R"(
hawser: 1
environment:
  water: {density: 1025, depth: 100}
  current: {profile: [{depth: 0, speed: 0.8, direction_deg: 90}, {depth: 100, speed: 0.2, direction_deg: 90}]}
  waves: {regular: {height: 6, period: 10}}
line_types:
  riser: {outer_diameter: 0.25, mass_per_length: 120, EA: 5.0e8, EI: 2.0e6, GJ: 1.5e6, Cd_normal: 1.0}
  light: {outer_diameter: 0.3, mass_per_length: 95, EA: 3.0e8, EI: 1.5e6, GJ: 1.0e6, Cd_normal: 1.2}
bodies:
  vessel: {motion: {harmonic: {amplitude: [1.5, 1.0, 1.0], period: 10}, ramp: 10}}
lines:
  up:
    sections: [{type: riser, length: 112, elements: 56}]
    end_a: {anchor: [40, 0, -100]}
    end_b: {body: vessel, at: [0, 1.2, 0]}
  down:
    sections: [{type: light, length: 120, elements: 60}]
    end_a: {anchor: [46, 3, -100]}
    end_b: {body: vessel, at: [0, -1.2, 0]}
contact: {between_lines: {friction: 0.3}}
dynamics: {duration: 32}
output: {every: 0.5}
)";

TEST(CrossingRisers, ClashesAreAccountedFor) {
  const std::string name = folder("crossing_risers") + "/risers";
  write_case(name + ".yaml", kRisers, {});
  run_on_all({name + ".yaml", name + ".h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(name + ".h5");
  // Columns of the energy history: friction 3, brought in 5, error 6.
  const double friction = r.column("energy", 3).back();
  const auto brought = r.column("energy", 5);
  const auto error = r.column("energy", 6);
  double worked = 0, most = 0;
  for (size_t i = 1; i < brought.size(); ++i) worked += std::abs(brought[i] - brought[i - 1]);
  for (const double e : error) most = std::max(most, std::abs(e));
  printf("  friction took %.3g J, %.3g J of %.3g J not accounted for\n", friction, most, worked);
  EXPECT_LT(most, 5e-4 * worked);
  EXPECT_GT(friction, 1e-3 * worked);  // large enough for the balance to show missing friction
}

}  // namespace
}  // namespace hawser::runs::crossing_risers
