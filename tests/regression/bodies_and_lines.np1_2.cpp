// Shipped cases of bodies that hang on lines and of lines that touch bodies, shortened: the energy balance
// closes, contact occurs, and the results do not depend on the number of ranks.
#include <gtest/gtest.h>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/terms/body_contact.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::bodies_and_lines {
namespace {

struct Outcome {
  double unexplained = 0, turnover = 0;  // J at the end: error; work brought in plus dissipation
  double depth = 0, place = 0;           // m: penetration of bodies; x of the body's centre at the end
  int touched = 0;                       // steps in which a line touched a volume
};

Outcome outcome(MPI_Comm comm, const char* file, double duration) {
  model::Case c = io::read_case(std::string(HAWSER_SOURCE_DIR) + file);
  c.dynamics.duration = duration;
  const auto volumes = run::load_volumes(c);
  Simulation s(comm, c, run::surfaces(volumes), run::skeletons(c, volumes));
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto energy = [&] {
    const Energy e = s.system().energy(d.committed_kinematics());
    double sums[] = {total(e) + e.friction + e.damping + e.unresolved, e.work + d.support_work(),
                     e.friction + e.damping};
    MPI_Allreduce(MPI_IN_PLACE, sums, 3, MPI_DOUBLE, MPI_SUM, comm);
    return std::array{sums[0] - sums[1], std::abs(sums[1]) + sums[2]};
  };
  const double before = energy()[0];
  Outcome out;
  integrate(d, duration, duration, [&](const StepInfo&) {
    int touching = s.line_volume_contact()->active_count();
    MPI_Allreduce(MPI_IN_PLACE, &touching, 1, MPI_INT, MPI_SUM, comm);
    out.touched += touching > 0;
  });
  out.unexplained = energy()[0] - before;
  out.turnover = energy()[1];
  const auto* bodies = s.system().find<BodyContact>();
  out.depth = bodies ? bodies->largest_penetration() : 0;
  const int body = static_cast<int>(c.bodies.size()) - 1;
  const int n = s.local().find(s.mesh().body_node(body));
  if (n >= 0 && n < s.local().owned) out.place = d.committed_kinematics().x[static_cast<size_t>(n)].x();
  double all[] = {out.depth, out.place};
  MPI_Allreduce(MPI_IN_PLACE, &all[0], 1, MPI_DOUBLE, MPI_MAX, comm);
  MPI_Allreduce(MPI_IN_PLACE, &all[1], 1, MPI_DOUBLE, MPI_SUM, comm);
  out.depth = all[0];
  out.place = all[1];
  return out;
}

TEST(BodiesAndLines, ModuleOnSlingsMeetsItsFender) {
  const char* file = "/cases/lifted-load/lifted-load.yaml";
  const Outcome all = outcome(PETSC_COMM_WORLD, file, 14);
  const Outcome one = outcome(PETSC_COMM_SELF, file, 14);
  printf(
      "module on slings: %.0f J of %.0f J not explained, %.3f m into its fender, centre at %.6f m (one rank "
      "%.6f)\n",
      all.unexplained, all.turnover, all.depth, all.place, one.place);
  EXPECT_LT(std::abs(all.unexplained), 0.005 * all.turnover);
  EXPECT_GT(all.depth, 0.05);
  EXPECT_NEAR(all.place, one.place, 1e-4);
  EXPECT_NEAR(all.depth, one.depth, 0.02 * one.depth);
}

TEST(BodiesAndLines, HawserLiesAlongAPontoon) {
  const char* file = "/cases/barge-hawser/barge-hawser.yaml";
  const Outcome all = outcome(PETSC_COMM_WORLD, file, 16);
  const Outcome one = outcome(PETSC_COMM_SELF, file, 16);
  printf(
      "hawser along a pontoon: %.1f J of %.0f J not explained, %d steps with contact, centre at %.6f m (one "
      "rank "
      "%.6f)\n",
      all.unexplained, all.turnover, all.touched, all.place, one.place);
  EXPECT_LT(std::abs(all.unexplained), 0.005 * all.turnover);
  EXPECT_GT(all.touched, 100);
  EXPECT_NEAR(all.place, one.place, 1e-3);
}

}  // namespace
}  // namespace hawser::test::bodies_and_lines
