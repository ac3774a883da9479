// Contact between bodies: the tangents equal finite differences for leading parts (balls, corners, edges,
// faces) on other parts (faces, edges, vertices, round primitives); open, in the ramp and beyond, with one or
// both bodies floating. Points on faces integrate pressures with the error stated in the theory.
#include "hawser/terms/body_contact.hpp"

#include "hawser/math/function_ref.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/run/volumes.hpp"
#include "support/taylor.hpp"

namespace hawser::test::body_contact_test {
namespace {

using model::StiffnessBasis;

// The box of the other body: its top is z = 0.45, one edge of the top is x = 0.5.
const BoxShape kMet{{0, 0, 0}, {1, 1.2, 0.9}};
const Vec3 kEdge(0.5, 0.1, 0.45), kVertex(0.5, 0.6, 0.45), kTop(0.1, -0.2, 0.45);
constexpr double kGapSmoothing = 1e-3;

struct TouchCase {
  std::string name;
  Primitive shape, met = kMet;
  StiffnessBasis basis;
  Quat turn = Quat::Identity();  // of the leading body in the axes of the other
  Vec3 at = Vec3::Zero();        // point of the leading shape that is nearest, body frame
  double radius = 0;             // m, about this point
  Vec3 on = kTop;                // point of the other body, and its outward direction
  Vec3 out = Vec3::UnitZ();
  StiffnessBasis met_basis = StiffnessBasis::per_area;
  double slack = 2e-3;  // m, additional penetration elsewhere, about
};

Quat axes(const Vec3& x, const Vec3& y) {
  Mat3 m;
  m.col(0) = x.normalized();
  m.col(1) = y.normalized();
  m.col(2) = m.col(0).cross(m.col(1));
  return Quat(m);
}

std::vector<TouchCase> touch_cases() {
  const SphereShape ball{{0.1, 0.2, -0.1}, 0.3};
  const BoxShape box{{0.05, 0, 0.1}, {0.8, 1, 0.6}};
  const CapsuleShape bar{{-0.3, 0.1, 0}, {0.3, 0.1, 0}, 0.2};
  const Vec3 low(-0.35, 0, -0.2);  // on an edge of `box` that is along y
  const Vec3 over_edge = Vec3(0.8, 0, 0.6);
  const Vec3 across = Vec3(-0.6, 0.5, 0.8).normalized();
  const Quat on_edge = minimal_rotation(Vec3(-1, 0, -1), -Vec3::UnitZ());  // the body stands on that edge
  const StiffnessBasis point = StiffnessBasis::per_point;
  const StiffnessBasis length = StiffnessBasis::per_length;
  const StiffnessBasis area = StiffnessBasis::per_area;
  return {
      {"ball, face", ball, kMet, point, exp_so3({1, 2, 3}), ball.centre, 0.3},
      {"ball, edge", ball, kMet, point, exp_so3({1, 2, 3}), ball.centre, 0.3, kEdge, over_edge},
      {"ball, vertex", ball, kMet, point, exp_so3({1, 2, 3}), ball.centre, 0.3, kVertex, {0.6, 0.5, 0.6}},
      {"ball, ball", ball, SphereShape{{0, 0, 0.1}, 0.7}, point, exp_so3({1, 2, 3}), ball.centre, 0.3,
       Vec3(0, 0, 0.1) + 0.7 * over_edge, over_edge, point},
      {"ball, cylinder", ball, CylinderShape{{0, -1, 0}, {0, 1, 0}, 0.7}, point, exp_so3({1, 2, 3}),
       ball.centre, 0.3, 0.7 * over_edge, over_edge},
      {"corner, face",
       box,
       kMet,
       point,
       minimal_rotation(Vec3(-4, -5, -3), -Vec3::UnitZ()),
       {-0.35, -0.5, -0.2}},
      {"edge along a face", box, kMet, length, on_edge, low},
      {"edge along a cylinder",
       box,
       CylinderShape{{0, -1, 0}, {0, 1, 0}, 0.7},
       length,
       on_edge,
       low,
       0,
       {0, 0, 0.7}},
      {"edge on a face, inclined", box, kMet, length, exp_so3({0.016, 0, 0}) * on_edge, low, 0, kTop,
       Vec3::UnitZ(), area, 9e-3},
      {"edge on a ball",
       box,
       SphereShape{{0, 0, 0.1}, 0.7},
       length,
       exp_so3({0.1, 0, 0.4}) * on_edge,
       low + Vec3(0, 0.13, 0),
       0,
       {0, 0, 0.8},
       Vec3::UnitZ(),
       area,
       4e-3},
      {"edge across an edge", box, kMet, length, axes(across.cross(over_edge) + over_edge, across), low, 0,
       kEdge, over_edge, length},
      {"bar along a face", bar, kMet, length, exp_so3({0, 0, 0.7}), {0, 0.1, 0}, 0.2},
      {"bar across an edge",
       bar,
       kMet,
       length,
       axes(across, over_edge.cross(across)),
       {0.07, 0.1, 0},
       0.2,
       kEdge,
       over_edge},
      {"faces", box, PlaneShape{}, area, exp_so3({5e-4, -4e-4, 0.4}), {0.05, 0, -0.2}, 0, {0.3, 0.2, 0}},
  };
}

struct BodyModel {
  model::Case c;
  std::vector<run::LoadedVolume> volumes;
  Mesh mesh;
  std::shared_ptr<const Bodies> bodies;
  std::unique_ptr<System> system;
  BodyContact* contact = nullptr;
  Trial trial;
  Vec3 outward = Vec3::UnitZ();  // from the second body to the first one

  // gap [m] between the two in the trial; closing: speed of approach [m/s].
  BodyModel(const TouchCase& what, double gap, bool floats, double closing,
            const model::Friction& friction = {}, double damping = 0.2) {
    const auto volume = [&](const char* body, const Primitive& shape, StiffnessBasis basis) {
      model::Volume v;
      v.name = v.body = body;
      v.shape = shape;
      v.basis = basis;
      v.normal_stiffness = 1e5;
      v.smoothing = kGapSmoothing;
      v.relative_damping = damping;
      v.friction = friction;
      c.volumes.push_back(v);
      c.bodies.emplace_back().name = body;
    };
    volume("leads", what.shape, what.basis);
    volume("met", what.met, what.met_basis);
    c.bodies[0].mass.emplace();
    c.bodies[0].mass->mass = 40;
    c.bodies[0].mass->centre = {0.03, -0.05, 0.1};
    c.bodies[0].mass->inertia = {4, 5, 6};
    model::Body& other = c.bodies[1];
    other.position = {1, 2, 3};
    other.rotation = {0.5, -0.4, 0.8};
    if (floats) {
      other.mass = c.bodies[0].mass;
      other.mass->mass = 70;
      other.mass->centre = {-0.1, 0.02, 0.05};
    }
    volumes = run::load_volumes(c);
    mesh = build_mesh(c);
    bodies = std::make_shared<const Bodies>(std::vector<RigidMotion>{
        {},
        {other.position, other.rotation,
         floats ? MotionLaw() : MotionLaw(SteadyLaw{{0.2, -0.1, 0.3}, {1, 2, -2}, 0.4})}});
    system =
        std::make_unique<System>(PETSC_COMM_SELF, local_mesh(mesh, NodeRanks::all_of(mesh.nodes()), 0, 1));
    std::vector<BodyVolume> touching;
    auto skeletons = run::skeletons(c, volumes);
    const auto faces = run::surfaces(volumes);
    for (size_t v = 0; v < 2; ++v) touching.push_back({faces[v], skeletons[v]});
    auto term = std::make_unique<BodyContact>(PETSC_COMM_SELF, c, system->mesh(), bodies, touching);
    contact = term.get();
    system->add(std::move(term));

    const LocalMesh& l = system->mesh();
    trial.h = 0.01;
    trial.length = trial.angle = 1e-4;
    trial.from = trial.rates = State(l.nodes());
    trial.from.time = 1;
    trial.u.assign(3 * static_cast<size_t>(l.blocks()), 0);
    const RigidPose met = bodies->pose(1, floats ? 0 : trial.from.time + trial.h);
    const Quat q = met.rotation * what.turn;
    const Vec3 out = what.out.normalized();
    const Vec3 x = met.to_space(what.on + (what.radius + gap) * out) - q * what.at;
    const auto put = [&](int body, const Vec3& origin, const Quat& turn, const Vec3& v, const Vec3& w) {
      const int node = l.find(mesh.body_node(body));
      const size_t i = static_cast<size_t>(node);
      const Vec3 at = origin + turn * c.bodies[static_cast<size_t>(body)].mass->centre;
      const Vec3 u = 0.02 * noise3(body, 1);
      const Vec3 turned = 0.3 * noise3(body, 2);
      trial.from.x[i] = at - u;
      trial.from.q[i] = turn * exp_so3(-turned);
      double* to = trial.u.data() + 3 * l.block[i];
      Eigen::Map<Vec3>(to, 3) = u;
      Eigen::Map<Vec3>(to + 3, 3) = turned;
      trial.rates.v[i] = v;
      trial.rates.w[i] = w;
    };
    outward = met.rotation * out;
    put(0, x, q, met.velocity_at(x) - closing * outward + 0.05 * noise3(0, 3), 0.05 * noise3(0, 4));
    if (floats) put(1, met.position, met.rotation, 0.05 * noise3(1, 3), 0.05 * noise3(1, 4));
    system->update_couplings(trial.from.after_step(trial.h), trial.h);
    system->prepare(trial.from.after_step(trial.h), trial.h);
  }

  // Moves the first body of a trial away from the other one by a distance, m.
  void move_out(Trial& t, double distance) const {
    const LocalMesh& l = system->mesh();
    const size_t node = static_cast<size_t>(l.find(l.mesh->body_node(0)));
    Eigen::Map<Vec3>(t.u.data() + 3 * l.block[node]) += distance * outward;
  }
};

// The sum of the forces and the sum of the moments between the bodies are zero.
void expect_momentum(const BodyModel& m, const State& s) {
  const LocalMesh& l = m.system->mesh();
  const std::vector<double> f = residual(*m.system, s, m.trial.h);
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  double size = 0;
  for (size_t i = 0; i < static_cast<size_t>(l.nodes()); ++i) {
    const double* of = f.data() + 3 * l.block[i];
    const Eigen::Map<const Vec3> force(of);
    const Eigen::Map<const Vec3> couple(of + 3);
    sum += force;
    moment += s.x[i].cross(force) + s.q[i] * couple;
    size += force.norm();
  }
  EXPECT_LT(sum.norm(), 1e-12 * size);
  EXPECT_LT(moment.norm(), 1e-11 * size);
}

TEST(BodyContact, Tangents) {
  for (const TouchCase& c : touch_cases())
    for (const bool floats : {true, false})
      for (const auto& [gap, name] : {std::pair(4e-3 + c.slack, "open"), {0.2e-3, "ramp"}, {-5e-3, "full"}}) {
        BodyModel m(c, gap, floats, 0.1);
        const std::string what = c.name + ", " + name + (floats ? ", two" : ", one");
        const State s = state_of(m.system->mesh(), m.trial);
        double size = 0;
        for (const double f : residual(*m.system, s, m.trial.h)) size = std::max(size, std::abs(f));
        if (gap > kGapSmoothing) {
          EXPECT_EQ(size, 0) << what;
          continue;
        }
        EXPECT_GT(size, 1e-3) << what;
        if (floats) expect_momentum(m, s);
        m.system->commit(s.after_step(m.trial.h));
        EXPECT_NEAR(m.contact->largest_penetration(), std::max(-gap, 0.0), c.slack) << what;
        expect_tangent(*m.system, m.trial, what);
      }
}

model::Friction friction(double coefficient, double mobilisation) {
  model::Friction f;
  f.axial = f.lateral = coefficient;
  f.mobilisation_length = f.lateral_mobilisation_length = mobilisation;
  return f;
}

// Tangents where the contact point sticks and where it slides, from the first touch in the step and with the
// slip of an accepted step.
TEST(BodyContact, TangentsWithFriction) {
  for (const TouchCase& c : touch_cases()) {
    for (const bool floats : {true, false})
      for (const auto& [law, name] :
           {std::pair(friction(0.4, 1), "sticks"), {friction(0.4, 1e-3), "slides"}}) {
        const std::string what = c.name + ", " + name + (floats ? ", two" : ", one");
        // With damping, the lightly loaded pieces of a face slide while others stick, and one of them is
        // always between the two, where the force has a kink.
        const double damping = c.basis == StiffnessBasis::per_area && law.mobilisation_length == 1 ? 0 : 0.2;
        BodyModel m(c, -5e-3, floats, 0.1, law, damping);
        BodyModel smooth(c, -5e-3, floats, 0.1, {}, damping);
        const State s = state_of(m.system->mesh(), m.trial);
        const std::vector<double> with = residual(*m.system, s, m.trial.h);
        const std::vector<double> without = residual(*smooth.system, s, m.trial.h);
        double change = 0, size = 0;
        for (size_t i = 0; i < with.size(); ++i) {
          change = std::max(change, std::abs(with[i] - without[i]));
          size = std::max(size, std::abs(without[i]));
        }
        EXPECT_GT(change, 1e-3 * size) << what;
        if (floats) expect_momentum(m, s);
        expect_tangent(*m.system, m.trial, what + ", first touch");
        // The slip of an edge is interpolated between its contact points, and has a kink at them. Friction
        // has a kink where the normal force is equal to its previous peak, so that the body is 1 mm further
        // out.
        Trial before = m.trial;
        for (double& u : before.u) u *= 0.997;
        m.move_out(before, 1e-3);
        const State committed = state_of(m.system->mesh(), before);
        m.system->commit(committed.after_step(m.trial.h));
        m.system->prepare(m.trial.from.after_step(m.trial.h), m.trial.h);
        expect_tangent(*m.system, m.trial, what);
      }
  }
}

// The slip of a sticking contact is in the checkpoint records: a restored model has the same slip.
TEST(BodyContact, SlipIsKept) {
  for (const TouchCase& c : touch_cases()) {
    BodyModel first(c, -5e-3, true, 0.1, friction(0.4, 1));
    BodyModel second(c, -5e-3, true, 0.1, friction(0.4, 1));
    const State s = state_of(first.system->mesh(), first.trial);
    first.system->commit(s.after_step(first.trial.h));
    second.contact->restore(first.contact->save());
    for (BodyModel* m : {&first, &second}) m->system->prepare(s.after_step(m->trial.h), m->trial.h);
    const std::vector<double> expected = residual(*first.system, s, first.trial.h);
    const std::vector<double> restored = residual(*second.system, s, second.trial.h);
    for (size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(restored[i], expected[i], 1e-12 * std::abs(expected[i])) << c.name << ", " << i;
  }
}

// Tangents with a friction coefficient that decreases with the sliding speed.
TEST(BodyContact, TangentsWithFrictionThatFalls) {
  model::Friction law = friction(0.4, 1e-3);
  law.axial_kinetic = law.lateral_kinetic = 0.2;
  law.blend_speed = 0.2;
  for (const TouchCase& c : touch_cases()) {
    BodyModel m(c, -5e-3, true, 0.1, law);
    expect_tangent(*m.system, m.trial, c.name);
  }
}

// The depth that corners and edges have reached is in the checkpoint records: a restored model has the same
// value.
TEST(BodyContact, WhatWasMetIsKept) {
  for (const TouchCase& c : touch_cases()) {
    if (c.name != "edge along a face") continue;
    BodyModel deep(c, -0.1, true, 0);
    BodyModel apart(c, 0.5, true, 0);
    const State s = state_of(deep.system->mesh(), deep.trial);
    deep.system->commit(s.after_step(deep.trial.h));
    deep.system->prepare(s.after_step(deep.trial.h), deep.trial.h);
    const auto kept = deep.contact->save();
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_GT(kept[0].values.back(), 0.09);
    EXPECT_EQ(apart.contact->save()[0].values.back(), 0);
    apart.contact->restore(kept);
    EXPECT_EQ(apart.contact->save()[0].values, kept[0].values);
    // The value is reset when the bodies are apart.
    apart.system->prepare(apart.trial.from.after_step(apart.trial.h), apart.trial.h);
    EXPECT_EQ(apart.contact->save()[0].values.back(), 0);
    return;
  }
  FAIL();
}

constexpr double kLong = 1, kWide = 0.6, kHigh = 0.4;  // m

SkeletonParts faces_of_a_box() {
  model::Case c;
  model::Volume v;
  v.name = "box";
  v.shape = BoxShape{{0.5 * kLong, 0.5 * kWide, -0.5 * kHigh}, {kLong, kWide, kHigh}};
  v.basis = model::StiffnessBasis::per_area;
  v.normal_stiffness = 1;
  c.volumes.push_back(v);
  const auto volumes = run::load_volumes(c);
  return body_skeleton(v, *volumes[0].facets, volumes[0].active).features;
}

// Integral of a function over the top, 0 < x < kLong and 0 < y < kWide.
double over_top(const SkeletonParts& parts, FunctionRef<double(const Vec3&)> f) {
  double sum = 0;
  parts.walk([](const Vec3&, double) { return true; },
             [&](const SkeletonPart& p) {
               if (std::abs(p.from.z()) < 1e-9) sum += p.weight * f(p.from);
             });
  return sum;
}

// Polynomials of the second degree are integrated exactly.
TEST(BodySkeleton, FacesIntegrateTheSecondDegree) {
  const SkeletonParts parts = faces_of_a_box();
  EXPECT_NEAR(over_top(parts, [](const Vec3&) { return 1.0; }), kLong * kWide, 1e-13);
  EXPECT_NEAR(over_top(parts, [](const Vec3& x) { return x.x() * x.x(); }), kWide / 3, 1e-13);
  EXPECT_NEAR(over_top(parts, [](const Vec3& x) { return x.x() * x.y(); }), kWide * kWide / 4, 1e-13);
}

// A pressure that increases from zero at x = kLong - L to the edge x = kLong, without a smooth onset: the
// error is below 0.025 (h/L)², h the side of a piece (docs/theory/body-contact.md).
TEST(BodySkeleton, ErrorOfALoadOnAPartOfAFace) {
  const SkeletonParts parts = faces_of_a_box();
  const double side = 0.04 * kLong;
  for (double length = 2.5 * side; length < kLong; length *= 1.003) {
    const double exact = kWide * length * length / 2;
    const double sum = over_top(parts, [&](const Vec3& x) { return std::max(x.x() - kLong + length, 0.0); });
    EXPECT_LT(std::abs(sum / exact - 1), 0.025 * std::pow(side / length, 2)) << length;
  }
}

}  // namespace
}  // namespace hawser::test::body_contact_test
