// Springs and dampers between points of all kinds: the tangent of a step equals finite differences, and
// forces and moments balance.
#include <gtest/gtest.h>

#include <array>

#include "support/step_tangent.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::links {
namespace {

model::LinkEnd space(const Vec3& at) { return {"", "", at, 0}; }
model::LinkEnd on_body(const std::string& body, const Vec3& at) { return {body, "", at, 0}; }
model::LinkEnd on_line(const std::string& line, double arc) { return {"", line, Vec3::Zero(), arc}; }

model::End tied(const std::string& body, const Vec3& at) {
  model::End e;
  e.kind = model::EndKind::body;
  e.carrier = body;
  e.at = at;
  return e;
}

model::Line line(const std::string& name, const std::string& type, double length, const model::End& a,
                 const model::End& b) {
  model::Line l;
  l.name = name;
  l.sections.push_back({type, length, 3, 1});
  l.end_a = a;
  l.end_b = b;
  l.start = model::Start::straight;
  return l;
}

// Two bodies with mass, one body with prescribed motion and one attached to a beam; a beam, a cable tied to a
// body and a free cable. All are soft, so that the forces of the links dominate.
model::Case things() {
  model::Case c;
  c.environment.gravity = 0;
  c.line_types = {beam_type(300, 40, 30, 2), cable_type(200, 2)};
  for (const char* name : {"buoy", "load"}) {
    model::Body& b = c.bodies.emplace_back();
    b.name = name;
    b.position = name[0] == 'b' ? Vec3(0, 0, 1) : Vec3(4, 1, -1);
    model::BodyMass& m = b.mass.emplace();
    m.mass = 40;
    m.inertia = {12, 15, 9};
    m.products = {1, 0.5, -0.7};
    m.centre = {0.1, -0.2, 0.15};
  }
  model::Body& vessel = c.bodies.emplace_back();
  vessel.name = "vessel";
  vessel.position = {2, 3, 0};
  model::HarmonicMotion swing;
  swing.amplitude = {0.5, 0.3, 0.2};
  swing.rotation_amplitude = {0.2, 0.1, 0.3};
  swing.period = 2;
  vessel.motion = swing;
  model::Body& rider = c.bodies.emplace_back();
  rider.name = "rider";
  rider.ride = model::Ride{"leg", 2};
  rider.position = {0.05, 0.4, 0.2};
  rider.rotation = {0.3, -0.2, 0.4};
  c.lines = {line("leg", "beam", 3, clamp({8, 0, -3}, Vec3::UnitZ()), model::End{}),
             line("rope", "cable", 2, tied("buoy", {0.5, 0.3, 0.2}), anchor({2, 0.3, 1.5})),
             line("stay", "cable", 3, anchor({-3, 2, 0}), anchor({-3, 5, 0.5}))};
  c.lines[0].points = {{8, 0, -3}, {8, 0, 0}};
  c.lines[0].start = model::Start::points;
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 1;
  c.dynamics.step = 0.02;
  return c;
}

struct Pair {
  const char* what;
  model::LinkEnd a, b;
};
const std::vector<Pair> kPairs = {
    {"space and a beam", space({7, 2, 1}), on_line("leg", 3)},
    {"space and a cable", space({-5, 3, 1}), on_line("stay", 1)},
    {"space and a body with mass", space({-1, -2, 0}), on_body("buoy", {0.4, -0.3, 0.6})},
    {"a prescribed body and one with mass", on_body("vessel", {0.3, -1, 0.2}),
     on_body("load", {-0.4, 0.5, 0.7})},
    {"a cable and a prescribed body", on_line("stay", 2), on_body("vessel", {-1, 0.5, 0.2})},
    {"two bodies with mass", on_body("load", {-0.4, 0.5, 0.7}), on_body("buoy", {0.4, -0.3, 0.6})},
    {"a body with mass and its centre", on_body("load", {0.1, -0.2, 0.15}),
     on_body("buoy", {0.4, -0.3, 0.6})},
    {"a body with mass and a cable", on_body("buoy", {-0.4, 0.3, 0.6}), on_line("stay", 2)},
    {"a rider and space", on_body("rider", {0.3, 0.2, -0.4}), space({7, 2, 1})},
    {"a rider and a body with mass", on_body("rider", {0.3, 0.2, -0.4}), on_body("load", {0.4, 0.5, 0.7})},
    {"a rider and a cable", on_body("rider", {0.3, 0.2, -0.4}), on_line("rope", 1.3)},
    {"a beam and a cable", on_line("leg", 1), on_line("stay", 1)},
    {"a tied end and a body with mass", on_line("rope", 0), on_body("load", {0.4, 0.5, 0.7})},
    {"a tied end and a cable", on_line("rope", 0), on_line("stay", 2)}};

model::Case linked(const Pair& p, bool tension_only, double rest) {
  model::Case c = things();
  model::Link& l = c.links.emplace_back();
  l.name = "link";
  l.end_a = p.a;
  l.end_b = p.b;
  l.rest_given = true;
  l.law.rest_length = rest;
  l.law.stiffness = 3000;
  l.law.damping = 150;
  l.law.tension_only = tension_only;
  return c;
}

struct Step {
  double error = 0;
  bool apart = false;  // the ends are on two ranks
};
Step step_error(const model::Case& c) {
  Simulation sim(PETSC_COMM_WORLD, c);
  const LocalMesh& mesh = sim.local();
  const auto owner = [&](const model::LinkEnd& e) {
    const int body = c.body_index(e.body);
    const int node = e.line.empty() ? (body < 0 ? -1 : sim.mesh().frame_node(body))
                                    : sim.mesh().nearest_node(c.line_index(e.line), e.arc);
    return node < 0 ? -1 : mesh.owner[static_cast<size_t>(node)];
  };
  const int first = owner(c.links[0].end_a);
  const int second = owner(c.links[0].end_b);
  StepTangent step = StepTangent::by_chance(sim.system(), sim.state(), 0.02, 0.05, 0.2);
  return {step.worst(1e-3, 1e-3), first >= 0 && second >= 0 && first != second};
}

TEST(Links, TangentOfAStepForEveryPairOfEnds) {
  int rank = 0, size = 1, apart = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  MPI_Comm_size(PETSC_COMM_WORLD, &size);
  for (const Pair& p : kPairs)
    for (const auto& [tension_only, rest] :
         {std::pair{false, 9.0}, {false, 0.7}, {true, 0.7}, {false, 0.0}}) {
      const Step s = step_error(linked(p, tension_only, rest));
      apart += s.apart;
      if (rank == 0)
        printf("  %-36s rest length %.1f m: %.1e%s\n", p.what, rest, s.error,
               s.apart ? ", on two ranks" : "");
      EXPECT_LT(s.error, 1e-10) << p.what << ", rest length " << rest;
    }
  EXPECT_EQ(apart > 0, size > 1);
}

// Two bodies in space, joined by a link far from their centres, conserve momentum and, about any point,
// angular momentum.
TEST(Links, MomentumOfTwoBodies) {
  model::Case c;
  c.environment.gravity = 0;
  for (const double x : {0.0, 4.0}) {
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
  model::Link& l = c.links.emplace_back();
  l.name = "link";
  l.end_a = on_body("first", {0.5, 0.7, 0});
  l.end_b = on_body("second", {-0.4, 0, 0.8});
  l.law.stiffness = 2000;
  l.law.damping = 50;
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 4;
  c.dynamics.step = 0.005;
  c.dynamics.tolerance = 1e-13;
  Simulation sim(PETSC_COMM_WORLD, c);
  Dynamics& d = sim.dynamics();
  d.start(sim.state());
  const auto momentum = [&] {
    const Kinematics k = d.committed_kinematics();
    const LocalMesh& m = sim.local();
    std::array<double, 6> sum{};
    for (size_t n = 0; n < static_cast<size_t>(m.owned); ++n) {
      const Node& node = sim.mesh().node(static_cast<size_t>(m.global[n]));
      const model::BodyMass& body = *c.bodies[static_cast<size_t>(node.body)].mass;
      const Vec3 p = body.mass * k.v[n];
      Eigen::Map<Vec3>(sum.data()) += p;
      Eigen::Map<Vec3>(sum.data() + 3) += k.x[n].cross(p) + k.q[n] * (body.tensor() * k.w[n]);
    }
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), 6, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return std::pair(Vec3(sum.data()), Vec3(sum.data() + 3));
  };
  const auto [linear, angular] = momentum();
  double kept = 0, turned = 0, pull = 0;
  integrate(d, 4, 4, [&](const StepInfo&) {
    const auto [p, L] = momentum();
    kept = std::max(kept, (p - linear).norm());
    turned = std::max(turned, (L - angular).norm());
    for (size_t n = 0; n < static_cast<size_t>(sim.local().owned); ++n)
      pull = std::max(pull, d.committed_kinematics().a[n].norm());
  });
  MPI_Allreduce(MPI_IN_PLACE, &pull, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  printf(
      "two bodies on a link: momentum kept to %.1e of %.1f kg m/s, its moment to %.1e of %.1f, up to %.0f "
      "m/s2\n",
      kept, linear.norm(), turned, angular.norm(), pull);
  EXPECT_LT(kept, 1e-11 * linear.norm());
  EXPECT_LT(turned, 1e-11 * angular.norm());
  EXPECT_GT(pull, 5);
}

}  // namespace
}  // namespace hawser::test::links
