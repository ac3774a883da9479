// Waves on lines: a pile, and a rod that the water carries along.
#include "support/rig.hpp"

namespace hawser::test {
namespace {

model::Waves one_wave(double height, double period, double phase = 0) {
  model::Waves w;
  w.kind = model::Waves::Kind::regular;
  w.rows = {{height, period, 0, phase}};
  return w;
}

// A pile of 1 m, Cd 1.2, Cm 2, standing from the bed to `top`. Its displaced diameter is thin, so that it is
// wet up to the surface sharply; the coefficients make up for it.
model::Case pile(double depth, double top, const model::Waves& waves) {
  constexpr double thin = 0.02;
  model::LineType t = cable_type(1e9, 100);
  t.outer_diameter = t.contact_diameter = thin;
  t.drag_diameter = 1, t.Cd_normal = 1.2, t.Ca_normal = 2 / (thin * thin) - 1;
  model::Case c = one_line(t, depth + top, 400, anchor({0, 0, -depth}), anchor({0, 0, top}));
  c.environment.gravity = 9.80665;
  c.environment.water.present = true, c.environment.water.depth = depth;
  c.environment.water.waves = waves;
  c.lines[0].start = model::Start::straight;
  return c;
}

// In-line force at time t.
double force(Simulation& sim, double t) {
  State& s = sim.state();
  s.time = t;
  sim.system().prepare(s.view(0.1), 0.1);
  VecHandle r = sim.system().create_vector();
  sim.system().residual(s.view(0.1), r.get());
  double sum = 0;
  for (size_t i = 0; i < sim.system().reactions().size(); i += 3) sum -= sim.system().reactions()[i];
  return sum;
}

// Closed forms of linear theory to the still water, and of Wheeler's stretching under the crest.
TEST(WaveLoads, Pile) {
  struct Row {
    double height, period, depth, most, wheeler;
  };
  for (const Row& r : {Row{5, 10, 50, 38476.06258, 22371.45468},
                       {10, 12, 100, 98014.99919, 82352.88827},
                       {2, 6, 20, 15464.62383, 3466.84229}}) {
    model::Waves w = one_wave(r.height, r.period);
    w.stretching = Stretching::none;
    const model::Case linear = pile(r.depth, 0, w);
    Simulation sim(PETSC_COMM_SELF, linear);
    double most = 0;
    for (int i = 0; i <= 90; ++i) most = std::max(most, force(sim, -0.25 * r.period * i / 90));
    w.stretching = Stretching::wheeler;
    const model::Case crest = pile(r.depth, r.height / 2, w);
    Simulation high(PETSC_COMM_SELF, crest);
    const double drag = force(high, 0);
    printf("  H %g m: largest %+.3f %%, drag under the crest %+.3f %%\n", r.height, 100 * (most / r.most - 1),
           100 * (drag / r.wheeler - 1));
    EXPECT_NEAR(most, r.most, 1e-3 * r.most);
    EXPECT_NEAR(drag, r.wheeler, 1e-3 * r.wheeler);
  }
}

// A neutral rod without drag has (m + Ca rho A) a = (1 + Ca) rho A a_w: it moves as the water does.
TEST(WaveLoads, NeutralRodMovesWithTheWater) {
  for (const bool beam : {false, true}) {
    const double mass = 1025 * M_PI / 4 * 0.01;
    model::LineType t = beam ? beam_type(1e7, 1e5, 1e5, mass) : cable_type(1e7, mass);
    t.outer_diameter = t.contact_diameter = 0.1;
    t.Cd_normal = 0, t.Ca_axial = 1;
    model::Case c = one_line(t, 1, 2, {}, {});
    c.environment.gravity = 9.80665;
    c.environment.water.present = true, c.environment.water.depth = 40;
    c.environment.water.waves = one_wave(0.02, 6);
    c.environment.water.waves.ramp = 6;
    c.lines[0].start = model::Start::points;
    c.lines[0].points = {Vec3(0, 0, -3), Vec3(0, 1, -3)};
    c.statics.enabled = false;
    c.dynamics.enabled = true;
    c.dynamics.duration = 20, c.dynamics.step = 0.02, c.dynamics.rho_infinity = 1;
    Simulation sim(PETSC_COMM_SELF, c);
    sim.dynamics().start(sim.state());
    const double omega = 2 * M_PI / 6, k = wave_number(omega, 40, 9.80665);
    const double across = 0.01 * omega * std::cosh(k * 37) / std::sinh(k * 40);
    const double up = 0.01 * omega * std::sinh(k * 37) / std::sinh(k * 40);
    double off = 0;
    sim.dynamics().run(
        20, [](double) { return 20.0; },
        [&](const StepInfo& info) {
          if (info.time < 7) return true;
          const Vec3 v = sim.dynamics().kinematics().v[1];
          const double angle = -omega * info.time;
          off = std::max(off, (v - Vec3(across * std::cos(angle), 0, up * std::sin(angle))).norm());
          return true;
        });
    printf("  %s: %.2f %% of the speed away\n", beam ? "beam" : "cable", 100 * off / across);
    EXPECT_LT(off, 0.02 * across);
  }
}

}  // namespace
}  // namespace hawser::test
