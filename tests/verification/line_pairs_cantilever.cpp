// A cantilever pressed down by a crossing beam, against results of 4C.
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_cantilever_test {
namespace {

// 4C's test beam3eb_static_contact_penalty_newgap_twocrossedbeams: a cantilever of 1 m along x with ten
// elements, and across it at x = 0.4 m a beam of 1 m along z, clamped at both ends, which starts 0.1 m above
// (y) and moves down by 0.155 m; E I = 8.333e-9 N m², E A = 10 N, point penalty 1e-5 N/m. The tip of the
// cantilever moves by (-0.015842, -0.170225); with another integration rule of the elements 4C has
// (-0.016127, -0.171522). 4C's lines are 0.114 mm thick with a penetration of 2 mm. Here they are 12 mm thick
// and farther apart by as much, with a stiffness per length for the same penetration at the same force.
TEST(CrossedCantilever, TipAs4C) {
  const double radius = 0.006;
  const double thin = std::pow(4 * 8.3333333333e-18 / M_PI, 0.25);
  model::Case c;
  c.environment.gravity = 0;
  model::LineType type = beam_type(10, 8.3333333333e-9, 8.3333333333e-9, 1);
  type.contact_diameter = 2 * radius;
  c.line_types = {type};
  const double lift = 2 * radius - 2 * thin;
  model::Body jaw;
  jaw.name = "jaw";
  jaw.position = Vec3(0.4, 0.1 + lift, 0);
  model::TableMotion m;
  for (int i = 0; i <= 4; ++i) {
    m.time.push_back(0.25 * i);
    m.offset.push_back({0, -0.155 * 0.25 * i, 0});
  }
  jaw.motion = m;
  c.bodies = {jaw};
  model::Line cantilever = straight_line("cantilever", "beam", 1, 20, clamp({0, 0, 0}, Vec3::UnitX()), {});
  c.lines.push_back(cantilever);
  model::End a = clamp({0, 0, -0.5}, Vec3::UnitZ());
  model::End b = clamp({0, 0, 0.5}, Vec3::UnitZ());
  for (model::End* e : {&a, &b}) {
    e->kind = model::EndKind::body;
    e->carrier = "jaw";
  }
  c.lines.push_back(straight_line("jaw", "beam", 1, 20, a, b));
  double k = 1.1e-3, force = 0;
  Vec3 tip;
  // The stiffness per length for which force / penetration is 1e-5 N/m.
  for (int pass = 0; pass < 4; ++pass) {
    touch(c, k, 1e-6);
    Simulation s(PETSC_COMM_WORLD, c);
    for (int i = 1; i <= 200; ++i) {
      const State last = s.state();
      std::vector<double> u(3 * static_cast<size_t>(s.local().blocks()), 0);
      const double t = 0.005 * i;
      for (int n = 0; n < s.local().nodes(); ++n)  // the crossing beam moves down as a whole
        if (s.mesh().node(static_cast<size_t>(n)).line == 1)
          u[3 * static_cast<size_t>(s.local().block[static_cast<size_t>(n)]) + 1] = -0.155 * 0.005;
      retract(s.local(), last, u.data(), s.state());
      s.state().time = t;
      settle(s, 1e-9);
    }
    s.system().commit(s.state().at_rest());
    tip = s.state().x[static_cast<size_t>(s.mesh().lines[0].nodes - 1)] - Vec3(1, 0, 0);
    force = s.line_pairs()->normal_force();
    const double pressed = s.line_pairs()->deepest().depth;
    printf("  tip (%.6f, %.6f, %.1e) m, force %.4e N, pressed in by %.4f mm\n", tip.x(), tip.y(), tip.z(),
           force, 1e3 * pressed);
    k *= 1e-5 / (force / pressed);
  }
  EXPECT_NEAR(tip.x(), -0.01584, 0.05 * 0.01584);
  EXPECT_NEAR(tip.y(), -0.17023, 0.02 * 0.17023);
}

}  // namespace
}  // namespace hawser::test::line_pairs_cantilever_test
