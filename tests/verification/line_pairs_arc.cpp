// A beam that rotates over an arc from across to along it, and a beam that slides up the arc's side (C12),
// against results of 4C.
#include "hawser/kernels/axis_shape.hpp"
#include "hawser/math/so3.hpp"
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_arc_test {
namespace {

// 4C's tests beam3eb_static_contact_penalty_linposquadpen_beamrotatingoverarc and _beamslidingoverarc: lines
// of radius 10 mm, E = 1e9 N/m², A = pi 1e-6 m², I = pi/4 1e-8 m⁴. The arc is one element of 3.1414 m with
// both ends held, 2 m apart and vertical, so its shape is Hermite's cubic of 0.785 m height; the other line
// has three elements and pinned ends. 4C's law begins at a gap g0 and is a parabola up to the touch, where
// its slope is the stiffness. This is the smoothing ramp of hawser with lines thicker by g0/2 and a smoothing
// of g0/2.
constexpr double kRadius = 0.01, kArc = 3.1414;

model::Case over_arc(double g0, double stiffness, const Vec3& middle, const Vec3& half, int elements,
                     const model::TableMotion& motion) {
  model::Case c;
  c.environment.gravity = 0;
  model::LineType type = beam_type(1e9 * M_PI * 1e-6, 1e9 * M_PI / 4 * 1e-8, 1e9 * M_PI / 4 * 1e-8);
  type.contact_diameter = 2 * kRadius + 0.5 * g0;
  c.line_types = {type};
  model::Body jaw;
  jaw.name = "jaw";
  jaw.position = middle;
  jaw.motion = motion;
  c.bodies = {jaw};
  model::Line arc = straight_line("arc", type.name, kArc, 1, clamp({-1, 0, 0}, Vec3::UnitZ()),
                                  clamp({1, 0, 0}, -Vec3::UnitZ()));
  arc.start = model::Start::points;
  arc.points = {{-1, 0, 0}, {1, 0, 0}};
  c.lines.push_back(arc);
  model::End a, b;
  a.kind = b.kind = model::EndKind::body;
  a.carrier = b.carrier = "jaw";
  a.at = -half;
  b.at = half;
  c.lines.push_back(straight_line("beam", type.name, 2 * half.norm(), elements, a, b));
  touch(c, stiffness, 0.5 * g0);
  return c;
}

// Follows the equilibria up to `end`. A step in which Newton fails, or lines pass through each other, is
// halved. The last iterations must be quadratic.
int follow_motion(Simulation& s, double end, double longest) {
  int most = 0;
  double step = longest;
  while (s.state().time < end * (1 - 1e-12)) {
    const State last = s.state();
    const double next = std::min(last.time + step, end);
    try {
      std::vector<double> u(3 * static_cast<size_t>(s.local().blocks()), 0);
      s.system().tied_nodes().increments(last, next, u.data());
      // Initial guess: free nodes move with the ends, interpolated linearly.
      const LineSpan& l = s.mesh().lines[1];
      const size_t a = static_cast<size_t>(l.first_node);
      const size_t b = a + static_cast<size_t>(l.nodes) - 1;
      const auto at = [&](size_t n) { return Eigen::Map<Vec3>(u.data() + 3 * s.local().block[n]); };
      const Vec3 before = (last.x[b] - last.x[a]).normalized();
      const Vec3 after = (last.x[b] + at(b) - last.x[a] - at(a)).normalized();
      const Quat turn = minimal_rotation(before, after);
      for (size_t n = a; n <= b; ++n) {
        const double part = static_cast<double>(n - a) / static_cast<double>(b - a);
        if (n > a && n < b) at(n) = (1 - part) * at(a) + part * at(b);
        Eigen::Map<Vec3>(u.data() + 3 * s.local().block[n] + 3) =
            log_so3(last.q[n].conjugate() * turn * last.q[n]);
      }
      retract(s.local(), last, u.data(), s.state());
      s.state().time = next;
      std::vector<double> residuals;
      most = std::max(most, settle(s, 1e-9, &residuals));
      if (next == end) {
        print_residuals(residuals);
        EXPECT_LT(newton_square(residuals), 10);
      }
      s.system().prepare(last.at_rest(), 0);
      if (!s.system().check_step(s.state().at_rest()).accepted())
        throw std::runtime_error("through each other");
      step = std::min(2 * step, longest);
    } catch (const std::runtime_error&) {
      s.state() = last;
      if ((step /= 2) < 1e-3 * longest) {
        ADD_FAILURE() << "no equilibrium at " << last.time;
        return most;
      }
    }
  }
  s.system().commit(s.state().at_rest());
  return most;
}

// Displacement from `from` of the node at the arc length `arc`.
Vec3 moved(Simulation& s, double arc, const Vec3& from) {
  return s.state().x[static_cast<size_t>(s.mesh().nearest_node(1, arc))] - from;
}

// The beam is lowered onto the arc, then rotated by 117 degrees. 4C: (0.3044091538, 0.4884600274,
// -0.08700063195) m. Between 10 and 30 degrees 4C blends point contact (1e5 N/m) and line contact (5e6 N/m²);
// here all is line contact.
TEST(BeamOverArc, Rotating) {
  model::TableMotion m;
  for (int i = 0; i <= 230; ++i) {
    const double t = 0.01 * i;
    m.time.push_back(t);
    m.offset.push_back({0, 0, -0.3 * std::min(t, 1.0)});
    m.rotation.push_back({0, 0, 0.5 * M_PI * std::max(t - 1, 0.0)});
  }
  double converged = 0;
  for (const int elements : {12, 6, 3}) {
    Simulation s(PETSC_COMM_WORLD, over_arc(0.005, 5e6, {0, 0, 0.85}, {0, 1, 0}, elements, m));
    const AxisShape arc({true,
                         kArc,
                         Vec3::UnitX(),
                         {-1, 0, 0},
                         {1, 0, 0},
                         {},
                         {},
                         minimal_rotation(Vec3::UnitX(), Vec3::UnitZ()),
                         minimal_rotation(Vec3::UnitX(), -Vec3::UnitZ()),
                         {},
                         {}});
    EXPECT_NEAR(arc.point(0.5).z(), kArc / 4, 1e-12);
    const int most = follow_motion(s, 2.3, 0.01);
    const Vec3 u = moved(s, 2.0 / 3, {0, -1.0 / 3, 0.85});
    const double strain = s.system().energy(s.state().at_rest()).strain;
    printf(
        "  turning over an arc, %d elements: (%.4f, %.4f, %.4f) m, strain energy and contact %.3f J, force "
        "%.1f N; at most %d iterations\n",
        elements, u.x(), u.y(), u.z(), strain, s.line_pairs()->normal_force(), most);
    EXPECT_NEAR(u.x(), 0.30441, 0.02 * 0.30441);
    EXPECT_NEAR(u.y(), 0.48846, 0.02 * 0.48846);
    // Three elements, as in 4C, are too few for the bend over the arc's top: converged, the beam is 7 % lower
    // than in 4C. From six elements on the height is constant.
    if (elements == 12) converged = u.z();
    if (elements == 3)
      EXPECT_NEAR(u.z(), -0.08700, 0.03 * 0.08700);
    else
      EXPECT_NEAR(u.z(), -0.0932, 0.003 * 0.0932);
    if (elements == 6) {
      EXPECT_NEAR(u.z(), converged, 0.002 * std::abs(converged));
    }
  }
}

// The beam is pressed against the arc from the side, then lifted to the top. 4C: (-3.552809448e-05,
// 0.01204267184, 0.4851396559) m with point contact only, 1e4 N/m.
TEST(BeamOverArc, Sliding) {
  model::TableMotion m;
  for (int i = 0; i <= 18; ++i) {
    const double t = 0.1 * i;
    m.time.push_back(t);
    m.offset.push_back({0, 0.03 * std::min(t, 1.0), 0.606 * std::max(t - 1, 0.0)});
  }
  for (const int elements : {3, 12}) {
    Simulation s(PETSC_COMM_WORLD, over_arc(0.001, 1e6, {0, -0.03, 0.3}, {2, 0, 0}, elements, m));
    const int most = follow_motion(s, 1.8, 0.1);
    const Vec3 u = moved(s, 4.0 / 3, {-2.0 / 3, -0.03, 0.3});
    printf("  sliding over an arc, %d elements: (%.2e, %.5f, %.5f) m, force %.3f N; at most %d iterations\n",
           elements, u.x(), u.y(), u.z(), s.line_pairs()->normal_force(), most);
    EXPECT_NEAR(u.y(), 0.012043, 0.05 * 0.012043);
    EXPECT_NEAR(u.z(), 0.48514, 0.02 * 0.48514);
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs_arc_test
