// Floating bodies in contact move as on one rank.
#include <gtest/gtest.h>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::body_contact_ranks {
namespace {

std::vector<double> poses(MPI_Comm comm, const model::Case& c, const std::vector<run::LoadedVolume>& v) {
  run::Simulation s(comm, c, run::surfaces(v), run::skeletons(c, v));
  Dynamics& d = s.dynamics();
  d.start(s.state());
  std::vector<double> out;
  integrate(d, 10, 2, [&](const StepInfo& i) {
    if (!at_mark(i.time, 2)) return;
    for (int b = 0; b < 2; ++b) {
      const auto p = s.body_pose(b, d.committed_kinematics());
      for (int k = 0; k < 7; ++k)
        out.push_back(!p ? 0 : k < 3 ? p->position[k] : p->rotation.coeffs()[k - 3]);
    }
    out.push_back(0);
  });
  MPI_Allreduce(MPI_IN_PLACE, out.data(), static_cast<int>(out.size()), MPI_DOUBLE, MPI_SUM, comm);
  return out;
}

TEST(BodyContact, RanksAgree) {
  const model::Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/fenders/fenders.yaml");
  const auto volumes = run::load_volumes(c);
  const auto one = poses(PETSC_COMM_SELF, c, volumes);
  const auto all = poses(PETSC_COMM_WORLD, c, volumes);
  ASSERT_EQ(one.size(), 75U);
  ASSERT_EQ(one.size(), all.size());
  EXPECT_GT(std::abs(one[7 + 1] - one[one.size() - 8 + 1]), 0.5);  // the vessel has moved
  for (size_t i = 0; i < one.size(); ++i)
    EXPECT_NEAR(one[i], all[i], 1e-9 * std::max(1.0, std::abs(one[i]))) << i;
}

}  // namespace
}  // namespace hawser::test::body_contact_ranks
