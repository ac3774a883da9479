// A seed gives the same sea on every rank, to the last bit.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstring>

#include "hawser/model/wave_components.hpp"

namespace hawser::test::waves_ranks {
namespace {

TEST(WavesRanks, SeedsAreTheSameSea) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (const auto kind : {model::WaveSystem::Kind::spectrum, model::WaveSystem::Kind::table}) {
    model::Environment e;
    e.water.present = true;
    e.water.depth = 80;
    model::WaveSystem& w = e.water.waves.systems.emplace_back();
    w.kind = kind;
    w.height = 5;
    w.peak_period = 11;
    w.gamma = 2.7;
    w.direction = 0.4;
    w.spreading = 6;
    w.count = 300;
    w.seed = 41;
    w.spectrum = {{0.2, 0}, {0.5, 9}, {0.7, 4}, {2, 0}};
    const WaveField field = model::wave_field(e);
    std::vector<double> mine;
    for (const WaveComponent& c : field.components())
      mine.insert(mine.end(), {c.amplitude, c.omega, c.number, c.x, c.y, c.phase});
    for (int i = 0; i < 20; ++i) {
      const WaveMotion m = field.at({7.0 * i, -3.0 * i, -0.5 * i}, 13.7 * i);
      mine.insert(mine.end(), {m.surface, m.velocity.x(), m.velocity.z(), m.acceleration.y()});
    }
    std::vector<double> first = mine;
    MPI_Bcast(first.data(), static_cast<int>(first.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
    EXPECT_EQ(std::memcmp(first.data(), mine.data(), mine.size() * sizeof(double)), 0) << "rank " << rank;
    w.seed = 42;
    EXPECT_NE(model::wave_field(e).components()[0].phase, field.components()[0].phase);
  }
}

}  // namespace
}  // namespace hawser::test::waves_ranks
