// Wave loads on a pile, and a rod that moves with the water.
#include "hawser/model/wave_components.hpp"
#include "support/rig.hpp"

namespace hawser::test::waves_test {
namespace {

model::Waves one_wave(double height, double period, double phase = 0) {
  model::Waves w;
  w.systems.emplace_back().rows = {{height, period, 0, phase}};
  return w;
}

// A pile of 1 m, Cd 1.2, Cm 2, from the bed to `top`. The wet length of a cable ends sharply at the surface
// only if it is thin, so its displaced diameter is small; the coefficients compensate for this.
model::Case pile(double depth, double top, const model::Waves& waves, bool beam = false, int elements = 400) {
  model::LineType t = beam ? beam_type(1e9, 1e9, 1e9, 100) : cable_type(1e9, 100);
  const double d = beam ? 1 : 0.02;
  t.outer_diameter = t.contact_diameter = d;
  t.drag_diameter = 1;
  t.Cd_normal = 1.2;
  t.Ca_normal = 2 / (d * d) - 1;
  model::Case c = one_line(t, depth + top, elements, anchor({0, 0, -depth}), anchor({0, 0, top}));
  c.environment.gravity = 9.80665;
  c.environment.water.present = true;
  c.environment.water.depth = depth;
  c.environment.water.waves = waves;
  c.lines[0].start = model::Start::straight;
  return c;
}

// In-line force and moment about the bed at time t, from the node forces; the pile is straight.
struct Load {
  double force = 0, moment = 0;
};
Load load(Simulation& sim, double t) {
  State& s = sim.state();
  s.time = t;
  sim.system().prepare(s.after_step(0.1), 0.1);
  VecHandle r = sim.system().create_vector();
  sim.system().residual(s.after_step(0.1), r.get());
  const LocalMesh& mesh = sim.system().mesh();
  Load sum;
  for (size_t n = 0; n < s.x.size(); ++n) {
    const double* r0 = sim.system().reactions().data() + 3 * mesh.block[n];
    sum.force -= r0[0];
    sum.moment -= r0[0] * (s.x[n].z() - s.x[0].z());
    if (mesh.rotates(static_cast<int>(n))) sum.moment -= (s.q[n] * Eigen::Map<const Vec3>(r0 + 3)).y();
  }
  return sum;
}

// Closed forms of linear theory up to still water, and with Wheeler's stretching under the crest: forces, and
// moments about the bed. 100 beams, up to as long as the pile's diameter.
TEST(WaveLoads, Pile) {
  struct Row {
    double height, period, depth, most, wheeler, inertia_moment, drag_moment, largest_moment;
  };
  for (const Row& r :
       {Row{5, 10, 50, 38476.06258, 22371.45468, 1196872.1634508849, 783995.4771601028, 1240791.1530843226},
        {10, 12, 100, 98014.99919, 82352.88827, 5368991.900563488, 6361846.696140481, 7494618.177627006},
        {2, 6, 20, 15464.62383, 3466.84229, 198901.829958623, 50238.50987051225, 198901.829958623}})
    for (const bool beam : {false, true}) {
      model::Waves w = one_wave(r.height, r.period);
      w.stretching = Stretching::none;
      const model::Case linear = pile(r.depth, 0, w, beam, beam ? 100 : 400);
      Simulation sim(PETSC_COMM_SELF, linear);
      Load most;
      for (int i = 0; i <= 90; ++i) {
        const Load l = load(sim, -0.25 * r.period * i / 90);
        most.force = std::max(most.force, l.force);
        most.moment = std::max(most.moment, l.moment);
      }
      const double inertia = load(sim, -0.25 * r.period).moment;
      const double drag_only = load(sim, 0).moment;
      w.stretching = Stretching::wheeler;
      const model::Case crest = pile(r.depth, r.height / 2, w, beam, beam ? 100 : 400);
      Simulation high(PETSC_COMM_SELF, crest);
      const double drag = load(high, 0).force;
      printf(
          "  H %g m, %s: largest %+.3f %%, drag under the crest %+.3f %%; moments: inertia %+.3f %%, drag "
          "%+.3f %%, largest %+.3f %%\n",
          r.height, beam ? "beam" : "cable", 100 * (most.force / r.most - 1), 100 * (drag / r.wheeler - 1),
          100 * (inertia / r.inertia_moment - 1), 100 * (drag_only / r.drag_moment - 1),
          100 * (most.moment / r.largest_moment - 1));
      EXPECT_NEAR(most.force, r.most, 1e-3 * r.most);
      EXPECT_NEAR(drag, r.wheeler, 1e-3 * r.wheeler);
      EXPECT_NEAR(inertia, r.inertia_moment, 1e-3 * r.inertia_moment);
      EXPECT_NEAR(drag_only, r.drag_moment, 1e-3 * r.drag_moment);
      EXPECT_NEAR(most.moment, r.largest_moment, 1e-3 * r.largest_moment);
    }
}

// The same pile in Stokes' wave on a current, against quadrature of its kinematics from the bed to the
// surface.
TEST(WaveLoads, PileInStokesWave) {
  const double depth = 30, D = 1, Cd = 1.2, Cm = 2, rho = 1025;
  model::WaveSystem w;
  w.kind = model::WaveSystem::Kind::stokes;
  w.rows = {{9, 9, 0, 0}};
  w.current = 0.5;
  model::Waves waves;
  waves.systems = {w};
  const model::Case c = pile(depth, 8, waves);
  const WaveField field = model::wave_field(c.environment);
  Simulation sim(PETSC_COMM_SELF, c);
  for (const double t : {0.0, -1.0, -2.3, 1.1, 4.0}) {
    const double top = field.at({0, 0, 0}, t).surface;
    Load expected;
    const int n = 4000;
    for (int i = 0; i < n; ++i) {
      const double y = (i + 0.5) * (depth + top) / n;
      const WaveMotion m = field.at({0, 0, y - depth}, t);
      const double u = m.velocity.x();
      const double f =
          (0.5 * rho * Cd * D * std::abs(u) * u + rho * Cm * M_PI / 4 * D * D * m.acceleration.x()) *
          (depth + top) / n;
      expected.force += f;
      expected.moment += f * y;
    }
    const Load l = load(sim, t);
    printf("  t %g s: surface at %.2f m, force %.0f N, off by %+.3f %%, moment %+.3f %%\n", t, top,
           expected.force, 100 * (l.force - expected.force) / 1e5,
           100 * (l.moment - expected.moment) / (1e5 * depth));
    EXPECT_NEAR(l.force, expected.force, 2e-3 * 1e5);
    EXPECT_NEAR(l.moment, expected.moment, 2e-3 * 1e5 * depth);
  }
}

// Wave kinematics are evaluated once a step, at the position that a node reaches with its velocity at the
// start of the step. Newton's iterations do not evaluate them again; a new step does.
TEST(WaveLoads, OneLookANodeAndStep) {
  model::Waves w = one_wave(4, 8);
  model::Case c = pile(40, -5, w);
  c.line_types[0].Cd_normal = 0;
  Simulation sim(PETSC_COMM_SELF, c);
  sim.system().prepare(sim.state().after_step(0.1), 0.1);
  State s = sim.state();
  s.time = 1.3;
  const auto force = [&](double shift) {
    State moved = s;
    for (Vec3& x : moved.x) x.x() += shift;
    VecHandle r = sim.system().create_vector();
    sim.system().residual(moved.after_step(0.1), r.get());
    double sum = 0;
    for (size_t n = 0; n < moved.x.size(); ++n) sum -= sim.system().reactions()[3 * n];
    return sum;
  };
  const double here = force(0);
  EXPECT_GT(std::abs(here), 1e3);
  EXPECT_NEAR(force(20), here, 1e-9 * std::abs(here));  // a fifth of a wavelength farther
  for (Vec3& x : s.x) x.x() += 20;
  State before = s;
  before.time -= 0.1;
  sim.system().prepare(before.after_step(0.1), 0.1);
  EXPECT_GT(std::abs(force(0) - here), 1e-2 * std::abs(here));
}

// A neutral rod without drag has (m + Ca rho A) a = (1 + Ca) rho A a_w: it moves with the water.
TEST(WaveLoads, NeutralRodMovesWithTheWater) {
  for (const bool beam : {false, true}) {
    const double mass = 1025 * M_PI / 4 * 0.01;
    model::LineType t = beam ? beam_type(1e7, 1e5, 1e5, mass) : cable_type(1e7, mass);
    t.outer_diameter = t.contact_diameter = 0.1;
    t.Cd_normal = 0;
    t.Ca_axial = 1;
    model::Case c = one_line(t, 1, 2, {}, {});
    c.environment.gravity = 9.80665;
    c.environment.water.present = true;
    c.environment.water.depth = 40;
    c.environment.water.waves = one_wave(0.02, 6);
    c.environment.water.waves.ramp = 6;
    c.lines[0].start = model::Start::points;
    c.lines[0].points = {Vec3(0, 0, -3), Vec3(0, 1, -3)};
    c.statics.enabled = false;
    c.dynamics.enabled = true;
    c.dynamics.duration = 20;
    c.dynamics.step = 0.02;
    c.dynamics.rho_infinity = 1;
    Simulation sim(PETSC_COMM_SELF, c);
    sim.dynamics().start(sim.state());
    const double omega = 2 * M_PI / 6;
    const double k = wave_number(omega, 40, 9.80665);
    const double across = 0.01 * omega * std::cosh(k * 37) / std::sinh(k * 40);
    const double up = 0.01 * omega * std::sinh(k * 37) / std::sinh(k * 40);
    double off = 0;
    sim.dynamics().run(
        20, [](double) { return 20.0; },
        [&](const StepInfo& info) {
          if (info.time < 7) return true;
          const Vec3 v = sim.dynamics().committed_kinematics().v[1];
          const double angle = -omega * info.time;
          off = std::max(off, (v - Vec3(across * std::cos(angle), 0, up * std::sin(angle))).norm());
          return true;
        });
    printf("  %s: %.2f %% of the speed away\n", beam ? "beam" : "cable", 100 * off / across);
    EXPECT_LT(off, 0.02 * across);
  }
}

}  // namespace
}  // namespace hawser::test::waves_test
