// A line is drawn over another with friction: the supports carry mu N, for any direction of motion. The lines
// are stiff, because bent lines would also climb over each other.
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_pull_test {
namespace {

constexpr double kMu = 0.3, kRadius = 0.05;

// The second line crosses the first at the angle theta. The body at its ends moves it in the direction `way`
// (angle from the first line).
struct Drawn {
  double friction = 0,
         normal = 0;  // N, of the supports of the drawn line: along the motion and normal to both lines
  double aside = 0;   // N, across the motion, in the plane
  int iterations = 0, steps = 0;
};

Drawn draw(double theta, double way, int elements) {
  model::Case c;
  c.environment.gravity = 0;
  model::LineType type = beam_type(1e9, 1e6, 1e6);
  type.contact_diameter = 2 * kRadius;
  c.line_types = {type};
  const Vec3 along(std::cos(theta), std::sin(theta), 0);
  const Vec3 pull(std::cos(way), std::sin(way), 0);
  const double press = 0.0015;
  const double z = 2 * kRadius - press;
  model::Body sledge;
  sledge.name = "sledge";
  sledge.position = Vec3(0, 0, z);
  model::TableMotion m;
  for (int i = 0; i <= 4; ++i) {
    m.time.push_back(0.25 * i);
    m.offset.push_back(0.25 * i * 0.06 * pull);
  }
  sledge.motion = m;
  c.bodies = {sledge};
  // Clamped at both ends, so that neither line rotates about its axis.
  model::End a = clamp({-1, 0, 0}, Vec3::UnitX());
  model::End b = clamp({1, 0, 0}, Vec3::UnitX());
  c.lines.push_back(straight_line("first", "beam", 2, elements, a, b));
  for (model::End* e : {&a, &b}) {
    e->kind = model::EndKind::body;
    e->carrier = "sledge";
    e->direction = along;
    e->at = (e == &a ? -1 : 1) * along;
  }
  c.lines.push_back(straight_line("second", "beam", 2, elements, a, b));
  touch(c, 1e8, 1e-5, kMu, 5e-4);
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  Drawn out;
  const int steps = 40;
  VecHandle r;
  for (int i = 1; i <= steps; ++i) {
    const State last = s.state();
    // Initial guess: only the ends move.
    std::vector<double> u(3 * static_cast<size_t>(s.local().blocks()), 0);
    s.system().tied_nodes().increments(last, i / static_cast<double>(steps), u.data());
    State& now = s.state();
    State moved = last;
    retract(s.local(), last, u.data(), moved);
    moved.time = i / static_cast<double>(steps);
    // The step of friction begins at the last equilibrium, not at the last iterate.
    VecHandle du = s.system().create_vector();
    VecHandle res = s.system().create_vector();
    MatHandle J = s.system().create_matrix();
    KspHandle ksp;
    check(KSPCreate(s.system().comm(), ksp.out()));
    configure_linear_solver(ksp.get(), s.system(), "verification_");
    if (s.system().update_couplings(last.at_rest(), 0) == CouplingChange::layout_changed) {
      du = s.system().create_vector();
      res = s.system().create_vector();
      J = s.system().create_matrix();
      configure_linear_solver(ksp.get(), s.system(), "verification_");
    }
    s.system().prepare(last.at_rest(), 0);
    now = moved;
    const std::vector<double> zero(3 * static_cast<size_t>(s.local().blocks()), 0);
    int it = 0;
    for (; it < 30; ++it) {
      s.system().residual(now.at_rest(), res.get());
      if (it > 0 && s.system().norms(res.get()).small(1e-9)) break;
      s.system().tangent(now.at_rest(), {}, zero, false, J.get());
      check(KSPSetOperators(ksp.get(), J.get(), J.get()));
      check(KSPSolve(ksp.get(), res.get(), du.get()));
      check(VecScale(du.get(), -1));
      std::vector<double> local;
      s.system().gather_with_ghosts(du.get(), local);
      State next = now;
      retract(s.local(), now, local.data(), next);
      next.time = now.time;
      now = next;
    }
    EXPECT_LT(it, 30);
    out.iterations += it;
    ++out.steps;
    s.system().commit(now.at_rest());
  }
  const std::vector<double>& f = s.system().reactions();
  Vec3 sum = Vec3::Zero();
  for (const TiedNode& held : s.system().tied_nodes().nodes())
    if (s.mesh().node(static_cast<size_t>(held.node)).line == 1)
      sum += Eigen::Map<const Vec3>(f.data() + 3 * s.local().block[static_cast<size_t>(held.node)]);
  out.friction = sum.dot(pull);
  out.normal = -sum.z();
  out.aside = sum.dot(Vec3::UnitZ().cross(pull));
  return out;
}

TEST(DrawnLines, SupportsBearFrictionTimesForce) {
  for (const auto& [theta, way] :
       {std::pair(M_PI / 2, M_PI / 2), {M_PI / 2, 0.0}, {M_PI / 2, 0.7}, {0.6, 0.6}, {0.6, 2.0}})
    for (const int elements : {8, 9}) {
      const Drawn d = draw(theta, way, elements);
      printf(
          "  crossing at %2.0f deg, drawn at %3.0f deg, %d elements: %.3f N under %.3f N, ratio %.5f, aside "
          "%.5f; %.1f "
          "iterations a step\n",
          theta * 180 / M_PI, way * 180 / M_PI, elements, d.friction, d.normal, d.friction / d.normal,
          d.aside / d.normal, d.iterations / static_cast<double>(d.steps));
      EXPECT_NEAR(d.friction / d.normal, kMu, 0.005 * kMu);
      EXPECT_NEAR(d.aside / d.normal, 0, 0.01 * kMu);
      EXPECT_GT(d.normal, 50);
    }
}

}  // namespace
}  // namespace hawser::test::line_pairs_pull_test
