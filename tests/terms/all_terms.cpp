// The term suite on one rank: tangents equal finite differences, `evaluate` is repeatable, and forces rotate
// with the model.
#include "support/taylor_cases.hpp"
#include "terms/whole_model.hpp"

namespace hawser::test::suite_test {
namespace {

void expect_same(const std::vector<CheckpointRecord>& a, const std::vector<CheckpointRecord>& b,
                 const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].node, b[i].node) << what;
    EXPECT_EQ(a[i].key, b[i].key) << what;
    EXPECT_EQ(a[i].values, b[i].values) << what;
  }
}

std::vector<std::vector<CheckpointRecord>> history(const System& system) {
  std::vector<std::vector<CheckpointRecord>> out;
  for (const auto& t : system.terms()) out.push_back(t->save());
  return out;
}

std::vector<double> energies(const System& system, const State& s, double h) {
  const Energy e = system.energy(at_end(s, h));
  return {e.kinetic, e.strain, e.potential, e.friction, e.damping, e.work};
}

TEST(Suite, Tangents) {
  for (const SuiteCase& c : all_cases()) {
    const auto m = c.build(PETSC_COMM_SELF, {});
    expect_tangent(*m->system, m->trial, c.name);
  }
}

// Each node has the state of contact that kHistory states: open or in contact, sticking or sliding, in the
// ramp or beyond.
void expect_situations(ContactOn on) {
  SuiteModel m;
  LineVolumeContact& contact = add_contact(m, {}, on, 0.3, 0.3);
  const State s = state_of(m.system->mesh(), m.trial);
  m.system->commit(at_end(s, m.trial.h));
  FieldRegistry registry;
  contact.fields(registry);
  const auto field = [&](const std::string& name) {
    for (const FieldSource& f : registry.sources()) {
      if (f.name != name) continue;
      std::vector<double> values(static_cast<size_t>(8 * f.components));
      f.fill(at_end(s, m.trial.h), values);
      return values;
    }
    return std::vector<double>();
  };
  const auto pressed = field("contact_normal_force");
  const auto rubbed = field("friction_force");
  for (size_t n = 0; n < 8; ++n) {
    const double normal = pressed[n];
    const double friction = Vec3(&rubbed[3 * n]).norm();
    const std::string what =
        "surface " + std::to_string(static_cast<int>(on)) + ", node " + std::to_string(n);
    EXPECT_EQ(normal > 0, n != 0 && n != 7) << what;
    if (!(normal > 0)) continue;
    const bool slides = n == 3 || n == 4 || n == 6;
    const bool ramp = n == 1 || n == 4;
    if (slides)
      EXPECT_NEAR(friction, 0.3 * normal, 1e-9 * normal) << what;
    else
      EXPECT_LT(friction, 0.95 * 0.3 * normal) << what;
    EXPECT_GT(friction, 1e-3 * normal) << what;
    EXPECT_EQ(normal < 50, ramp) << what << ": " << normal << " N";
  }
}

TEST(Suite, ContactSituations) {
  for (const ContactOn on :
       {ContactOn::plane, ContactOn::cylinder, ContactOn::face, ContactOn::edge, ContactOn::vertex})
    expect_situations(on);
}

TEST(Suite, EvaluatingLeavesNoTrace) {
  for (const SuiteCase& c : all_cases()) {
    const auto m = c.build(PETSC_COMM_SELF, {});
    System& system = *m->system;
    const Trial& t = m->trial;
    const LocalMesh& mesh = system.mesh();
    const Weights w{1, 3, 7, 0, 0};
    const State here = state_of(mesh, t);
    const auto before = history(system);
    const auto energy = energies(system, t.from, t.h);
    const auto f = residual(system, here, t.h);
    const MatHandle J = tangent(system, t, w);
    const auto again = [&](const std::string& what) {
      EXPECT_EQ(residual(system, here, t.h), f) << c.name << what;
      const MatHandle K = tangent(system, t, w);
      PetscBool equal = PETSC_FALSE;
      check(MatEqual(J.get(), K.get(), &equal));
      EXPECT_TRUE(equal) << c.name << what;
    };
    again(": twice");
    // Other trials: one near, one so far away that there is no contact.
    for (const double far : {5.0, 1e4}) {
      const auto d = direction(system, t, 55);
      residual(system, state_of(mesh, t, far, &d, {1, 1, 1, 0, 0}), t.h);
    }
    again(": after trials elsewhere");
    // A step is rejected and tried again, first shorter and then as before.
    system.prepare(at_end(t.from, t.h), 0.4 * t.h);
    Trial shorter = t;
    shorter.h *= 0.4;
    for (double& x : shorter.u) x *= 0.4;
    residual(system, state_of(mesh, shorter), shorter.h);
    tangent(system, shorter, w);
    system.prepare(at_end(t.from, t.h), t.h);
    again(": after a rejected step");
    const auto after = history(system);
    ASSERT_EQ(before.size(), after.size());
    for (size_t i = 0; i < before.size(); ++i) expect_same(before[i], after[i], c.name);
    EXPECT_EQ(energies(system, t.from, t.h), energy) << c.name;
  }
}

// A system whose step was rejected and repeated has the same history as one whose step was accepted at once.
TEST(Suite, RejectedStepsLeaveNoTraceInHistory) {
  for (const SuiteCase& c : all_cases()) {
    const auto a = c.build(PETSC_COMM_SELF, {});
    const auto b = c.build(PETSC_COMM_SELF, {});
    const Trial& t = a->trial;
    const LocalMesh& mesh = a->system->mesh();
    const State end = state_of(mesh, t);
    a->system->prepare(at_end(t.from, t.h), 0.3 * t.h);
    const auto d = direction(*a->system, t, 56);
    residual(*a->system, state_of(mesh, t, 3, &d), t.h);
    a->system->prepare(at_end(t.from, t.h), t.h);
    for (const auto& m : {a.get(), b.get()}) m->system->commit(at_end(end, t.h));
    const auto ha = history(*a->system);
    const auto hb = history(*b->system);
    for (size_t i = 0; i < ha.size(); ++i) expect_same(ha[i], hb[i], c.name);
    EXPECT_EQ(energies(*a->system, end, t.h), energies(*b->system, end, t.h)) << c.name;
  }
}

// Forces rotate with the model; moments, in material axes, do not change; energies do not change.
TEST(Suite, TurnsWithTheModel) {
  const Placement at{exp_so3({0.9, -1.3, 0.7}), Vec3(2, -1, 3)};
  for (const SuiteCase& c : all_cases()) {
    if (c.name == "point loads and masses" || c.name == "everything")
      continue;                                 // weight: see LoadsTurnWithTheModel
    if (c.name.starts_with("water")) continue;  // level sea: see WaterTurnsWithTheModelAboutTheVertical
    const auto m = c.build(PETSC_COMM_SELF, {});
    const auto turned = c.build(PETSC_COMM_SELF, at);
    m->system->tie({}, {});
    turned->system->tie({}, {});
    const auto [size, off] = turned_forces(*m, *turned, at.rotation);
    // Contact: additional error of round-off of positions times stiffness.
    EXPECT_LT(off, 1e-12 * size + (c.name.starts_with("contact") || c.name.starts_with("seabed")
                                       ? 2e-14 * kNormalStiffness
                                       : 0))
        << c.name;
    EXPECT_GT(size, 0) << c.name;
  }
}

TEST(Suite, WaterTurnsWithTheModelAboutTheVertical) {
  const Placement at{exp_so3({0, 0, 1.3}), Vec3(2, -1, 0)};
  for (const SuiteCase& c : water_cases()) {
    const auto m = c.build(PETSC_COMM_SELF, {});
    const auto turned = c.build(PETSC_COMM_SELF, at);
    m->system->tie({}, {});
    turned->system->tie({}, {});
    const LocalMesh& mesh = m->system->mesh();
    const auto f = residual(*m->system, state_of(mesh, m->trial), m->trial.h);
    const auto g = residual(*turned->system, state_of(mesh, turned->trial), turned->trial.h);
    double size = 0;
    for (double x : f) size = std::max(size, std::abs(x));
    EXPECT_GT(size, 10) << c.name;
    for (int n = 0; n < mesh.owned; ++n)
      for (int k = 0; k <= mesh.rotates(n); ++k) {
        const size_t i = 3 * static_cast<size_t>(mesh.block[static_cast<size_t>(n)] + k);
        const Eigen::Map<const Vec3> a(f.data() + i);
        const Eigen::Map<const Vec3> b(g.data() + i);
        EXPECT_LT((k ? Vec3(b - a) : Vec3(b - at.rotation * a)).norm(), 1e-12 * size) << c.name;
      }
  }
}

TEST(Suite, LoadsTurnWithTheModel) {
  const Placement at{exp_so3({0.9, -1.3, 0.7}), Vec3(2, -1, 3)};
  SuiteModel m;
  SuiteModel turned(PETSC_COMM_SELF, at);
  add_loads(m, {}, false);
  add_loads(turned, at, false);
  const LocalMesh& mesh = m.system->mesh();
  const auto f = residual(*m.system, state_of(mesh, m.trial), m.trial.h);
  const auto g = residual(*turned.system, state_of(mesh, turned.trial), turned.trial.h);
  for (int n = 0; n < mesh.owned; ++n)
    for (int k = 0; k <= mesh.rotates(n); ++k) {
      const size_t i = 3 * static_cast<size_t>(mesh.block[static_cast<size_t>(n)] + k);
      const Eigen::Map<const Vec3> a(f.data() + i);
      const Eigen::Map<const Vec3> b(g.data() + i);
      EXPECT_LT((k ? Vec3(b - a) : Vec3(b - at.rotation * a)).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace hawser::test::suite_test
