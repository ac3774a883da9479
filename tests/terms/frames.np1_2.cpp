// Lines and contact on bodies that move by their own equations: the tangent of a step equals finite
// differences, and the forces balance.
#include <gtest/gtest.h>

#include "hawser/run/volumes.hpp"
#include "support/step_tangent.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::frames {
namespace {

model::End on(const std::string& body, const Vec3& at) {
  model::End e;
  e.kind = model::EndKind::body;
  e.carrier = body;
  e.at = at;
  return e;
}

model::Line line(const std::string& name, const std::string& type, double length, int elements,
                 const model::End& a, const model::End& b) {
  model::Line l;
  l.name = name;
  l.sections.push_back({type, length, elements, 1});
  l.end_a = a;
  l.end_b = b;
  l.start = model::Start::straight;
  return l;
}

// A body with beams that are clamped, pinned and joined by a rotational spring to it, and with cables (one
// from the body to itself); a beam and a cable in frictional contact with it; in a current, with a second
// body beside it.
model::Case carried(model::ContactMethod method) {
  model::Case c;
  c.environment.water.present = true;
  c.environment.water.depth = 60;
  c.environment.water.current.profile = {{0, 0.8, 0.4}, {60, 0.3, 0.4}};
  c.line_types = {beam_type(3e3, 50, 30, 5), cable_type(2e3, 4)};
  c.line_types[0].stiffness_damping = c.line_types[1].stiffness_damping = 0.1;
  for (const char* name : {"buoy", "load"}) {
    model::Body& b = c.bodies.emplace_back();
    b.name = name;
    b.position = {0, 0, name[0] == 'b' ? -5.0 : -9.0};
    model::BodyMass& m = b.mass.emplace();
    m.mass = 40;
    m.inertia = {12, 15, 9};
    m.products = {1, 0.5, -0.7};
    m.centre = {0.1, -0.2, 0.15};
    m.weight = true;
    m.stiffness = {30, 20, 50};
    m.turning_stiffness = {5, 6, 7};
    m.damping = {3, 4, 5};
    model::BodyInWater& w = m.in_water.emplace();
    w.volume = 0.05;
    w.height = name[0] == 'b' ? 14 : 3;
    w.centre = {0.2, 0.1, 0.3};
    w.drag_centre = {0, -0.3, 0.2};
    w.drag_area = {0.05, 0.08, 0.03};
    w.added_mass = {20, 30, 60};
  }
  model::End clamped = on("buoy", {1, 0, 0.3});
  model::End sprung = on("buoy", {-1, 0.2, 0});
  clamped.clamped = true;
  clamped.direction = Vec3(1, 0.1, 0.2).normalized();
  sprung.rotational_stiffness = 40;
  sprung.direction = Vec3(-1, 0.3, 0.1).normalized();
  c.lines = {line("clamped", "beam", 4, 3, clamped, anchor({5, 0.4, -4})),
             line("sprung", "beam", 4, 3, sprung, anchor({-5, 0, -5})),
             line("hung", "cable", 5, 3, anchor({0.2, 0.3, 0}), on("buoy", {0, 0.1, 1})),
             line("between", "cable", 3.5, 2, on("buoy", {0, 0.2, -1}), on("load", {0.1, 0, 0.5})),
             line("loop", "cable", 1.6, 1, on("load", {0.8, 0, 0}), on("load", {-0.5, 0.6, 0})),
             line("beam beside", "beam", 4, 2, anchor({-2, 1.045, -5.1}), anchor({2, 1.04, -4.9})),
             line("cable beside", "cable", 4, 2, anchor({-2, -1.045, -5.1}), anchor({2, -1.04, -4.9}))};
  // Two beams and a cable at a rigid joint.
  c.joints = {{"corner", {8, 0, -2}, true}};
  model::End corner;
  corner.kind = model::EndKind::joint;
  corner.carrier = "corner";
  corner.at = {8, 0, -2};
  model::End arm = corner;
  arm.direction = Vec3(0.2, 1, 0.1).normalized();
  c.lines.push_back(line("leg", "beam", 3, 2, anchor({8, 0, -5}), corner));
  c.lines.push_back(line("arm", "beam", 2, 2, arm, model::End{}));
  c.lines.push_back(line("stay", "cable", 3, 2, anchor({10.5, 0, -4}), corner));
  // Ends that events release: a cable tied to a beam, and one tied to another cable.
  c.joints.push_back({"link", {-8, 0, -5}, false});
  model::End link = corner;
  link.carrier = "link";
  link.at = {-8, 0, -5};
  c.lines.push_back(line("upper", "cable", 3, 2, anchor({-8, 0, -2}), link));
  c.lines.push_back(line("lower", "cable", 2.5, 2, link, anchor({-8, 1, -7.3})));
  for (const auto& [name, end] : {std::pair("stay", LineEnd::B), std::pair("lower", LineEnd::A)}) {
    model::Event& e = c.events.emplace_back();
    e.name = name;
    e.action.line = name;
    e.action.line_end = end;
    e.cause.time = 1;
  }
  c.lines.push_back(
      line("beside the clamp", "cable", 2, 2, anchor({7, 0.64, -3.52}), anchor({9, 0.64, -3.48})));
  model::Volume v;
  v.name = "hull";
  v.body = "buoy";
  v.shape = CylinderShape{{-1.5, 0, 0}, {1.5, 0, 0}, 1};
  v.basis = model::StiffnessBasis::per_length;
  v.normal_stiffness = 2e4;
  v.smoothing = 0.01;
  v.relative_damping = 0.2;
  v.friction.axial = 0.3;
  v.friction.lateral = 0.2;
  v.friction.mobilisation_length = 0.02;
  // A clamp that is attached to the leg, off its middle and rotated.
  model::Body& clamp = c.bodies.emplace_back();
  clamp.name = "clamp";
  clamp.ride = model::Ride{"leg", 1.5};
  clamp.position = {0.05, 0.1, 0.02};
  clamp.rotation = {0.3, -0.2, 0.4};
  model::Volume collar = v;
  collar.name = "collar";
  collar.body = "clamp";
  collar.shape = SphereShape{{-0.05, -0.1, 0}, 0.6};
  c.volumes = {v, collar};
  c.contact.method = method;
  c.contact.rolling = method == model::ContactMethod::line;
  c.contact.lines = {"beam beside", "cable beside", "beside the clamp"};
  c.contact.all_lines = false;
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 1;
  c.dynamics.step = 0.02;
  return c;
}

void expect_step_tangent(model::ContactMethod method) {
  const model::Case c = carried(method);
  const auto volumes = run::load_volumes(c);
  Simulation sim(PETSC_COMM_WORLD, c, run::surfaces(volumes));
  StepTangent step = StepTangent::by_chance(sim.system(), sim.state(), 0.02, 0.01, 0.05);
  // The number of contacts is counted after an accepted step.
  step.commit();
  int all = sim.line_volume_contact()->active_count();
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  EXPECT_GE(all, method == model::ContactMethod::line ? 5 : 3);
  sim.line_volume_contact()->restore({});
  step.prepare();
  // Dampers start and stop where contact begins; this kink is always near.
  const double worst = step.worst(1e-6, 1e-5);
  printf("step tangent with bodies: error %.1e, %d places touch\n", worst, all);
  EXPECT_LT(worst, 1e-6);
}

TEST(Frames, TangentOfAStepAlongLines) { expect_step_tangent(model::ContactMethod::line); }
TEST(Frames, TangentOfAStepAtNodes) { expect_step_tangent(model::ContactMethod::nodes); }

// Two free bodies joined by a rope, without external forces: their total momentum is constant, because the
// forces of the rope on bodies and nodes are opposite.
TEST(Frames, MomentumOfTwoBodiesOnALine) {
  model::Case c;
  c.environment.gravity = 0;
  c.line_types = {cable_type(1e5, 2)};
  for (const double x : {0.0, 10.0}) {
    model::Body& b = c.bodies.emplace_back();
    b.name = x > 0 ? "second" : "first";
    b.position = {x, 0, 0};
    model::BodyMass& m = b.mass.emplace();
    m.mass = x > 0 ? 30 : 80;
    m.inertia = {12, 15, 9};
    m.centre = {0.1, -0.2, 0.15};
    m.velocity = x > 0 ? Vec3(2, 1, 0.3) : Vec3(-1, 0, 0);
    m.angular_velocity = {0.5, -0.3, 0.2};
  }
  c.lines = {line("between", "cable", 9, 9, on("first", {0.5, 0.3, 0}), on("second", {-0.4, 0, 0.2}))};
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 4;
  c.dynamics.step = 0.02;
  c.dynamics.tolerance = 1e-13;
  Simulation sim(PETSC_COMM_WORLD, c);
  Dynamics& d = sim.dynamics();
  d.start(sim.state());
  const auto momentum = [&] {
    const Kinematics k = d.committed_kinematics();
    const LocalMesh& m = sim.local();
    Vec3 p = Vec3::Zero();
    for (int n = 0; n < m.owned; ++n) {
      const Node& node = sim.mesh().node(static_cast<size_t>(m.global[static_cast<size_t>(n)]));
      if (node.body >= 0)
        p += c.bodies[static_cast<size_t>(node.body)].mass->mass * k.v[static_cast<size_t>(n)];
    }
    for (const LocalElement& e : m.elements)
      if (e.counted)
        p += 0.5 * 2 * m.mesh->element(static_cast<size_t>(e.global)).length *
             (k.v[static_cast<size_t>(e.first)] + k.v[static_cast<size_t>(e.second)]);
    MPI_Allreduce(MPI_IN_PLACE, p.data(), 3, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return p;
  };
  const Vec3 start = momentum();
  double worst = 0, pull = 0;
  integrate(d, 4, 4, [&](const StepInfo&) {
    worst = std::max(worst, (momentum() - start).norm());
    for (size_t n = 0; n < static_cast<size_t>(sim.local().owned); ++n)
      pull = std::max(pull, d.committed_kinematics().a[n].norm());
  });
  MPI_Allreduce(MPI_IN_PLACE, &pull, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  printf("two bodies on a line: momentum kept to %.1e of %.1f kg m/s, accelerations up to %.0f m/s2\n", worst,
         start.norm(), pull);
  EXPECT_LT(worst, 1e-11 * start.norm());
  EXPECT_GT(pull, 5);  // the line was in tension
}

}  // namespace
}  // namespace hawser::test::frames
