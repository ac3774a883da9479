// A mooring line in a current and an irregular sea, lying with friction, cut between ranks: statics and some
// seconds with a moving fairlead are those of one rank.
#include "hawser/terms/seabed.hpp"
#include "support/rig.hpp"

namespace hawser::test {
namespace {

model::Case chain() {
  model::LineType t = cable_type(7.536e8, 113.35);
  t.outer_diameter = t.contact_diameter = 0.0766;
  model::Case c = one_line(t, 835, 120, anchor({0, 0, -200}), {});
  c.environment.gravity = 9.80665;
  c.environment.water.present = true, c.environment.water.depth = 200;
  c.environment.water.current.profile = {{0, 1, 0.8}, {200, 0.2, 0.3}};
  model::Waves& waves = c.environment.water.waves;
  waves.kind = model::Waves::Kind::spectrum;
  waves.height = 4, waves.peak_period = 9, waves.gamma = 3.3, waves.direction = 0.5, waves.spreading = 4;
  waves.count = 100, waves.seed = 7, waves.ramp = 3;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true, bed.depth = 200, bed.normal_stiffness = 1e5, bed.damping = 1e4;
  bed.friction.axial = 0.6, bed.friction.lateral = 0.9, bed.friction.mobilisation_length = 0.01;
  model::Body b;
  b.name = "ship";
  b.position = {795, 0, -14};
  model::HarmonicMotion m;
  m.amplitude = Vec3(1, 0.5, 2), m.period = 8;
  b.motion = m, b.ramp = 4;
  c.bodies.push_back(b);
  model::End e;
  e.kind = model::EndKind::body, e.body = "ship";
  c.lines[0].end_b = e;
  c.dynamics.enabled = true;
  c.dynamics.duration = 6, c.dynamics.step = 0.1;
  return c;
}

TEST(MooringRanks, TheSameOnAnyNumber) {
  const model::Case c = chain();
  Simulation all(PETSC_COMM_WORLD, c), one(PETSC_COMM_SELF, c);
  const auto compare = [&](double most, const char* when) {
    const Kinematics a = c.dynamics.enabled && all.dynamics().committed().s.time > 0
                             ? all.dynamics().kinematics()
                             : all.state().view(0);
    const Kinematics b = a.time > 0 ? one.dynamics().kinematics() : one.state().view(0);
    double off = 0;
    for (int n = 0; n < all.local().owned; ++n)
      off = std::max(off, (a.x[static_cast<size_t>(n)] -
                           b.x[static_cast<size_t>(all.local().global[static_cast<size_t>(n)])])
                              .norm());
    MPI_Allreduce(MPI_IN_PLACE, &off, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
    EXPECT_LT(off, most) << when;
    printf("  %s: %.1e m apart\n", when, off);
  };
  all.solve_statics(), one.solve_statics();
  compare(1e-7, "statics");
  int touching = all.seabed()->touching();
  MPI_Allreduce(MPI_IN_PLACE, &touching, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  EXPECT_EQ(touching, one.seabed()->touching());
  EXPECT_GT(touching, 20);
  for (Simulation* s : {&all, &one}) {
    s->dynamics().start(s->state());
    s->dynamics().run(
        6, [](double) { return 6.0; }, [](const StepInfo&) { return true; });
  }
  compare(1e-6, "after 6 s");
}

}  // namespace
}  // namespace hawser::test
