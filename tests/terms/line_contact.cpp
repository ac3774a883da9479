// Contact along elements: tangents equal finite differences in every state, `evaluate` is repeatable, forces
// rotate with the model, and the energies balance.
#include "terms/line_contact_cases.hpp"
#include "terms/whole_model.hpp"

namespace hawser::test::line_contact_test {
namespace {

TEST(LineContact, Tangents) {
  for (const LineCase& c : line_cases()) {
    LineModel m(c);
    EXPECT_GT(m.contact->active_count(), 1) << c.name;
    expect_tangent(*m.system, m.trial, "along the line, " + c.name);
  }
}

std::vector<double> node_field(const LineVolumeContact& contact, const Kinematics& state,
                               const std::string& name, int nodes) {
  FieldRegistry registry;
  contact.fields(registry);
  for (const FieldSource& f : registry.sources()) {
    if (f.name != name) continue;
    std::vector<double> values(static_cast<size_t>(nodes * f.components), -1);
    f.fill(state, values);
    return values;
  }
  return {};
}

// The cases cover the intended states: open and in contact, in the ramp and beyond, sticking and sliding.
TEST(LineContact, Situations) {
  for (const LineCase& c : line_cases()) {
    LineModel m(c);
    const State end = state_of(m.system->mesh(), m.trial);
    m.system->commit(end.after_step(m.trial.h));
    const auto records = m.contact->save();
    const CheckpointKind points = m.contact->checkpoint_kinds().front();
    size_t size = 0, gap_at = 0, normal_at = 0, friction_at = 0, from_at = 0, to_at = 0;
    for (const CheckpointQuantity& q : points.quantities) {
      for (const auto& [name, at] : {std::pair{"gap", &gap_at},
                                     {"normal force", &normal_at},
                                     {"friction force", &friction_at},
                                     {"from", &from_at},
                                     {"to", &to_at}})
        if (q.name == name) *at = size;
      size += static_cast<size_t>(q.components);
    }
    int ramp = 0, full = 0, sliding = 0, stuck = 0, moving = 0;
    for (const CheckpointRecord& r : records) {
      if (r.kind != 0 || r.key % 2 != 0) continue;  // once for each element
      for (size_t i = 0; i < r.values.size(); i += size) {
        const double gap = r.values[i + gap_at];
        const double normal = r.values[i + normal_at];
        const Vec3 friction = Eigen::Map<const Vec3>(r.values.data() + i + friction_at);
        const double from = r.values[i + from_at];
        const double to = r.values[i + to_at];
        ++(gap > -1e-3 ? ramp : full);
        moving += (from > 0 && from != 0.5) || (to < 1 && to != 0.5);
        if (c.axial != c.lateral || c.axial == 0) continue;
        ++(friction.norm() > 0.2999 * normal ? sliding : stuck);
      }
    }
    EXPECT_GT(ramp, 0) << c.name;
    EXPECT_GT(full, 0) << c.name;
    EXPECT_GT(moving, 0) << c.name;
    if (c.axial > 0 && c.axial == c.lateral) {
      EXPECT_GT(c.far ? sliding : stuck, 4) << c.name;
    }
  }
}

TEST(LineContact, EvaluatingLeavesNoTrace) {
  for (const LineCase& c : line_cases()) {
    LineModel m(c);
    LineModel other(c);
    System& system = *m.system;
    const Trial& t = m.trial;
    const LocalMesh& mesh = system.mesh();
    const State here = state_of(mesh, t);
    const auto f = residual(system, here, t.h);
    const MatHandle J = tangent(system, t, {1, 3, 7, 0, 0});
    // The last is like a diverging Newton iteration: its rounding error is larger than the model.
    for (const double far : {5.0, 1e4, 1e24})
      for (int k = 0; k < 12; ++k) {
        const auto d = direction(system, t, 55 + k);
        residual(system, state_of(mesh, t, far, &d, {1, 1, 1, 0, 0}), t.h);
        EXPECT_EQ(residual(system, here, t.h), f) << c.name << ", from " << far;
        system.energy(state_of(mesh, t, far, &d).at_rest());
      }
    system.prepare(t.from.after_step(t.h), 0.3 * t.h);
    residual(system, here, t.h);
    system.prepare(t.from.after_step(t.h), t.h);
    EXPECT_EQ(residual(system, here, t.h), f) << c.name;
    const MatHandle K = tangent(system, t, {1, 3, 7, 0, 0});
    PetscBool equal = PETSC_FALSE;
    check(MatEqual(J.get(), K.get(), &equal));
    EXPECT_TRUE(equal) << c.name;
    system.commit(here.after_step(t.h));
    other.system->commit(here.after_step(t.h));
    const auto a = m.contact->save();
    const auto b = other.contact->save();
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i)
      EXPECT_TRUE(a[i].node == b[i].node && a[i].key == b[i].key && a[i].values == b[i].values) << c.name;
  }
}

TEST(LineContact, TurnsWithTheModel) {
  const Placement at{exp_so3({0.9, -1.3, 0.7}), Vec3(2, -1, 3)};
  for (const LineCase& c : line_cases()) {
    LineModel m(c);
    LineModel turned(c, PETSC_COMM_SELF, at);
    // Rotations of the nodes are given in space, so those of the turned model are turned too.
    const double size = expect_turned(m, turned, at.rotation, 1e-10, c.name);
    EXPECT_GT(size, 5) << c.name;
  }
}

TEST(LineContact, HistoryGoesThroughACheckpoint) {
  for (const LineCase& c : line_cases()) {
    LineModel m(c);
    LineModel copy(c);
    const double h = m.trial.h;
    const State end = state_of(m.system->mesh(), m.trial);
    m.system->commit(end.after_step(h));
    auto records = m.contact->save();
    std::reverse(records.begin(), records.end());
    copy.contact->restore(records);
    EXPECT_EQ(copy.contact->energy(end.after_step(h)).strain, m.contact->energy(end.after_step(h)).strain);
    EXPECT_EQ(copy.contact->energy(end.after_step(h)).friction,
              m.contact->energy(end.after_step(h)).friction);
    EXPECT_EQ(copy.contact->largest_penetration().depth, m.contact->largest_penetration().depth);
    EXPECT_EQ(copy.contact->largest_penetration().node, m.contact->largest_penetration().node);
    for (LineModel* one : {&m, &copy}) {
      one->trial.from = end;
      for (double& u : one->trial.u) u *= 0.1;
      one->system->prepare(end.after_step(h), h);
    }
    const State next = state_of(m.system->mesh(), m.trial);
    EXPECT_EQ(residual(*m.system, next, h), residual(*copy.system, next, h)) << c.name;
  }
}

// Force on an element that lies on a plane, against a hand calculation; equal shares of its two nodes; work
// of a rising plane.
TEST(LineContact, OneElementOnARisingPlane) {
  Mesh mesh;
  mesh.add(Node{0, 0, 1, false});
  mesh.add(Node{0, 2, 1, false});
  mesh.add(Element{0, 0, 1, 0, 2, false});
  mesh.lines = {{0, 2, 0, 1, 2}};
  for (const auto& [basis, force] : {std::pair(model::StiffnessBasis::per_point, 1e5 * 0.02),
                                     std::pair(model::StiffnessBasis::per_length, 2e5 * 0.02),
                                     std::pair(model::StiffnessBasis::per_area, 0.2 * 2e5 * 0.02)}) {
    const LocalMesh l = local_mesh(mesh, NodeRanks::all_of(2), 0, 1);
    const RigidMotion rising({0, 0, 0}, {0, 0, 0}, SteadyLaw{{0.1, 0, 0.2}, {0, 0, 1}, 0}, 0);
    ContactVolume v;
    v.surface = std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ());
    v.body = 0;
    v.settings.basis = basis;
    v.settings.normal_stiffness = 1e5;
    v.settings.friction = {0.3, 0.3, 0, 4e4};
    LineVolumeContact term(l, std::make_shared<const Bodies>(std::vector<RigidMotion>{rising}), {v},
                           {{0.1, 50}});
    State s(2);
    s.x = {Vec3(0, 0, 0.12), Vec3(2, 0, 0.12)};
    const double h = 1e-3;
    for (int i = 1; i <= 200; ++i) {
      term.prepare(s.after_step(h), h);
      s.time = i * h;
      term.commit(s.after_step(h));
    }
    const auto at = s.after_step(h);
    const Energy e = term.energy(at);
    EXPECT_NEAR(term.largest_penetration().depth, 0.02, 1e-12);
    EXPECT_NEAR(e.work, e.strain + e.friction + e.damping, 1e-3 * e.work);
    EXPECT_GT(e.friction, 0.01 * e.work);
    const auto normal = node_field(term, at, "contact_normal_force", 2);
    EXPECT_NEAR(normal[0], force / 2, 1e-9 * force);
    EXPECT_NEAR(normal[1], force / 2, 1e-9 * force);
    const auto friction = node_field(term, at, "friction_force", 2);
    // Carried along by 10 mm since the first touch, tangential stiffness 0.4 of the normal stiffness.
    EXPECT_NEAR(friction[0], 0.4 * force / 2 * (0.010 / 0.020), 0.005 * force);
    EXPECT_NEAR(node_field(term, at, "penetration", 2)[1], 0.02, 1e-12);
    term.enable_friction(false);
    term.prepare(s.after_step(h), h);
    term.commit(s.after_step(h));
    EXPECT_EQ(node_field(term, at, "friction_force", 2)[0], 0);
  }
}

// The step limit ends a step before a penetration becomes too large, resolves an impact in time, and does not
// affect a line that is laid down slowly.
TEST(LineContact, StepsFollowImpacts) {
  Mesh mesh;
  mesh.add(Node{0, 0, 1, false});
  mesh.add(Node{0, 2, 1, false});
  mesh.add(Element{0, 0, 1, 0, 2, false});
  mesh.lines = {{0, 2, 0, 1, 2}};
  const LocalMesh l = local_mesh(mesh, NodeRanks::all_of(2), 0, 1);
  ContactVolume v;
  v.surface = std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ());
  v.settings.basis = model::StiffnessBasis::per_length;
  v.settings.normal_stiffness = 1e5;
  v.settings.smoothing = 1e-3;
  const double followed = 2 * M_PI / 25 * std::sqrt(50 / 1e5);
  const double infinite = std::numeric_limits<double>::infinity();
  const auto longest = [&](double gap, double down, double tilt = 0, double acceleration = 0) {
    LineVolumeContact term(l, nullptr, {v}, {{0.1, 50}});
    State s(2);
    s.x = {Vec3(0, 0, 0.101 + gap), Vec3(2, 0, 0.101 + gap + tilt)};
    s.v = {Vec3(3, 0, -down), Vec3(3, 0, -down)};
    s.a = {Vec3(0, 0, acceleration), Vec3(0, 0, acceleration)};
    term.prepare(s.after_step(0.1), 0.1);
    if (gap < 0) {
      term.commit(s.after_step(0.1));
      term.prepare(s.after_step(0.1), 0.1);
    }
    ImpactEvents to;
    term.limit_step(s.after_step(0.1), to);
    LineMotion line;
    for (const ImpactEvent& impact : to.list) line.impact_energy += impact.energy();
    const auto alone = [](std::span<double>) {};
    return std::min(to.longest,
                    impact_limited_step(to.list, energy_tolerance({&line, 1}, 1), 10, alone).longest);
  };
  EXPECT_EQ(longest(0.2, 0), infinite);
  EXPECT_EQ(longest(0.2, -1), infinite);
  EXPECT_NEAR(longest(0.2, 0.5, 0.1), 0.2 / 0.5, 2e-4);  // up to the first touch
  EXPECT_NEAR(longest(0.2, 10), 0.2 / 10, 1e-5);
  EXPECT_NEAR(longest(1e-4, 10), 0.05 / 10, 1e-4);  // in contact almost at once: at most half a radius deep
  EXPECT_NEAR(longest(-0.01, 0.5), followed, 1e-6);
  EXPECT_NEAR(longest(-0.002, -0.5), 0.002 / 0.5, 2e-5);  // separates: up to the end of contact
  EXPECT_NEAR(longest(-0.005, -0.5), 0.005 / 0.5 / 2, 2e-5);
  // A speed of 0.04 m/s gives a penetration of 0.9 mm, less than the ramp.
  EXPECT_NEAR(longest(0.2, 0.04), (0.2 + 0.05) / 0.04, 1e-12);
  EXPECT_NEAR(longest(-0.01, 0.04), 0.05 / 0.04, 1e-12);
  // At the turning point the speed is zero. 1 m/s² is 0.5 mm from equilibrium, 3 m/s² 1.5 mm.
  EXPECT_EQ(longest(-0.01, 0, 0, 1), infinite);
  EXPECT_NEAR(longest(-0.01, 0, 0, 3), followed, 1e-6);
  EXPECT_NEAR(longest(-0.01, 0, 0, -3), followed, 1e-6);
  // Between impacts the vibration has the same frequency in both directions; the time to the next touch may
  // be longer.
  EXPECT_NEAR(longest(0.2, -0.5, 0, 3), followed, 1e-6);
  EXPECT_GT(longest(0.2, 0.5, 0, 3), followed);
}

TEST(LineContact, RefusesWhatItCannotUse) {
  SuiteModel m;
  const LocalMesh& l = m.system->mesh();
  ContactVolume v;
  v.surface = std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ());
  v.settings.basis = model::StiffnessBasis::per_length;
  v.settings.normal_stiffness = 1e5;
  const std::vector<LineContactElement> elements(l.elements.size());
  EXPECT_NO_THROW(LineVolumeContact(l, nullptr, {v}, elements));
  EXPECT_THROW(LineVolumeContact(l, nullptr, {v}, {}), std::invalid_argument);
  v.body = 0;
  EXPECT_THROW(LineVolumeContact(l, nullptr, {v}, elements), std::invalid_argument);
  v.body = -1;
  v.settings.basis = model::StiffnessBasis::automatic;
  EXPECT_THROW(LineVolumeContact(l, nullptr, {v}, elements), std::invalid_argument);
}

}  // namespace
}  // namespace hawser::test::line_contact_test
