// Rods that drift and sink in water against closed forms: drag by relative velocity, and added mass.
#include "support/rig.hpp"

namespace hawser::test::water_motion_test {
namespace {

// A rod of 0.5 m, Cd 1.2, Ca 1, along x, both ends free.
model::Case rod(double mass, bool beam) {
  model::LineType t = beam ? beam_type(1e8, 1e7, 1e7, mass) : cable_type(1e8, mass);
  t.outer_diameter = t.contact_diameter = 0.5;
  model::Case c = one_line(t, 4, 4, {}, {});
  c.environment.gravity = 9.80665;
  c.environment.water.present = true;
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {Vec3(0, 0, -100), Vec3(4, 0, -100)};
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.step = 0.01;
  return c;
}

struct Row {
  double t, v, x;
};

void expect_rows(model::Case& c, const Vec3& way, const std::vector<Row>& rows) {
  c.dynamics.duration = rows.back().t;
  Simulation sim(PETSC_COMM_SELF, c);
  const double from = way.dot(sim.state().x[2]);
  sim.dynamics().start(sim.state());
  for (const Row& r : rows) {
    sim.dynamics().run(
        r.t, [&](double) { return r.t; }, [](const StepInfo&) { return true; });
    const Kinematics k = sim.dynamics().committed_kinematics();
    EXPECT_NEAR(k.time, r.t, 1e-9);
    EXPECT_NEAR(way.dot(k.v[2]), r.v, 1e-3 * std::abs(r.v)) << r.t;
    EXPECT_NEAR(way.dot(k.x[2]) - from, r.x, 1e-3 * std::abs(r.x)) << r.t;
  }
}

// A neutral rod released at rest in a current of 1 m/s across: v = U (1 - 1/(1 + t/tau)), tau = (m + ma)/(rho
// Cd D U/2).
TEST(WaterMotion, ReleasedRodIsTakenByTheCurrent) {
  for (const bool beam : {false, true}) {
    model::Case c = rod(1025 * M_PI / 4 * 0.25, beam);
    c.environment.water.current.profile = {{0, 1, M_PI / 2}};
    expect_rows(c, Vec3::UnitY(),
                {{0.5, 0.2763962665, 0.07652461241},
                 {1, 0.433088491, 0.2570760957},
                 {2, 0.6044127682, 0.7860572411},
                 {5, 0.7925190087, 2.941320157},
                 {10, 0.8842517205, 7.177360879},
                 {20, 0.9385706919, 16.34807103}});
  }
}

// A rod of 300 kg/m sinks with v = v_t tanh(t/tau) towards v_t = sqrt(w/(rho Cd D/2)).
TEST(WaterMotion, SinkingRodReachesItsTerminalVelocity) {
  for (const bool beam : {false, true}) {
    model::Case c = rod(300, beam);
    expect_rows(c, -Vec3::UnitZ(),
                {{0.5, 0.8806009814, 0.2304149238},
                 {1, 1.413197416, 0.8196846462},
                 {2, 1.729523184, 2.44000711},
                 {3, 1.769387422, 4.196116327},
                 {5, 1.774483093, 7.742873189},
                 {10, 1.774549519, 16.61559028}});
  }
}

// A ball on a taut massless string, x'' + b |x'| x' + omega² x = 0 with b = 0.05/m: seven peaks after a start
// 2 m aside.
TEST(WaterMotion, QuadraticDragDampsAnOscillation) {
  model::LineType t = cable_type(1e7, 1e-3);
  t.outer_diameter = t.contact_diameter = 1e-4;
  t.Cd_normal = t.Ca_normal = 0;
  model::Case c = one_line(t, 1904.7619047619, 2, anchor({0, 0, -500}), anchor({2000, 0, -500}));
  c.environment.water.present = true;
  c.environment.water.depth = 1000;
  model::PointMass ball;
  ball.at = 952.38095;
  ball.mass = 1000;
  ball.drag_area = 0.0975609756;
  c.lines[0].masses = {ball};
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {Vec3(0, 0, -500), Vec3(1000, 2, -500), Vec3(2000, 0, -500)};
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.step = 0.01;
  c.dynamics.duration = 20;
  c.dynamics.rho_infinity = 1;
  Simulation sim(PETSC_COMM_SELF, c);
  sim.dynamics().start(sim.state());
  std::vector<double> peaks{2};
  double before = 2, last = 2;
  sim.dynamics().run(
      20, [](double) { return 20.0; },
      [&](const StepInfo&) {
        const double y = std::abs(sim.dynamics().committed_kinematics().x[1].y());
        if (last > before && last >= y) peaks.push_back(last);
        before = last;
        last = y;
        return true;
      });
  const double exact[] = {2, 1.764379972, 1.578480641, 1.42805304, 1.303821813, 1.199488061, 1.110623482};
  ASSERT_GE(peaks.size(), 7U);
  double off = 0;
  for (size_t i = 0; i < 7; ++i) {
    off = std::max(off, std::abs(peaks[i] / exact[i] - 1));
    EXPECT_NEAR(peaks[i], exact[i], 1e-3 * exact[i]) << i;
  }
  printf("  seven peaks within %.4f %%\n", 100 * off);
}

}  // namespace
}  // namespace hawser::test::water_motion_test
