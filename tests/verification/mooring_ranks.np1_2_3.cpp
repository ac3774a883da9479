// A mooring line in a current and a sea of wind waves and swell, with friction on the bed, cut between ranks:
// statics and some seconds with a moving fairlead are the same as on one rank.
#include "hawser/terms/bed_contact.hpp"
#include "support/mooring.hpp"

namespace hawser::test::mooring_ranks {
namespace {

model::Case chain() {
  model::Case c = moored_chain({0, 0, -200}, 120, 1e5, {1, 0.5, 2});
  c.environment.water.current.profile = {{0, 1, 0.8}, {200, 0.2, 0.3}};
  model::Waves& waves = c.environment.water.waves;
  for (const double period : {9.0, 14.0}) {
    model::WaveSystem& w = waves.systems.emplace_back();
    w.kind = model::WaveSystem::Kind::spectrum;
    w.height = 36 / period;
    w.peak_period = period;
    w.gamma = 3.3;
    w.direction = 0.5 - 0.2 * (period - 9);
    w.spreading = 4;
    w.count = 100;
    w.seed = 7;
  }
  waves.ramp = 3;
  c.dynamics.duration = 6;
  return c;
}

TEST(MooringRanks, TheSameOnAnyNumber) {
  const model::Case c = chain();
  Simulation all(PETSC_COMM_WORLD, c);
  Simulation one(PETSC_COMM_SELF, c);
  all.solve_statics();
  one.solve_statics();
  expect_same_positions(all, all.state().at_rest(), one.state().at_rest(), 1e-7, "statics");
  int touching = all.system().find<BedContact>()->active_count();
  MPI_Allreduce(MPI_IN_PLACE, &touching, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  EXPECT_EQ(touching, one.system().find<BedContact>()->active_count());
  EXPECT_GT(touching, 20);
  run(all, 6);
  run(one, 6);
  expect_same_positions(all, all.dynamics().committed_kinematics(), one.dynamics().committed_kinematics(),
                        1e-6, "after 6 s");
}

}  // namespace
}  // namespace hawser::test::mooring_ranks
