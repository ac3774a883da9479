// Statics in one load step under point loads only, without weight. Reference: elastica of Bisshopp & Drucker
// (1945), elliptic integrals to 30 digits (case S02).
#include "support/rig.hpp"

namespace hawser::statics_point_loads_test {

using namespace hawser::test;

TEST(StaticsPointLoads, ElasticaFromTheStraightBeam) {
  struct Row {
    double alpha, x, y;
  };
  for (const Row& r : {Row{0.25, 0.9958821816, 0.08274591535}, Row{1, 0.9435667637, 0.3017207738},
                       Row{10, 0.4450044022, 0.8106090249}, Row{50, 0.199999604, 0.9171554473}}) {
    model::Case c = one_line(beam_type(1e8, 1, 1), 1, 20, clamp(Vec3::Zero(), Vec3::UnitX()), {});
    c.lines[0].start = model::Start::straight;
    c.lines[0].point_loads.push_back({1.0, Vec3(0, 0, r.alpha), Vec3::Zero(), 0});
    Simulation s(PETSC_COMM_WORLD, c);
    const StaticsReport report = s.solve_statics();
    EXPECT_EQ(report.negative_eigenvalues, 0);
    const Vec3 tip = s.state().x.back();
    EXPECT_NEAR(tip.x(), r.x, 1e-4) << "alpha " << r.alpha;
    EXPECT_NEAR(tip.z(), r.y, 1e-4) << "alpha " << r.alpha;
  }
}

TEST(StaticsPointLoads, AForceThatLastsKeepsTheEnergyOfDynamicsInBalance) {
  // Released from the straight beam: kinetic + strain energy = work of the tip force, which has a potential.
  model::Case c = one_line(beam_type(1e6, 1, 1), 1, 8, clamp(Vec3::Zero(), Vec3::UnitX()), {});
  c.lines[0].start = model::Start::straight;
  c.lines[0].point_loads.push_back({1.0, Vec3(0, 0, 2), Vec3::Zero(), 0});
  c.statics.enabled = false;
  c.dynamics.step = 1e-3;
  c.dynamics.rho_infinity = 1;
  Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const Energy before = s.system().energy(d.committed_kinematics());
  d.run(
      0.3, [](double) { return 0.3; }, [](const StepInfo&) { return true; });
  const Energy e = s.system().energy(d.committed_kinematics());
  const double work = before.potential - e.potential;
  EXPECT_GT(work, 0.1);
  EXPECT_EQ(e.work, 0);
  EXPECT_NEAR(e.kinetic + e.strain, work, 2e-3 * work);
}

}  // namespace hawser::statics_point_loads_test
