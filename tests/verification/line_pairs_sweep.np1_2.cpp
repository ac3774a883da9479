// A rope is drawn over a taut wire, so that their crossing moves along one of them over elements and nodes.
// Friction is mu times the normal force in every step of any length, and the energy balance with its work
// closes.
#include <fmt/format.h>

#include "verification/contact_rig.hpp"
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_sweep_test {
namespace {

double over_ranks(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}

struct Swept {
  Samples ratio;     // friction over normal force at the ends of steps, once the rope slides
  double audit = 0;  // error of the energy balance, over the work brought in
  double depth = 0;  // m
  double way = 0;    // m, mean displacement of the crossing along the wire in a step
  int steps = 0;
};

// light: a rope three times as thick as the wire with little contact force. lengthwise: drawn along its own
// axis.
enum class Kind { beams, cables, light, lengthwise };
constexpr const char* kNames[] = {"beams", "cables", "thick and light", "lengthwise"};

// Both ends of the rope move with a frame along the wire, or along the rope, at 0.5 m/s. step 0: automatic.
Swept sweep(Kind kind, double mu, double step) {
  constexpr double kSpeed = 0.5, kDuration = 4, kSlides = 1;  // m/s, s, s
  const bool cables = kind == Kind::cables;
  const bool light = kind == Kind::light;
  const bool lengthwise = kind == Kind::lengthwise;
  model::LineType wire = cables ? cable_type(1e8, 20) : beam_type(1e8, 5e3, 5e3, 20);
  model::LineType rope = cables ? cable_type(1e6, 8) : beam_type(1e6, 2e2, 2e2, 8);
  wire.name = "wire";
  rope.name = "rope";
  wire.outer_diameter = wire.contact_diameter = 0.06;
  rope.outer_diameter = rope.contact_diameter = 0.1;
  if (light) {
    rope = beam_type(2e4, 2e2, 2e2, 2);
    rope.name = "rope";
    wire.outer_diameter = wire.contact_diameter = 0.1;
    rope.outer_diameter = rope.contact_diameter = 0.3;
  }
  model::Case m;
  m.environment.gravity = 0;
  m.line_types = {wire, rope};
  model::Body frame;
  frame.name = "frame";
  frame.ramp = 0.5;
  frame.position = lengthwise ? Vec3(0.2, -0.7, 0) : Vec3(-1.3, 0, 0);
  frame.motion =
      model::ConstantMotion{kSpeed * (lengthwise ? Vec3::UnitY() : Vec3::UnitX()), Vec3::UnitZ(), 0};
  m.bodies = {frame};
  model::End a, b;
  a.kind = b.kind = model::EndKind::body;
  a.carrier = b.carrier = "frame";
  a.at = Vec3(0, -3, -0.3);
  b.at = Vec3(0, 3, -0.3);
  m.lines = {straight_line("wire", "wire", 11.985, 24, anchor({-6, 0, 0}), anchor({6, 0, 0})),
             straight_line("rope", "rope", 6, 12, a, b)};
  m.lines[1].start = model::Start::points;
  m.lines[1].points = {frame.position + a.at,
                       {frame.position.x(), 0, wire.outer_diameter / 2 + rope.outer_diameter / 2},
                       frame.position + b.at};
  if (light) touch(m, 3e8, 1e-5);
  m.contact.between_lines.general.friction = mu;
  m.dynamics.enabled = true;
  m.dynamics.step = step;
  m.dynamics.duration = kDuration;

  Simulation s(PETSC_COMM_WORLD, m);
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const Energy before = s.system().energy(d.committed_kinematics());
  Swept out;
  d.run(
      kDuration, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        ++out.steps;
        const double friction = over_ranks(s.line_pairs()->friction_force());
        const double normal = over_ranks(s.line_pairs()->normal_force());
        if (i.time > kSlides) out.ratio.add(friction / normal, i.h);
        return true;
      });
  const double depth = s.line_pairs()->deepest().depth;
  MPI_Allreduce(&depth, &out.depth, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  out.way = kSpeed * kDuration / out.steps;
  const Energy after = s.system().energy(d.committed_kinematics());
  const double brought = over_ranks(after.work - before.work + d.support_work());
  out.audit = over_ranks(after.kinetic + after.strain - before.kinetic - before.strain + after.friction +
                         after.damping) /
                  brought -
              1;
  return out;
}

class SweptCrossing : public ::testing::TestWithParam<std::tuple<Kind, double, double>> {};

TEST_P(SweptCrossing, RubsAtAnyStep) {
  const auto [kind, mu, step] = GetParam();
  const Swept r = sweep(kind, mu, step);
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  if (rank == 0)
    std::printf(
        "  %s, mu %.1f, %s: %d steps, %.0f mm each; friction/N mean %.5f, least %.5f, most %.5f; energy not "
        "accounted for %+.3f %%, penetration %.2g m\n",
        kNames[static_cast<int>(kind)], mu, step > 0 ? fmt::format("{} s", step).c_str() : "automatic",
        r.steps, 1e3 * r.way, r.ratio.mean(), r.ratio.least, r.ratio.most, 100 * r.audit, r.depth);
  EXPECT_NEAR(r.ratio.mean(), mu, 0.02 * mu);
  EXPECT_GT(r.ratio.least, 0.97 * mu);
  EXPECT_LT(r.ratio.most, 1.03 * mu);
  EXPECT_LT(std::abs(r.audit), 0.01);
}
INSTANTIATE_TEST_SUITE_P(Steps, SweptCrossing,
                         ::testing::Combine(::testing::Values(Kind::beams, Kind::cables, Kind::light,
                                                              Kind::lengthwise),
                                            ::testing::Values(0.2, 0.3), ::testing::Values(0.2, 0.02, 0.0)));

}  // namespace
}  // namespace hawser::test::line_pairs_sweep_test
