// Friction at the line's surface: a pipe that is pushed across a plane rolls. Closed forms of a solid
// cylinder.
#include "verification/contact_rig.hpp"

namespace hawser::test::line_contact_rolling_test {
namespace {

struct Pushed {
  double way = 0, turn = 0;  // m, rad, after a second
  double audit = 0, friction = 0, brought = 0;
};

// 4 m of free pipe, 50 kg/m, a solid cylinder of radius 0.1 m, on a plane with mu = 0.3; pushed by `push`
// N/m.
Pushed push(double push, bool rolling) {
  constexpr double radius = 0.1, mass = 50, gravity = 9.81, stiffness = 1e6;
  model::LineType type = beam_type(1e8, 1e5, 1e5, mass);
  type.outer_diameter = type.contact_diameter = 2 * radius;
  type.rotary_inertia = Vec3(mass * radius * radius / 2, 0.1, 0.1);
  model::Case c = one_line(type, 4, 4, {}, {});
  c.environment.gravity = gravity;
  c.contact.rolling = rolling;
  model::Line& line = c.lines[0];
  const double z = radius - mass * gravity / stiffness;
  line.start = model::Start::points;
  line.points = {{0, 0, z}, {4, 0, z}};
  model::DistributedLoad load;
  load.per_length = Vec3(0, push, 0);
  line.loads.push_back(load);
  model::Volume ground;
  ground.name = "ground";
  ground.basis = model::StiffnessBasis::per_length;
  ground.normal_stiffness = stiffness;
  ground.friction.axial = ground.friction.lateral = 0.3;
  ground.friction.mobilisation_length = 2e-5;
  ground.relative_damping = 0.1;
  c.volumes.push_back(ground);
  c.dynamics.step = 0.002;
  Simulation s(PETSC_COMM_WORLD, c, {std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ())});
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const Energy e0 = s.system().energy(d.committed_kinematics());
  const Quat q0 = s.state().q[2];
  double turn = 0;
  Quat last = q0;
  d.run(
      1, [](double t) { return t + 100; },
      [&](const StepInfo&) {
        const Quat q = d.committed_kinematics().q[2];
        turn += log_so3(q * last.conjugate()).x();
        last = q;
        return true;
      });
  const Energy e = s.system().energy(d.committed_kinematics());
  Pushed out;
  out.way = d.committed_kinematics().x[2].y();
  out.turn = turn;
  out.friction = e.friction;
  out.brought = e.work + d.support_work() - (e.potential - e0.potential);
  out.audit = (e.kinetic + e.strain - e0.kinetic - e0.strain + e.friction + e.damping) / out.brought - 1;
  return out;
}

void print(const char* what, const Pushed& p, double way) {
  std::printf(
      "pushed pipe, %s: %.5f m in a second (%.5f), surface %.5f m by turning; friction took %.3f of %.1f J, "
      "not "
      "accounted for %.1e\n",
      what, p.way, way, -0.1 * p.turn, p.friction, p.brought, p.audit);
}

// A solid cylinder: a = f/(m + J/r²) = f/(1.5 m) while friction f/3 is below mu m g.
TEST(LineRolling, RollsWithoutSliding) {
  const Pushed p = push(100, true);
  print("rolls", p, 0.5 * 100 / 75.0);
  EXPECT_NEAR(p.way, 0.5 * 100 / 75.0, 2e-3 * 0.667);
  EXPECT_NEAR(-0.1 * p.turn, p.way, 2e-3);  // except for the elastic slip
  EXPECT_LT(p.friction, 0.01 * p.brought);
  EXPECT_LT(std::abs(p.audit), 1e-3);
}

// Above that the cylinder also slides: a = f/m - mu g, with the moment mu m g r.
TEST(LineRolling, RollsAndSlides) {
  const Pushed p = push(600, true);
  const double way = 0.5 * (600 / 50.0 - 0.3 * 9.81), turned = 0.5 * 0.3 * 9.81 * 2;
  print("rolls and slides", p, way);
  EXPECT_NEAR(p.way, way, 2e-3 * way);
  EXPECT_NEAR(-0.1 * p.turn, turned, 3e-3 * turned);
  EXPECT_NEAR(p.friction, 0.3 * 50 * 9.81 * 4 * (way - turned), 0.01 * p.friction);
  EXPECT_LT(std::abs(p.audit), 1e-3);
}

// With friction at the axis the pipe stands still, or slides without rotation.
TEST(LineRolling, WithoutIt) {
  const Pushed held = push(100, false);
  const Pushed slides = push(600, false);
  print("held", held, 0);
  EXPECT_LT(held.way, 3e-3);
  EXPECT_NEAR(slides.way, 0.5 * (600 / 50.0 - 0.3 * 9.81), 0.02);
  EXPECT_LT(std::abs(slides.turn), 1e-9);
}

}  // namespace
}  // namespace hawser::test::line_contact_rolling_test
