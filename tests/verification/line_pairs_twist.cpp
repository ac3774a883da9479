// Two strands twisted into a double helix: contact all along, under a small angle. Schemes with one contact
// point a pair of elements fail here.
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_twist_test {
namespace {

// Meier, Popp & Wall (2016), "A finite element approach for the line-to-line contact interaction of thin
// beams with arbitrary orientation", CMAME 308, section 6.2; numbers of 4C's test
// beam3eb_static_contact_penalty_ linpen_limitdispperiter_twobeamstwisting: strands of radius 10 mm, 5 m
// long, axes 19 mm apart, one end drawn by 49.647 mm and turned once round. Then both are helices of
// radius 9.5 mm stretched by 1 %, T = EA 0.01, curvature kappa, tortuosity tau, and the pressure kappa (T +
// EI tau²) = 46.845 N/m is what 1 mm of penetration makes.
TEST(TwistedStrands, RadiusAndPressureOfTheHelix) {
  const double radius = 0.01, offset = 0.0095, length = 5, shift = 0.049647222609833896,
               k = 46845.27980953355;
  for (const int elements : {25, 50}) {
    model::Case c;
    c.environment.gravity = 0;
    model::LineType strand = beam_type(1e9 * 3.1415926535897938e-4, 1e9 * 7.853981633974484e-9, 0.1);
    strand.contact_diameter = 2 * radius;
    c.line_types = {strand};
    model::Body jaw;
    jaw.name = "jaw";
    jaw.position = Vec3(0, 0, length);
    model::TableMotion m;
    for (int i = 0; i <= 10; ++i) {
      const double t = 0.5 * i;
      m.time.push_back(t);
      m.offset.push_back({0, 0, shift * std::min(t, 1.0)});
      m.rotation.push_back({0, 0, 2 * M_PI * std::max(t - 1, 0.0) / 4});
    }
    jaw.motion = m;
    c.bodies = {jaw};
    for (const double side : {1.0, -1.0}) {
      model::End b;
      b.kind = model::EndKind::body, b.body = "jaw", b.at = Vec3(side * offset, 0, 0);
      c.lines.push_back(straight_line(side > 0 ? "first" : "second", "beam", length, elements,
                                      anchor({side * offset, 0, 0}), b));
    }
    touch(c, k, 1e-6);
    Simulation s(PETSC_COMM_WORLD, c);
    int its = 0, steps = 0, most = 0;
    double time = 0, step = 0.25;
    while (time < 5) {
      const State last = s.state();
      const double next = std::min(time + step, time < 1 ? 1.0 : 5.0);
      s.state().time = next;
      // Ends of the coming step, the rest carried along: what a predictor would do is left to Newton.
      try {
        // newton() holds supports where they are: they are moved first.
        std::vector<double> u(3 * static_cast<size_t>(s.local().blocks()), 0);
        s.system().supports().increments(last, next, u.data());
        // Turn and stretch everything with the jaw, in proportion.
        for (int n = 0; n < s.local().nodes(); ++n) {
          const size_t i = static_cast<size_t>(n);
          const double part = last.x[i].z() / (length + shift);
          const double angle = part * 2 * M_PI * (std::max(next - 1, 0.0) - std::max(time - 1, 0.0)) / 4;
          const Quat turn = exp_so3(Vec3(0, 0, angle));
          Vec3 to = turn * last.x[i];
          to.z() += part * shift * (std::min(next, 1.0) - std::min(time, 1.0));
          double* p = u.data() + 3 * s.local().block[i];
          const bool held = s.system().supports().held()[static_cast<size_t>(s.local().block[i])];
          if (!held) Eigen::Map<Vec3>(p, 3) = to - last.x[i];
          if (!held) Eigen::Map<Vec3>(p + 3, 3) = log_so3(last.q[i].conjugate() * turn * last.q[i]);
        }
        retract(s.local(), last, u.data(), s.state());
        s.state().time = next;
        const int n = settle(s, 1e-9);
        s.system().prepare(last.view(0), 0);  // Newton from too far may take strands through each other
        if (!s.system().covers(s.state().view(0))) throw std::runtime_error("through each other");
        its += n, ++steps, most = std::max(most, n);
        time = next;
        step = std::min(2 * step, 0.25);
      } catch (const std::runtime_error&) {
        s.state() = last;
        step *= 0.5;
        if (step < 1e-3) FAIL() << "no equilibrium at " << time;
      }
    }
    s.system().commit(s.state().view(0));
    FieldRegistry registry;
    registry = s.system().fields();
    std::vector<double> force(static_cast<size_t>(s.local().owned));
    for (const FieldSource& f : registry.sources())
      if (f.name == "line_contact_normal_force") f.fill(s.state().view(0), force);
    double worst_radius = 0, worst_force = 0, mean = 0;
    int interior = 0;
    for (int n = 0; n < s.local().owned; ++n) {
      const Node& node = s.mesh().nodes[static_cast<size_t>(n)];
      if (node.arc < 0.9 || node.arc > length - 0.9) continue;
      const Vec3& x = s.state().x[static_cast<size_t>(n)];
      worst_radius = std::max(worst_radius, std::abs(std::hypot(x.x(), x.y()) - offset));
      const double f = force[static_cast<size_t>(n)] / node.tributary;
      mean += f, ++interior;
      worst_force = std::max(worst_force, std::abs(f / 46.845279809533594 - 1));
    }
    mean /= interior;
    const int middle = s.mesh().nearest_node(0, length / 2);
    const Vec3 moved = s.state().x[static_cast<size_t>(middle)] - Vec3(offset, 0, length / 2);
    printf(
        "  %d elements: radius within %.1e m, pressure %.4f N/m (46.8453), nodes within %.2f %%, middle "
        "(%.6f, %.6f, "
        "%.6f); %d steps, %.1f iterations each, at most %d\n",
        elements, worst_radius, mean, 100 * worst_force, moved.x(), moved.y(), moved.z(), steps,
        its / static_cast<double>(steps), most);
    EXPECT_LT(worst_radius, 1e-5);
    // Chords of a helix: the error falls with the square of the element.
    const double tolerance = elements == 50 ? 0.005 : 0.012;
    EXPECT_NEAR(mean, 46.845279809533594, tolerance * 46.845279809533594);
    EXPECT_LT(worst_force, tolerance);
    if (elements % 2 == 0) {  // 4C's own answer
      EXPECT_NEAR(moved.x(), -0.01900423593621074, 2e-5);
      EXPECT_NEAR(moved.z(), 0.02482361130491732, 2e-5);
    }
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs_twist_test
