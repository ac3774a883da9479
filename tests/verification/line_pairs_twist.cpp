// Two strands twisted into a double helix: contact along the whole length at a small angle. Methods with one
// contact point per pair of elements fail here.
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_twist_test {
namespace {

// Meier, Popp & Wall (2016), "A finite element approach for the line-to-line contact interaction of thin
// beams with arbitrary orientation", CMAME 308, section 6.2; data of 4C's test
// beam3eb_static_contact_penalty_linpen_limitdispperiter_twobeamstwisting: strands of radius 10 mm, 5 m long,
// axes 19 mm apart, one end drawn by 49.647 mm within the first second and rotated by one turn in the next
// four. Then both are helices of radius 9.5 mm with a strain of 1 %, T = EA 0.01, curvature kappa, tortuosity
// tau; the pressure kappa (T + EI tau²) = 46.845 N/m is that of 1 mm of penetration.
constexpr double kOffset = 0.0095, kLength = 5, kShift = 0.049647222609833896;

model::Case strands(int elements) {
  const double radius = 0.01, k = 46845.27980953355;
  model::Case c;
  c.environment.gravity = 0;
  model::LineType strand = beam_type(1e9 * 3.1415926535897938e-4, 1e9 * 7.853981633974484e-9, 0.1);
  strand.contact_diameter = 2 * radius;
  c.line_types = {strand};
  model::Body jaw;
  jaw.name = "jaw";
  jaw.position = Vec3(0, 0, kLength);
  model::TableMotion m;
  for (int i = 0; i <= 10; ++i) {
    const double t = 0.5 * i;
    m.time.push_back(t);
    m.offset.push_back({0, 0, kShift * std::min(t, 1.0)});
    m.rotation.push_back({0, 0, 2 * M_PI * std::max(t - 1, 0.0) / 4});
  }
  jaw.motion = m;
  c.bodies = {jaw};
  for (const double side : {1.0, -1.0}) {
    model::End b;
    b.kind = model::EndKind::body;
    b.carrier = "jaw";
    b.at = Vec3(side * kOffset, 0, 0);
    c.lines.push_back(straight_line(side > 0 ? "first" : "second", "beam", kLength, elements,
                                    anchor({side * kOffset, 0, 0}), b));
  }
  touch(c, k, 1e-6);
  return c;
}

// Moves the ends to their positions at another time and stretches and rotates the nodes between them in
// proportion, as an initial guess for Newton.
void carry(Simulation& s, const State& last, double next) {
  const double time = last.time;
  s.state().time = next;
  std::vector<double> u(3 * static_cast<size_t>(s.local().blocks()), 0);
  s.system().tied_nodes().increments(last, next, u.data());
  for (int n = 0; n < s.local().nodes(); ++n) {
    const size_t i = static_cast<size_t>(n);
    if (s.system().tied_nodes().held()[static_cast<size_t>(s.local().block[i])]) continue;
    const double part = last.x[i].z() / (kLength + kShift);
    const double angle = part * 2 * M_PI * (std::max(next - 1, 0.0) - std::max(time - 1, 0.0)) / 4;
    const Quat turn = exp_so3(Vec3(0, 0, angle));
    Vec3 to = turn * last.x[i];
    to.z() += part * kShift * (std::min(next, 1.0) - std::min(time, 1.0));
    double* p = u.data() + 3 * s.local().block[i];
    Eigen::Map<Vec3>(p, 3) = to - last.x[i];
    Eigen::Map<Vec3>(p + 3, 3) = log_so3(last.q[i].conjugate() * turn * last.q[i]);
  }
  retract(s.local(), last, u.data(), s.state());
  s.state().time = next;
}

struct Steps {
  int its = 0, steps = 0, most = 0;
};

// Solves from the straight strands to the end of the rotation.
Steps twist(Simulation& s) {
  Steps done;
  double step = 0.25;
  s.state().time = 0;
  while (s.state().time < 5) {
    const State last = s.state();
    try {
      carry(s, last, std::min(last.time + step, last.time < 1 ? 1.0 : 5.0));
      const int n = settle(s, 1e-9);
      s.system().prepare(last.at_rest(), 0);  // the step may have taken the strands through each other
      if (!s.system().check_step(s.state().at_rest()).accepted())
        throw std::runtime_error("through each other");
      done.its += n;
      ++done.steps;
      done.most = std::max(done.most, n);
      step = std::min(2 * step, 0.25);
    } catch (const std::runtime_error&) {
      s.state() = last;
      step *= 0.5;
      if (step < 1e-3) throw;
    }
  }
  return done;
}

// Newton's residuals from a start rotated by `step` less than the equilibrium at `state`.
std::vector<double> residuals_of(Simulation& s, const State& state, double step) {
  s.state() = state;
  std::vector<double> residuals;
  carry(s, state, state.time - step);
  settle(s, 1e-9, &residuals);
  s.state() = state;
  return residuals;
}

TEST(TwistedStrands, RadiusAndPressureOfTheHelix) {
  for (const int elements : {25, 50}) {
    const model::Case c = strands(elements);
    Simulation s(PETSC_COMM_WORLD, c);
    const Steps done = twist(s);
    s.system().commit(s.state().at_rest());
    FieldRegistry registry;
    registry = s.system().fields();
    std::vector<double> force(static_cast<size_t>(s.local().owned));
    for (const FieldSource& f : registry.sources())
      if (f.name == "line_contact_normal_force") f.fill(s.state().at_rest(), force);
    double worst_radius = 0, worst_force = 0, mean = 0;
    int interior = 0;
    for (int n = 0; n < s.local().owned; ++n) {
      const Node& node = s.mesh().node(static_cast<size_t>(n));
      if (node.arc < 0.9 || node.arc > kLength - 0.9) continue;
      const Vec3& x = s.state().x[static_cast<size_t>(n)];
      worst_radius = std::max(worst_radius, std::abs(std::hypot(x.x(), x.y()) - kOffset));
      const double f = force[static_cast<size_t>(n)] / node.tributary;
      mean += f;
      ++interior;
      worst_force = std::max(worst_force, std::abs(f / 46.845279809533594 - 1));
    }
    mean /= interior;
    const int middle = s.mesh().nearest_node(0, kLength / 2);
    const Vec3 moved = s.state().x[static_cast<size_t>(middle)] - Vec3(kOffset, 0, kLength / 2);
    printf(
        "  %d elements: radius within %.1e m, pressure %.4f N/m (46.8453), nodes within %.2f %%, middle "
        "(%.6f, %.6f, "
        "%.6f); %d steps, %.1f iterations each, at most %d\n",
        elements, worst_radius, mean, 100 * worst_force, moved.x(), moved.y(), moved.z(), done.steps,
        done.its / static_cast<double>(done.steps), done.most);
    EXPECT_LT(worst_radius, 1e-5);
    // The line is a polygon along the helix: the error falls with the square of the element length.
    const double tolerance = elements == 50 ? 0.005 : 0.012;
    EXPECT_NEAR(mean, 46.845279809533594, tolerance * 46.845279809533594);
    EXPECT_LT(worst_force, tolerance);
    if (elements % 2 == 0) {  // result of 4C
      EXPECT_NEAR(moved.x(), -0.01900423593621074, 2e-5);
      EXPECT_NEAR(moved.z(), 0.02482361130491732, 2e-5);
    }
  }
}

// The tangent is exact. Residuals are relative to the tension of the strands, 3142 N at every node, but
// bending and contact forces are only 9 N a node, so the residuals of a normal step show little of the order
// of convergence. Therefore starts at different distances are compared: halving the distance divides the
// residual after one iteration by 4, after two by 16, after three by 256. With an error in the tangent the
// factor would be 2.
TEST(TwistedStrands, LastIterationsAreQuadratic) {
  for (const int elements : {25, 50}) {
    const model::Case c = strands(elements);
    Simulation s(PETSC_COMM_WORLD, c);
    twist(s);
    const State end = s.state();
    std::vector<double> last;
    for (const double step : {1.0 / 4, 1.0 / 8, 1.0 / 16, 1.0 / 32, 1.0 / 64}) {
      const std::vector<double> r = residuals_of(s, end, step);
      printf("  %d elements, from 1/%.0f s away:", elements, 1 / step);
      for (const double x : r) printf(" %.1e", x);
      printf("\n");
      for (size_t k = 1; k <= 3 && !last.empty(); ++k) {
        if (r.size() <= k || r[k] < 1e-10) continue;  // round-off
        const double falls = std::pow(2, std::pow(2, static_cast<double>(k)));
        EXPECT_GT(last[k] / r[k], 0.6 * falls) << step << ", iteration " << k;
      }
      last = r;
    }
    EXPECT_LT(newton_square(last), 10);  // the limit for crossing lines
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs_twist_test
