// Lines at rest in water against closed forms: a towed cable in a current, a floating hose.
#include "support/rig.hpp"

namespace hawser::test::water_statics_test {
namespace {

// A towed cable is straight at the critical angle, where normal drag balances the normal component of weight:
// cos phi = -k + sqrt(1 + k²), k = w/(rho Cd D U²). The tension carries the axial component.
TEST(WaterStatics, TowedCableStreamsAtItsCriticalAngle) {
  struct Row {
    double speed, degrees, tension;  // m/s, from the horizontal, N per m of cable
  };
  const double A = M_PI / 4 * 0.05 * 0.05;
  for (const Row& r :
       {Row{1, 81.35697421, 197.728762}, {2, 61.5896657, 175.9125543}, {4, 35.19505662, 115.2723624}})
    for (const bool beam : {false, true}) {
      const double mass = 200 / 9.80665 + 1025 * A;
      model::LineType t = beam ? beam_type(1e8, 500, 500, mass) : cable_type(1e8, mass);
      t.outer_diameter = t.contact_diameter = 0.05;
      model::Case c = one_line(t, 100, 50, anchor({0, 0, -10}), {});
      c.environment.gravity = 9.80665;
      c.environment.water.present = true;
      c.environment.water.current.profile = {{0, r.speed, 0.6}};
      Simulation sim(PETSC_COMM_SELF, c);
      SCOPED_TRACE(testing::Message() << r.speed << " " << beam);
      const StaticsReport report = sim.solve_statics();
      EXPECT_LT(report.iterations, 100);
      const State& s = sim.state();
      const Vec3 chord = s.x.back() - s.x.front();
      EXPECT_NEAR(std::atan2(chord.y(), chord.x()), 0.6, 1e-6);
      EXPECT_NEAR(std::atan2(-chord.z(), chord.head<2>().norm()) * 180 / M_PI, r.degrees, 0.02);
      Vec3 pull = Vec3::Zero();
      for (int i = 0; i < 3; ++i) pull[i] = sim.system().reactions()[static_cast<size_t>(i)];
      EXPECT_NEAR(pull.norm(), 100 * r.tension, 1e-4 * 100 * r.tension);
    }
}

// The floating hose of 0.12 t/m in air and 0.08 t/m net buoyancy when submerged (OMAE2006-92155, Table 4),
// its ends held at the surface: far from them its draught, and the stiffness against a vertical load.
// Circular segment.
TEST(WaterStatics, FloatingHoseAtRest) {
  const double d = 0.4984345337, draught = 0.2885278499254018, stiffness = 4947.4514377865435;
  for (const bool beam : {false, true})
    for (const double push : {0.0, 1.0}) {  // N/m
      model::LineType t = beam ? beam_type(6.178e7, 1.961e5, 1.961e5, 120) : cable_type(6.178e7, 120);
      t.outer_diameter = t.contact_diameter = d;
      model::Case c = one_line(t, 278.5, 140, anchor({0, 0, 0}), anchor({278.5, 0, 0}));
      c.environment.gravity = 9.80665;
      c.environment.water.present = true;
      c.lines[0].start = model::Start::straight;
      c.lines[0].loads = {{Vec3(0, 0, -push)}};
      Simulation sim(PETSC_COMM_SELF, c);
      sim.solve_statics();
      const double is = d / 2 - sim.state().x[70].z();
      const double expected = draught + push / stiffness;
      if (push == 0) printf("  %s: draught %+.1e\n", beam ? "beam" : "cable", is / draught - 1);
      EXPECT_NEAR(is, expected, (push > 0 ? 1e-6 : 1e-4) * draught) << beam;
    }
}

}  // namespace
}  // namespace hawser::test::water_statics_test
