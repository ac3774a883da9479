// Lines pinned to each other at joints: the delta line of MAP++'s test, and a beam with cables; the same at
// rest and in motion on any number of ranks.
#include "support/rig.hpp"

namespace hawser::test::joints {
namespace {

model::End at_joint(const model::Case& c) {
  model::End e;
  e.kind = model::EndKind::joint;
  e.carrier = c.joints[0].name;
  e.at = c.joints[0].start;
  return e;
}

// Force [N] of the support on an end of a line (the share of this rank, to be summed).
Vec3 reaction(Simulation& sim, size_t line, bool last) {
  const LineSpan& span = sim.mesh().lines[line];
  const int n = sim.local().find(span.first_node + (last ? span.nodes - 1 : 0));
  Vec3 f = Vec3::Zero();
  if (n >= 0 && n < sim.local().owned)
    f = Eigen::Map<const Vec3>(sim.system().reactions().data() +
                               3 * sim.local().block[static_cast<size_t>(n)]);
  MPI_Allreduce(MPI_IN_PLACE, f.data(), 3, MPI_DOUBLE, MPI_SUM, sim.system().comm());
  return f;
}

Vec3 place(Simulation& sim, size_t line, bool last) {
  const LineSpan& span = sim.mesh().lines[line];
  const int n = sim.local().find(span.first_node + (last ? span.nodes - 1 : 0));
  Vec3 x = Vec3::Zero();
  if (n >= 0 && n < sim.local().owned) x = sim.state().x[static_cast<size_t>(n)];
  MPI_Allreduce(MPI_IN_PLACE, x.data(), 3, MPI_DOUBLE, MPI_SUM, sim.system().comm());
  return x;
}

// Leg 1 of NREL_test of MAP++ (fhioki/map, NREL_test.sum.map): lines lighter than water, from an anchor to a
// delta.
model::Case delta() {
  model::Case c;
  c.environment.gravity = 9.81;
  c.environment.water.present = true;
  c.joints.push_back({"delta", {30.9, 0, -80}});
  for (const double mass : {43.5, 3.8}) {
    model::LineType t = cable_type(96.7e6, mass);
    t.name = mass > 10 ? "leg" : "bridle";
    t.outer_diameter = t.contact_diameter = 0.285;
    c.line_types.push_back(t);
  }
  model::Body b;
  b.name = "platform";
  model::HarmonicMotion m;
  m.amplitude = Vec3(0.5, 0.3, 1);
  m.period = 8;
  b.motion = m;
  b.ramp = 4;
  c.bodies.push_back(b);
  model::Line leg;
  leg.name = "leg";
  leg.sections = {{"leg", 424.4, 60, 1}};
  leg.end_a = anchor({445, 0, -200});
  leg.end_b = at_joint(c);
  c.lines.push_back(leg);
  for (const double y : {-4.5, 4.5}) {
    model::Line l;
    l.name = y < 0 ? "port" : "starboard";
    l.sections = {{"bridle", 30, 20, 1}};
    l.end_a = at_joint(c);
    l.end_b.kind = model::EndKind::body;
    l.end_b.carrier = "platform";
    l.end_b.at = Vec3(2.6, y, -70);
    c.lines.push_back(l);
  }
  c.contact.between_lines.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 4;
  c.dynamics.step = 0.1;
  return c;
}

TEST(Joints, DeltaLineOfMap) {
  const model::Case c = delta();
  Simulation sim(PETSC_COMM_WORLD, c);
  const StaticsReport report = sim.solve_statics();
  const Vec3 node = place(sim, 0, true);
  const Vec3 A = reaction(sim, 0, false);
  const Vec3 B = reaction(sim, 1, true);
  const Vec3 C = reaction(sim, 2, true);
  const Vec3 exact(31.583396712889662, 0, -77.37019188090699);
  printf("  %d iterations, joint %.2f mm off, H %+.4f %%, V at the anchor %+.4f %%, bridle %+.4f %%\n",
         report.iterations, 1e3 * (node - exact).norm(), 100 * (std::abs(A.x()) / 1501931.2036468408 - 1),
         100 * (std::abs(A.z()) / 491199.8738785506 - 1), 100 * (B.head<2>().norm() / 759963.1167927461 - 1));
  EXPECT_LT((node - exact).norm(), 5e-3);
  EXPECT_LT((place(sim, 1, false) - node).norm() + (place(sim, 2, false) - node).norm(), 1e-9);
  EXPECT_NEAR(std::abs(A.x()), 1501931.2036, 1e-3 * 1501931);
  EXPECT_NEAR(std::abs(A.z()), 491199.8739, 1e-3 * 491200);
  EXPECT_NEAR(B.head<2>().norm(), 759963.1168, 1e-3 * 759963);
  // Vertical force of the leg on the joint; both bridles carry it less their own buoyancy.
  const double lift = (1025 * M_PI / 4 * 0.285 * 0.285 - 3.8) * 9.81 * 30;
  EXPECT_NEAR(std::abs(B.z() + C.z()), 400068.769 - 2 * lift, 1e-3 * 400069);
  EXPECT_LT(report.iterations, 60);
}

TEST(Joints, TheSameOnAnyNumberOfRanksInMotion) {
  const model::Case c = delta();
  Simulation all(PETSC_COMM_WORLD, c);
  Simulation one(PETSC_COMM_SELF, c);
  double off = 0;
  for (Simulation* s : {&all, &one}) {
    s->solve_statics();
    s->dynamics().start(s->state());
    s->dynamics().run(
        4, [](double) { return 4.0; }, [](const StepInfo&) { return true; });
  }
  const Kinematics a = all.dynamics().committed_kinematics();
  const Kinematics b = one.dynamics().committed_kinematics();
  for (int n = 0; n < all.local().owned; ++n)
    off = std::max(off, (a.x[static_cast<size_t>(n)] -
                         b.x[static_cast<size_t>(all.local().global[static_cast<size_t>(n)])])
                            .norm());
  MPI_Allreduce(MPI_IN_PLACE, &off, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  EXPECT_LT(off, 1e-6);
  const size_t leg = static_cast<size_t>(one.mesh().lines[0].nodes - 1);
  const size_t port = static_cast<size_t>(one.mesh().lines[1].first_node);
  EXPECT_LT((b.x[leg] - b.x[port]).norm(), 1e-9);
  EXPECT_GT((b.x[leg] - c.joints[0].start).norm(), 0.1);
  printf("  %.1e m apart after 4 s\n", off);
}

// A pipe hangs in two slings at one end and a third support at the other: the anchors carry the whole weight,
// and the end of the pipe can rotate.
TEST(Joints, APipeInSlings) {
  model::Case c;
  c.environment.gravity = 9.80665;
  c.joints.push_back({"hook", {0, 0, -8}});
  c.line_types = {beam_type(1e8, 1e6, 1e6, 100), cable_type(1e7, 5)};
  model::Line pipe;
  pipe.name = "pipe";
  pipe.sections = {{"beam", 20, 20, 1}};
  pipe.end_a = at_joint(c);
  pipe.end_b = anchor({18, 0, -10});
  c.lines.push_back(pipe);
  for (const double y : {-4.0, 4.0}) {
    model::Line l;
    l.name = y < 0 ? "left" : "right";
    l.sections = {{"cable", 9, 9, 1}};
    l.end_a = anchor({-2, y, 0});
    l.end_b = at_joint(c);
    c.lines.push_back(l);
  }
  c.contact.between_lines.enabled = false;
  c.dynamics.enabled = false;
  Simulation sim(PETSC_COMM_WORLD, c);
  const StaticsReport report = sim.solve_statics();
  const Vec3 sum = reaction(sim, 0, true) + reaction(sim, 1, false) + reaction(sim, 2, false);
  printf("  %d iterations\n", report.iterations);
  const double weight = (20 * 100 + 2 * 9 * 5) * 9.80665;
  EXPECT_LT((sum.cwiseAbs() - Vec3(0, 0, weight)).norm(), 1e-5 * weight);
  EXPECT_LT((place(sim, 0, false) - place(sim, 1, true)).norm() +
                (place(sim, 0, false) - place(sim, 2, true)).norm(),
            1e-9);
  EXPECT_NEAR(place(sim, 0, false).y(), 0, 1e-6);
}

}  // namespace
}  // namespace hawser::test::joints
