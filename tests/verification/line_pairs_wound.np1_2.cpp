// A rope with bending stiffness wound once round a thick line, at several pitch angles: statics finds its
// shape, and when it is drawn the ratio of its end tensions is that of friction at its surface.
#include "verification/contact_rig.hpp"
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_wound_test {
namespace {

constexpr double kPost = 0.5, kRope = 0.01, kLoad = 1000, kTurn = 2 * M_PI, kMu = 0.3;  // m, m, N

// Reference, a helix of curvature c and length s. Friction t acts on the rope's underside, r from its axis.
// The rope's moment is constant where its curvature is, so the couple t r per length is balanced by shear, -t
// r. So dT/ds = t - t r c, the normal force is T c - r dt/ds, and T grows as exp(g s) with g (1 + mu r g) =
// mu c (1 - r c). A thin rope has exp(mu c s); on a circle this is exp(mu theta).
double tension_ratio(double pitch) {
  const double c = std::pow(std::cos(pitch), 2) / (kPost + kRope);
  const double s = kTurn * (kPost + kRope) / std::cos(pitch);
  const double m = kMu * kRope;
  const double g = (std::sqrt(1 + 4 * m * kMu * c * (1 - kRope * c)) - 1) / (2 * m);
  return std::exp(g * s);
}

double over_ranks(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}

struct Wound {
  double ratio = 0, spread = 0;  // of T2/T1 over the last part of the run
  double depth = 0, audit = 0;   // m; energy error over the work brought in
  double turned = 0;             // rad, wrap angle at rest
  double iterations = 0;         // per step
  int statics = 0, relaxation = 0;
};

// Straight legs along the tangents of the helix: a dead load pulls the first, a hook draws the other.
Wound wind(double pitch, double duration) {
  const double r = kPost + kRope;
  const double c = std::cos(pitch);
  const double rise = std::sin(pitch);
  const auto at = [&](double a) { return Vec3(on_circle(r, a) + Vec3(0, r * a * rise / c, 0)); };
  const auto along = [&](double a) { return Vec3(c * along_circle(a) + Vec3(0, rise, 0)); };
  std::vector<Vec3> path{at(0) - along(0)};
  for (int i = 0; i <= 200; ++i) path.push_back(at(kTurn * i / 200));
  path.push_back(path.back() + 0.5 * along(kTurn));
  const double length = path_length(path);
  const double high = at(kTurn).y();
  const int elements = static_cast<int>(std::ceil(20 * length));

  model::LineType rope = beam_type(1e7, 1, 1);
  model::LineType post = beam_type(1e11, 1e10, 1e10);
  rope.name = "rope";
  post.name = "post";
  rope.outer_diameter = rope.contact_diameter = 2 * kRope;
  post.outer_diameter = post.contact_diameter = 2 * kPost;
  rope.mass_per_length = 1;
  post.mass_per_length = 1000;
  rope.stiffness_damping = 1e-3;
  model::Case m;
  m.environment.gravity = 0;
  m.line_types = {rope, post};
  model::Body hook;
  hook.name = "hook";
  hook.position = path.back();
  hook.ramp = 0.2;
  hook.motion = model::ConstantMotion{0.05 * along(kTurn), Vec3::UnitZ(), 0};
  m.bodies = {hook};
  model::End held;
  held.kind = model::EndKind::body;
  held.carrier = "hook";
  m.lines = {straight_line("rope", "rope", length, elements, {}, held),
             straight_line("post", "post", high + 4, 8, clamp({0, -2, 0}, Vec3::UnitY()),
                           clamp({0, high + 2, 0}, Vec3::UnitY()))};
  m.lines[0].start = model::Start::points;
  m.lines[0].points = path;
  const double h = length / elements;
  m.lines[0].loads.push_back({-kLoad / h * along(0), 0, h, 0, 0});
  touch(m, 4e6, 5e-4, kMu, 2e-3);
  m.contact.between_lines.general.relative_damping = 0.1;
  m.dynamics.enabled = true;
  m.dynamics.step = 0.01;
  m.dynamics.duration = duration;

  Simulation s(PETSC_COMM_WORLD, m);
  const StaticsReport rest = s.solve_statics();
  Wound out;
  out.statics = rest.iterations;
  out.relaxation = rest.relaxation_steps;
  const LocalMesh& l = s.local();
  double turned = 0;
  for (const LocalElement& e : l.elements) {
    if (!e.counted || s.mesh().element(static_cast<size_t>(e.global)).line != 0) continue;
    const Vec3& a = s.state().x[static_cast<size_t>(e.first)];
    const Vec3& b = s.state().x[static_cast<size_t>(e.second)];
    turned += std::remainder(std::atan2(b.z(), b.x()) - std::atan2(a.z(), a.x()), 2 * M_PI);
  }
  out.turned = over_ranks(turned);

  Dynamics& d = s.dynamics();
  d.start(s.state());
  const int end = l.find(s.mesh().lines[0].nodes - 1);
  const bool here = end >= 0 && end < l.owned;
  const Energy before = s.system().energy(d.committed_kinematics());
  Samples ratio;
  int steps = 0, iterations = 0;
  d.run(
      duration, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        ++steps;
        iterations += i.iterations;
        if (i.time < 0.6 * duration || !here) return true;
        const double* f = d.reactions().data() + 3 * l.block[static_cast<size_t>(end)];
        ratio.add(Vec3(f[0], f[1], f[2]).norm() / kLoad, i.h);
        return true;
      });
  out.ratio = over_ranks(here ? ratio.mean() : 0);
  out.spread = over_ranks(here ? ratio.rms() : 0);
  out.iterations = static_cast<double>(iterations) / steps;
  const Energy after = s.system().energy(d.committed_kinematics());
  const double brought = over_ranks(after.work + d.support_work() - (after.potential - before.potential));
  out.audit = over_ranks(after.kinetic + after.strain - before.kinetic - before.strain + after.friction +
                         after.damping) /
                  brought -
              1;
  const double depth = s.line_pairs()->deepest().depth;
  MPI_Allreduce(&depth, &out.depth, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  return out;
}

class WoundRope : public ::testing::TestWithParam<double> {};

TEST_P(WoundRope, LiesAndSlidesAtAnyPitch) {
  const double pitch = GetParam() * M_PI / 180;
  const Wound w = wind(pitch, 0.8);
  const double exact = tension_ratio(pitch);
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  if (rank == 0)
    std::printf(
        "wound at %2.0f deg: statics %d iterations, %.2f rad round the post; T2/T1 %.4f, exact %.4f (%+.3f "
        "%%), "
        "rms %.3f %%, %.1f iterations a step, penetration %.2g m, energy not accounted for %.4f %%\n",
        GetParam(), w.statics, w.turned, w.ratio, exact, 100 * (w.ratio / exact - 1), 100 * w.spread / exact,
        w.iterations, w.depth, 100 * w.audit);
  EXPECT_EQ(w.relaxation, 0);
  EXPECT_LT(w.statics, 80);
  EXPECT_GT(w.turned, kTurn);  // the legs add to the wrap angle
  EXPECT_NEAR(w.ratio, exact, 0.005 * exact);
  EXPECT_LT(w.spread, 0.005 * exact);
  EXPECT_LT(w.iterations, 5);
  EXPECT_LT(w.depth, 0.02 * kRope + kLoad * exact / (kPost * 4e6));
  EXPECT_LT(std::abs(w.audit), 1e-3);
}
INSTANTIATE_TEST_SUITE_P(Pitch, WoundRope, ::testing::Values(3, 10, 20, 30));

}  // namespace
}  // namespace hawser::test::line_pairs_wound_test
