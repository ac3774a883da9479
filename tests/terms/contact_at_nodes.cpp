// Contact at nodes: forces, work and energies against hand calculations; history through a checkpoint;
// candidates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::test::contact_at_nodes_test {
namespace {

// Two cable nodes, one element of 1 m; the second node is far from all surfaces.
struct Model {
  Mesh mesh;
  LocalMesh local;
  State state{2}, next{2};

  Model() {
    mesh.add(Node{0, 0, 0.5, false});
    mesh.add(Node{0, 1, 0.5, false});
    mesh.add(Element{0, 0, 1, 0, 1, false});
    mesh.lines = {{0, 2, 0, 1, 1}};
    local.mesh = &mesh;
    local.owned = 2;
    local.owner = NodeRanks::all_of(2);
    local.global = {0, 1};
    local.block = {0, 1};
    local.owned_blocks = 2;
    local.global_block = {0, 1};
    local.elements = {{0, 1, 0, true}};
    local.copy_local();
  }
};

ContactVolume volume(std::shared_ptr<const Surface> surface, int body = -1) {
  ContactVolume v;
  v.surface = std::move(surface);
  v.body = body;
  v.settings.name = "drum";
  v.settings.basis = model::StiffnessBasis::per_point;
  v.settings.normal_stiffness = 1e5;
  v.settings.smoothing = 1e-3;
  v.settings.relative_damping = 0.1;
  v.settings.friction = {0.3, 0.3, 0, 4e4};
  return v;
}

LineVolumeContact at_nodes(const Model& m, const ContactVolume& v,
                           std::shared_ptr<const Bodies> bodies = nullptr, bool both = true) {
  LineContactElement e{0.1, 100};
  e.held[1] = !both;
  return {m.local, bodies, {v}, {e}, PETSC_COMM_SELF, model::ContactMethod::nodes};
}

Vec3 node_field(const LineVolumeContact& term, const Kinematics& state, const std::string& name,
                size_t node) {
  FieldRegistry registry;
  term.fields(registry);
  for (const FieldSource& f : registry.sources()) {
    if (f.name != name) continue;
    std::vector<double> values(static_cast<size_t>(2 * f.components), -1);
    f.fill(state, values);
    return f.components == 3 ? Vec3(&values[3 * node]) : Vec3(0, 0, values[node]);
  }
  return Vec3::Constant(NAN);
}

// Total force and friction force on a node in a trial, from a copy of the term that accepts the trial.
struct Force {
  Vec3 total, friction;
};
Force force(LineVolumeContact term, const Kinematics& trial, size_t node) {
  term.commit(trial);
  return {node_field(term, trial, "contact_force", node), node_field(term, trial, "friction_force", node)};
}

// A node moves with a rotating body: a sticking contact remains sticking for any motion of the body.
TEST(ContactAtNodes, IsCarriedByItsBody) {
  Model m;
  const RigidMotion turning{{1, 2, 3}, {0.3, -0.2, 0.5}, SteadyLaw{{0.2, -0.1, 0.3}, {1, 2, -2}, 0.4}, 0};
  const auto bodies = std::make_shared<const Bodies>(std::vector<RigidMotion>{turning});
  LineVolumeContact term = at_nodes(
      m, volume(std::make_shared<CylinderSurface>(Vec3(0, -3, 0), Vec3(0, 3, 0), 2), 0), bodies, false);
  const Vec3 y0 = 2.09 * Vec3(0.6, 0, 0.8), side(0, 3e-3, 0);
  const double h = 0.1;
  double magnitude = 0;
  for (int i = 0; i <= 100; ++i) {
    const RigidPose pose = bodies->pose(0, i * h);
    if (i > 0) term.prepare(m.state.after_step(h), h);
    m.state.time = i * h;
    m.state.x[0] = pose.to_space(i < 2 ? y0 : y0 + side);
    m.state.v[0] = pose.velocity_at(m.state.x[0]);
    if (i == 0) continue;
    term.commit(m.state.after_step(h));
    if (i == 2) magnitude = 4e4 * side.norm();
    const Force f = {node_field(term, m.state.after_step(h), "contact_force", 0),
                     node_field(term, m.state.after_step(h), "friction_force", 0)};
    EXPECT_NEAR((f.total - f.friction).norm(), 1e5 * 0.01, 1e-6);
    EXPECT_NEAR(f.friction.norm(), magnitude, 1e-7) << i;
  }
  EXPECT_NEAR(term.largest_penetration().depth, 0.01, 1e-12);
  EXPECT_EQ(term.largest_penetration().node, 0);
  EXPECT_EQ(term.active_count(), 1);
  // Only friction and the body do work here: the tangential spring has taken the work of the sideways push.
  EXPECT_NEAR(term.energy(m.state.after_step(h)).friction, 0.5 * 4e4 * 9e-6, 1e-3);
}

// The node moves over a plane along a given path: work of the spring, of friction and of damping against hand
// calculations.
TEST(ContactAtNodes, Energy) {
  Model m;
  ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()));
  LineVolumeContact term = at_nodes(m, v);
  m.state.x = {Vec3(0, 0, 0.2), Vec3(0, 50, 50)};
  const double h = 1e-3;
  const double k = 1e5;
  const double c = contact_damping(0.1, 1e5, 50);
  // Down to 0.02 m penetration in 0.12 s, then sideways by 0.5 m at 1 m/s.
  Vec3 friction = Vec3::Zero();
  for (int i = 1; i <= 620; ++i) {
    term.prepare(m.state.after_step(h), h);
    const double t = i * h;
    m.state.time = t;
    m.state.v[0] = t <= 0.12 + 1e-12 ? Vec3(0, 0, -1) : Vec3(0, 1, 0);
    m.state.x[0] = t <= 0.12 + 1e-12 ? Vec3(0, 0, 0.2 - t) : Vec3(0, t - 0.12, 0.08);
    term.commit(m.state.after_step(h));
    friction = node_field(term, m.state.after_step(h), "friction_force", 0);
  }
  const Energy e = term.energy(m.state.after_step(h));
  EXPECT_NEAR(e.strain, k * (0.02 * 0.02 / 2 + 1e-6 / 6), 1e-9);
  EXPECT_NEAR(friction.y(), -0.3 * k * 0.02, 1e-9);
  EXPECT_NEAR(e.damping, c * 1 * 0.02, 0.03 * c * 0.02);  // the ramp of 1 mm is one step of the test
  const double elastic = 0.3 * k * 0.02 / 4e4;            // slip at which sliding begins
  EXPECT_NEAR(e.friction, 0.3 * k * 0.02 * (0.5 - elastic / 2), 0.01 * 300);
  EXPECT_EQ(e.work, 0);
  EXPECT_NEAR(term.largest_penetration().depth, 0.02, 1e-12);

  FieldRegistry registry;
  term.fields(registry);
  for (const FieldSource& f : registry.sources()) {
    std::vector<double> values(static_cast<size_t>(2 * f.components), -1);
    f.fill(m.state.after_step(h), values);
    if (f.name == "penetration") {
      EXPECT_NEAR(values[0], 0.02, 1e-12);
    }
    if (f.name == "contact_normal_force") {
      EXPECT_NEAR(values[0], k * 0.02, 1e-6);
    }
    if (f.name == "contact_force") {
      EXPECT_NEAR(values[1], friction.y(), 1e-6);
      EXPECT_NEAR(values[2], k * 0.02, 1e-6);
    }
    EXPECT_EQ(values.back(), 0) << f.name;  // the other node
  }
}

// A plane rises under a held node: the work of the plane equals the energy in the spring and the damper.
TEST(ContactAtNodes, WorkOfTheBody) {
  Model m;
  const RigidMotion rising({0, 0, 0}, {0, 0, 0}, SteadyLaw{{0.1, 0, 0.2}, {0, 0, 1}, 0}, 0);
  ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()), 0);
  LineVolumeContact term = at_nodes(m, v, std::make_shared<const Bodies>(std::vector<RigidMotion>{rising}));
  m.state.x = {Vec3(0, 0, 0.12), Vec3(0, 50, 50)};
  const double h = 1e-3;
  for (int i = 1; i <= 200; ++i) {
    term.prepare(m.state.after_step(h), h);
    m.state.time = i * h;
    term.commit(m.state.after_step(h));
  }
  const Energy e = term.energy(m.state.after_step(h));
  EXPECT_NEAR(term.largest_penetration().depth, 0.02, 1e-12);
  EXPECT_NEAR(e.work, e.strain + e.damping + e.friction, 1e-3 * e.work);
  EXPECT_GT(e.strain, 10);
  EXPECT_GT(e.friction, 1);
}

TEST(ContactAtNodes, HistoryGoesThroughACheckpoint) {
  Model m;
  const ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()));
  LineVolumeContact term = at_nodes(m, v);
  LineVolumeContact copy = at_nodes(m, v);
  m.state.x = {Vec3(0, 0, 0.09), Vec3(0, 1, 0.095)};
  const double h = 0.01;
  for (int i = 1; i <= 3; ++i) {
    term.prepare(m.state.after_step(h), h);
    m.state.time = i * h;
    m.state.x[0] += Vec3(2e-3, 1e-3, -1e-3);
    m.state.x[1] += Vec3(0.2, 0.1, -1e-3);
    term.commit(m.state.after_step(h));
  }
  auto records = term.save();
  ASSERT_EQ(records.size(), 3u);  // of the element at either node, and its sums
  std::reverse(records.begin(), records.end());
  copy.restore(records);
  for (LineVolumeContact* t : {&term, &copy}) t->prepare(m.state.after_step(h), h);
  m.state.time += h;
  m.state.x[0] += Vec3(1e-4, -3e-4, 0);
  for (size_t i = 0; i < 2; ++i)
    EXPECT_EQ(
        (force(term, m.state.after_step(h), i).total - force(copy, m.state.after_step(h), i).total).norm(),
        0);
  for (LineVolumeContact* t : {&term, &copy}) t->commit(m.state.after_step(h));
  EXPECT_EQ(term.energy(m.state.after_step(h)).friction, copy.energy(m.state.after_step(h)).friction);
  EXPECT_EQ(term.energy(m.state.after_step(h)).strain, copy.energy(m.state.after_step(h)).strain);
  EXPECT_EQ(term.largest_penetration().depth, copy.largest_penetration().depth);
  EXPECT_EQ(copy.largest_penetration().node, term.largest_penetration().node);
}

TEST(ContactAtNodes, FrictionCanBeOffAndFarPairsAreNoCandidates) {
  Model m;
  const ContactVolume v = volume(std::make_shared<CylinderSurface>(Vec3(0, -3, 0), Vec3(0, 3, 0), 2));
  LineVolumeContact term = at_nodes(m, v);
  m.state.x = {Vec3(0, 0, 6), Vec3(0, 0, 7)};
  term.prepare(m.state.at_start(0.01), 0.01);
  EXPECT_EQ(term.candidates(), 0);
  m.state.v[1] = Vec3(0, 0, -200);  // will touch within two steps
  term.prepare(m.state.at_start(0.01), 0.01);
  EXPECT_EQ(term.candidates(), 1);
  m.state.x = {Vec3(0, 0, 2.09), Vec3(0, 0, 4)};
  term.prepare(m.state.at_rest(), 0);  // statics: any displacement is possible
  EXPECT_EQ(term.candidates(), 1);
  m.next = m.state;
  m.next.x[0] += Vec3(0, 1e-3, 0);
  m.next.x[1] = Vec3(0, 0, 2.08);
  EXPECT_GT(force(term, m.next.at_rest(), 0).friction.norm(), 1);
  EXPECT_NEAR(force(term, m.next.at_rest(), 1).total.z(), 2000, 1e-6);
  m.next.x[1] = Vec3(0, 0, 4);  // there and back: the cached distance does not hide the contact
  EXPECT_EQ(force(term, m.next.at_rest(), 1).total.z(), 0);
  m.next.x[1] = Vec3(0, 0, 2.07);
  EXPECT_NEAR(force(term, m.next.at_rest(), 1).total.z(), 3000, 1e-6);
  term.enable_friction(false);
  EXPECT_EQ(force(term, m.next.at_rest(), 0).friction.norm(), 0);
  EXPECT_GT(force(term, m.next.at_rest(), 0).total.norm(), 100);
}

TEST(ContactAtNodes, StiffnessByBasis) {
  for (const auto& [basis, expected] : {std::pair(model::StiffnessBasis::per_point, 1000.0),
                                        std::pair(model::StiffnessBasis::per_length, 500.0),
                                        std::pair(model::StiffnessBasis::per_area, 100.0)}) {
    Model m;
    ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()));
    v.settings.basis = basis;
    LineVolumeContact term = at_nodes(m, v);
    m.state.x = {Vec3(0, 0, 0.09), Vec3(0, 1, 5)};
    term.prepare(m.state.at_rest(), 0);
    EXPECT_NEAR(force(term, m.state.at_rest(), 0).total.z(), expected, 1e-9);
  }
  Model m;
  ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()));
  v.settings.basis = model::StiffnessBasis::automatic;
  EXPECT_THROW(at_nodes(m, v), std::invalid_argument);
  v.settings.basis = model::StiffnessBasis::per_point;
  v.body = 0;
  EXPECT_THROW(at_nodes(m, v), std::invalid_argument);
}

}  // namespace
}  // namespace hawser::test::contact_at_nodes_test
