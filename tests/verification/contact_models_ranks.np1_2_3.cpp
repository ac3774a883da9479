// Impact of a pipe with springs and gap springs at the nodes: the impulse on several ranks is that on one.
#include "verification/contact_models.hpp"

namespace hawser::test::contact_models_ranks {
namespace {

double sum(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}

double contact_force(Simulation& s, const Kinematics& state) {
  double f = 0;
  NodeField field(s, "contact_normal_force");
  for (const double x : field.at(state)) f += x;
  return sum(f);
}

// First impact on the pipe, in steps of 2 ms.
TEST(ContactModelsRanks, Motion) {
  for (const model::ContactMethod method : {model::ContactMethod::nodes, model::ContactMethod::gap}) {
    const model::Case c = pipe(method, 2e-3);
    Simulation s(PETSC_COMM_WORLD, c, {point_support()});
    Dynamics& d = s.dynamics();
    d.start(s.state());
    double impulse = 0;
    d.run(
        0.17, [](double t) { return t + 100; },
        [&](const StepInfo& i) {
          impulse += i.h * contact_force(s, d.committed_kinematics());
          return true;
        });
    int size = 1;
    MPI_Comm_size(PETSC_COMM_WORLD, &size);
    // Every rank runs the same case alone.
    Simulation alone(PETSC_COMM_SELF, c, {point_support()});
    Dynamics& a = alone.dynamics();
    a.start(alone.state());
    double expected = 0;
    NodeField field(alone, "contact_normal_force");
    a.run(
        0.17, [](double t) { return t + 100; },
        [&](const StepInfo& i) {
          double f = 0;
          for (const double x : field.at(a.committed_kinematics())) f += x;
          expected += i.h * f;
          return true;
        });
    if (s.local().owned > 0 && s.local().global[0] == 0)
      std::printf("%d ranks, method %d: impulse %.9g N s, alone %.9g\n", size, static_cast<int>(method),
                  impulse, expected);
    EXPECT_GT(impulse, 1e3);
    EXPECT_NEAR(impulse, expected, 1e-6 * expected);
  }
}

}  // namespace
}  // namespace hawser::test::contact_models_ranks
