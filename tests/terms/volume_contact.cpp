#include "hawser/terms/volume_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "hawser/math/so3.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser::volume_contact_test {
namespace {

// ---- the kernel ------------------------------------------------------------------------------------------

// Distance field of a sphere of radius 2 about the origin less a line radius of 0.1, or of the plane z = 0.
ContactTrial on_sphere(const Vec3& y, const Vec3& u) {
  ContactTrial t;
  const double r = y.norm();
  t.point = y;
  t.velocity = u;
  t.gap = r - 2.1;
  t.normal = y / r;
  t.curvature = (Mat3::Identity() - t.normal * t.normal.transpose()) / r;
  return t;
}
ContactTrial on_plane(const Vec3& y, const Vec3& u) { return {y, u, y.z(), Vec3::UnitZ(), Mat3::Zero()}; }

using Field = std::function<ContactTrial(const Vec3&, const Vec3&)>;

struct Situation {
  const char* name;
  Field field;
  ContactStart start;
  Vec3 point;
  bool slides;
};

std::vector<Situation> situations() {
  const Vec3 n = Vec3(0.3, -0.4, 1).normalized();
  const Vec3 s = 2e-3 * n.cross(Vec3(1, 0.2, 0)).normalized();
  ContactStart touching{2.095 * n, -0.005, Vec3(1, 0.5, 0.2).normalized(), s, n};
  ContactStart away{2.12 * n, 0.02, Vec3(1, 0.5, 0.2).normalized(), Vec3::Zero(), Vec3::UnitZ()};
  ContactStart facet{
      {0, 0, -0.01}, -0.01, Vec3(1, 0.5, 0.2).normalized(), s, n};  // last step's facet was tilted
  return {{"stick", on_sphere, touching, 2.095 * n + Vec3(1e-3, 5e-4, -3e-4), false},
          {"slip", on_sphere, touching, 2.095 * n + Vec3(0.02, 0.03, -0.005), true},
          {"in the ramp", on_sphere, touching, 2.1005 * n + Vec3(1e-4, 2e-4, 0), false},
          {"first touch", on_sphere, away, 2.095 * n + Vec3(3e-3, -2e-3, 1e-4), false},
          {"first touch, slip", on_sphere, away, 2.095 * n + Vec3(-0.06, 0.08, 0.04), true},
          {"facet change", on_plane, facet, {5e-4, 1e-3, -0.008}, false},
          {"facet change, slip", on_plane, facet, {0.05, 0.03, -0.008}, true}};
}

std::vector<ContactLaw> laws() {
  static const std::vector<ForceTable::Row> rows{{0.003, 1000}, {0.006, 3500}, {0.02, 30000}};
  static const ForceTable table(rows);
  const NormalLaw normal{1e6, 1e-3, 2e3}, by_table{table.largest_slope(), 0, 2e3, &table};
  std::vector<ContactLaw> out;
  for (const NormalLaw& n : {normal, by_table}) {
    out.push_back({n, {}});
    for (const FrictionReturn back : {FrictionReturn::radial, FrictionReturn::associated})
      for (const double speed : {0.0, 0.3}) {
        std::vector<FrictionLaw> f{{0.4, 0.4, 3e5, 0, 0},
                                   {0.3, 0.8, 3e5, 0, 0},
                                   {0.4, 0.4, 0, 0.006, 0.006},
                                   {0.3, 0.8, 0, 0.005, 0.009},
                                   {0.3, 0.8, 0, 0.005, 0.009}};
        f.back().spring = FrictionSpring::michalopoulos;
        for (FrictionLaw& law : f) {
          law.back = back;
          law.blend_speed = speed;
          law.axial_kinetic = 0.6 * law.axial, law.lateral_kinetic = 0.6 * law.lateral;
          out.push_back({n, law});
        }
      }
  }
  return out;
}

// Taylor test: |F(y + h d) - F(y) - h K d| falls as h², and the fourth-order difference agrees with K d.
void expect_tangent(const std::function<Vec3(const Vec3&)>& F, const Mat3& K, double size,
                    const std::string& what) {
  for (const Vec3& d : {Vec3(0.5, 0.7, -0.4), Vec3(-0.8, 0.1, 0.5), Vec3(0.1, -0.9, -0.3)}) {
    const double h = 2e-4 * size;
    const Vec3 difference = (8 * (F(h * d) - F(-h * d)) - (F(2 * h * d) - F(-2 * h * d))) / (12 * h);
    EXPECT_LT((difference - K * d).norm(), 1e-7 * (K.norm() + 1)) << what;
    const double e1 = (F(4 * h * d) - F(Vec3::Zero()) - 4 * h * K * d).norm();
    const double e2 = (F(2 * h * d) - F(Vec3::Zero()) - 2 * h * K * d).norm();
    if (e2 > 1e-9 * K.norm() * h) {
      EXPECT_GT(e1 / e2, 3.5) << what;
    }
  }
}

TEST(VolumeContactKernel, TangentIsExact) {
  const Vec3 u(0.3, -0.2, -0.15);
  for (const ContactLaw& law : laws())
    for (const Situation& s : situations()) {
      const PointContact c = volume_contact(law, s.start, s.field(s.point, u), true);
      if (law.normal.table && s.field(s.point, u).gap >= 0) continue;  // no ramp before a table
      ASSERT_GT(c.normal.force, 0) << s.name;
      // The mobilisation laws cut at a length, the spring laws at a force; the situations suit both.
      if (law.friction.active() && std::string(s.name).find("slip") != std::string::npos) {
        EXPECT_TRUE(c.slides) << s.name;
      }
      expect_tangent(
          [&](const Vec3& d) { return volume_contact(law, s.start, s.field(s.point + d, u), false).force; },
          c.by_point, 0.02, std::string(s.name) + " by point");
      expect_tangent(
          [&](const Vec3& d) { return volume_contact(law, s.start, s.field(s.point, u + d), false).force; },
          c.by_velocity, 1, std::string(s.name) + " by velocity");
      EXPECT_LT((c.force - volume_contact(law, s.start, s.field(s.point, u), false).force).norm(),
                1e-14 * c.force.norm());
    }
}

TEST(VolumeContactKernel, TurnsWithTheBody) {
  const Quat Q = exp_so3({0.7, -1.1, 0.4});
  const Mat3 R = Q.toRotationMatrix();
  for (const ContactLaw& law : laws())
    for (const Situation& s : situations()) {
      const ContactTrial t = s.field(s.point, {0.3, -0.2, -0.15});
      const ContactStart a = s.start;
      const PointContact plain = volume_contact(law, a, t, true);
      const ContactStart turned_start{R * a.point, a.gap, R * a.tangent, R * a.slip, R * a.normal};
      const PointContact turned = volume_contact(
          law, turned_start,
          {R * t.point, R * t.velocity, t.gap, R * t.normal, R * t.curvature * R.transpose()}, true);
      EXPECT_LE((turned.force - R * plain.force).norm(), 1e-12 * plain.force.norm()) << s.name;
      EXPECT_LT((turned.slip - R * plain.slip).norm(), 1e-15) << s.name;
      EXPECT_LE((turned.by_point - R * plain.by_point * R.transpose()).norm(), 1e-11 * plain.by_point.norm())
          << s.name;
    }
}

TEST(VolumeContactKernel, FacetChangeKeepsTheSlip) {
  const ContactLaw law{{1e6, 0, 0}, {0.9, 0.9, 1e5, 0, 0}};
  const Vec3 n(0, std::sin(0.2), std::cos(0.2));
  const Vec3 s(3e-3, 0, 0);  // along the edge between the facets: keeps its direction
  const ContactStart start{{0, 0, -0.01}, -0.01, Vec3::UnitX(), s, n};
  const PointContact c = volume_contact(law, start, on_plane({0, 0, -0.01}, Vec3::Zero()), false);
  EXPECT_LT((c.slip - s).norm(), 1e-16);
  const ContactStart across{{0, 0, -0.01}, -0.01, Vec3::UnitX(), n.cross(Vec3(3e-3, 0, 0)), n};
  const PointContact d = volume_contact(law, across, on_plane({0, 0, -0.01}, Vec3::Zero()), false);
  EXPECT_LT((d.slip - Vec3(0, 3e-3, 0)).norm(), 1e-16);  // turned, not shortened
}

// Only the part of the motion after the touch counts: half of it, when the surface was met half way.
TEST(VolumeContactKernel, FirstTouch) {
  const ContactLaw law{{1e6, 0, 0}, {0.9, 0.9, 1e5, 0, 0}};
  const ContactStart start{{0, 0, 0.01}, 0.01, Vec3::UnitX(), Vec3::Zero(), Vec3::UnitZ()};
  const PointContact c = volume_contact(law, start, on_plane({4e-3, 0, -0.01}, Vec3::Zero()), false);
  EXPECT_LT((c.slip - Vec3(2e-3, 0, 0)).norm(), 1e-17);
  EXPECT_LT((c.force - Vec3(-200, 0, 1e4)).norm(), 1e-9);
}

// ---- the term ------------------------------------------------------------------------------------------

// Two cable nodes, one element of 1 m; the second is far from everything.
struct Model {
  Mesh mesh;
  LocalMesh local;
  State state{2}, next{2};

  Model() {
    mesh.nodes = {{0, 0, 0.5, false}, {0, 1, 0.5, false}};
    mesh.elements = {{0, 0, 1, 0, 1, false}};
    mesh.lines = {{0, 2, 0, 1, 1, "line"}};
    local.mesh = &mesh;
    local.owned = 2;
    local.global = {0, 1};
    local.block = {0, 1};
    local.owned_blocks = 2;
    local.global_block = {0, 1};
    local.elements = {{0, 1, 0, true}};
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

const ContactNode kNode{0.1, 50};  // radius, mass

RigidMotion turning() {
  return {{1, 2, 3}, {0.3, -0.2, 0.5}, SteadyLaw{{0.2, -0.1, 0.3}, {1, 2, -2}, 0.4}, 0};
}

TEST(VolumeContact, TangentOnATurningCylinder) {
  Model m;
  const auto bodies = std::make_shared<const Bodies>(std::vector<RigidMotion>{turning()});
  for (double offset : {0.0, 0.03}) {  // sticks, slides
    VolumeContact term(m.local, bodies,
                       {volume(std::make_shared<CylinderSurface>(Vec3(0, -3, 0), Vec3(0, 3, 0), 2), 0)},
                       {kNode, kNode});
    const double t0 = 1, h = 0.05;
    const RigidPose start = bodies->pose(0, t0), end = bodies->pose(0, t0 + h);
    const Vec3 y = 2.09 * Vec3(0.6, 0, 0.8) + Vec3(0, 0.4, 0);
    m.state.time = t0;
    m.state.x = {start.to_space(y), Vec3(50, 50, 50)};
    m.state.v = {start.velocity_at(m.state.x[0]), Vec3::Zero()};
    term.prepare(m.state.view(0), h);
    ASSERT_EQ(term.candidates(), 1);
    m.next = m.state;
    m.next.time = t0 + h;
    m.next.x[0] = end.to_space(y + Vec3(1e-3, 2e-3 + offset, -1e-3));
    m.next.v[0] = end.velocity_at(m.next.x[0]) + Vec3(0.1, -0.2, 0.05);
    const VolumeContact::Force f = term.force(m.next.view(h), 0, true);
    ASSERT_TRUE(f.touches);
    EXPECT_GT(f.friction.norm(), 1);
    const auto moved = [&](const Vec3& dx, const Vec3& dv) {
      State s = m.next;
      s.x[0] += dx;
      s.v[0] += dv;
      return Vec3(-term.force(s.view(h), 0, false).total);
    };
    expect_tangent([&](const Vec3& d) { return moved(d, Vec3::Zero()); }, f.K, 0.02, "K");
    expect_tangent([&](const Vec3& d) { return moved(Vec3::Zero(), d); }, f.C, 1, "C");
    EXPECT_GT(f.K.norm(), 1e4);
    EXPECT_GT(f.C.norm(), 100);
    EXPECT_EQ((f.total - term.force(m.next.view(h), 0, true).total).norm(), 0);  // repeatable
    // In statics velocities don't count.
    EXPECT_EQ(term.force(m.next.view(0), 0, true).C.norm(), 0);
  }
}

// Through the assembler: J = K + wC C is the derivative of the residual along (dx, dv = wC dx).
TEST(VolumeContact, AssembledTangent) {
  Model m;
  System system(PETSC_COMM_SELF, m.local);
  ContactVolume v = volume(std::make_shared<CylinderSurface>(Vec3(0, -3, 0), Vec3(0, 3, 0), 2), 0);
  system.add(std::make_unique<VolumeContact>(
      system.mesh(), std::make_shared<const Bodies>(std::vector<RigidMotion>{turning()}), std::vector{v},
      std::vector{kNode, kNode}));
  const RigidPose pose = turning().at(0);
  m.state.x = {pose.to_space(2.09 * Vec3(0.6, 0.1, 0.8)), pose.to_space(2.085 * Vec3(-0.6, 0.2, 0.8))};
  m.state.v = {pose.velocity_at(m.state.x[0]), pose.velocity_at(m.state.x[1])};
  const double h = 0.01, wC = 50;
  system.prepare(m.state.view(0), h);
  m.state.time = h;
  for (int n = 0; n < 2; ++n) m.state.x[static_cast<size_t>(n)] += h * m.state.v[static_cast<size_t>(n)];
  MatHandle J = system.create_matrix();
  Weights weights;
  weights.C = wC;
  system.tangent(m.state.view(h), weights, std::vector<double>(6, 0.0), false, J.get());
  VecHandle r = system.create_vector(), d = system.create_vector(), product = system.create_vector();
  const double direction[6] = {0.3, -0.5, 0.7, -0.2, 0.9, 0.4};
  for (PetscInt i = 0; i < 6; ++i) check(VecSetValue(d.get(), i, direction[i], INSERT_VALUES));
  check(MatMult(J.get(), d.get(), product.get()));
  const auto at = [&](double step) {
    State s = m.state;
    for (size_t n = 0; n < 2; ++n) {
      const Vec3 dx = step * Eigen::Map<const Vec3>(direction + 3 * n);
      s.x[n] += dx;
      s.v[n] += wC * dx;
    }
    system.residual(s.view(h), r.get());
    std::array<double, 6> values{};
    for (PetscInt i = 0; i < 6; ++i) check(VecGetValues(r.get(), 1, &i, &values[static_cast<size_t>(i)]));
    return values;
  };
  const double e = 1e-5;
  const auto a = at(e), b = at(-e), c = at(2 * e), f = at(-2 * e);
  for (size_t i = 0; i < 6; ++i) {
    const PetscInt row = static_cast<PetscInt>(i);
    double value = 0;
    check(VecGetValues(product.get(), 1, &row, &value));
    EXPECT_NEAR(value, (8 * (a[i] - b[i]) - (c[i] - f[i])) / (12 * e), 1e-6 * 1e5);
    EXPECT_GT(std::abs(value), 1e3);
  }
}

// A node that rides on the turning body: what sticks stays stuck, whatever the body does.
TEST(VolumeContact, IsCarriedByItsBody) {
  Model m;
  const auto bodies = std::make_shared<const Bodies>(std::vector<RigidMotion>{turning()});
  VolumeContact term(m.local, bodies,
                     {volume(std::make_shared<CylinderSurface>(Vec3(0, -3, 0), Vec3(0, 3, 0), 2), 0)},
                     {kNode, {0, 50}});
  const Vec3 y0 = 2.09 * Vec3(0.6, 0, 0.8), side(0, 3e-3, 0);
  const double h = 0.1;
  double magnitude = 0;
  for (int i = 0; i <= 100; ++i) {
    const RigidPose pose = bodies->pose(0, i * h);
    if (i > 0) term.prepare(m.state.view(h), h);
    m.state.time = i * h;
    m.state.x[0] = pose.to_space(i < 2 ? y0 : y0 + side);
    m.state.v[0] = pose.velocity_at(m.state.x[0]);
    if (i == 0) continue;
    term.commit(m.state.view(h));
    if (i == 2) magnitude = 4e4 * side.norm();
    const VolumeContact::Force f = term.force(m.state.view(h), 0, false);
    EXPECT_NEAR((f.total - f.friction).norm(), 1e5 * 0.01, 1e-6);
    EXPECT_NEAR(f.friction.norm(), magnitude, 1e-7) << i;
  }
  EXPECT_NEAR(term.largest_penetration().depth, 0.01, 1e-12);
  EXPECT_EQ(term.largest_penetration().node, 0);
  EXPECT_EQ(term.touching(), 1);
  // Only friction and its body work here: the spring in the tangent plane took what the sideways push gave.
  EXPECT_NEAR(term.energy(m.state.view(h)).friction, 0.5 * 4e4 * 9e-6, 1e-3);
}

// Pushed over a plane with given motion: work of the spring, of friction and of damping by hand.
TEST(VolumeContact, Energy) {
  Model m;
  ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()));
  VolumeContact term(m.local, nullptr, {v}, {kNode, kNode});
  m.state.x = {Vec3(0, 0, 0.2), Vec3(0, 50, 50)};
  const double h = 1e-3, k = 1e5, c = contact_damping(0.1, 1e5, 50);
  // Down to 0.02 m penetration in 0.12 s, then sideways by 0.5 m at 1 m/s.
  Vec3 friction = Vec3::Zero();
  for (int i = 1; i <= 620; ++i) {
    term.prepare(m.state.view(h), h);
    const double t = i * h;
    m.state.time = t;
    m.state.v[0] = t <= 0.12 + 1e-12 ? Vec3(0, 0, -1) : Vec3(0, 1, 0);
    m.state.x[0] = t <= 0.12 + 1e-12 ? Vec3(0, 0, 0.2 - t) : Vec3(0, t - 0.12, 0.08);
    const VolumeContact::Force f = term.force(m.state.view(h), 0, false);
    friction = f.friction;
    term.commit(m.state.view(h));
  }
  const Energy e = term.energy(m.state.view(h));
  EXPECT_NEAR(e.strain, k * (0.02 * 0.02 / 2 + 1e-6 / 6), 1e-9);
  EXPECT_NEAR(friction.y(), -0.3 * k * 0.02, 1e-9);
  EXPECT_NEAR(e.damping, c * 1 * 0.02, 0.03 * c * 0.02);  // a ramp of 1 mm is a step of the test
  const double elastic = 0.3 * k * 0.02 / 4e4;            // slip at which it slides
  EXPECT_NEAR(e.friction, 0.3 * k * 0.02 * (0.5 - elastic / 2), 0.01 * 300);
  EXPECT_EQ(e.work, 0);
  EXPECT_NEAR(term.largest_penetration().depth, 0.02, 1e-12);

  FieldRegistry registry;
  term.fields(registry);
  for (const FieldSource& f : registry.sources()) {
    std::vector<double> values(static_cast<size_t>(2 * f.components), -1);
    f.fill(m.state.view(h), values);
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

// A plane that rises under a held node: all that it brings in is in the spring and the damper.
TEST(VolumeContact, WorkOfTheBody) {
  Model m;
  const RigidMotion rising({0, 0, 0}, {0, 0, 0}, SteadyLaw{{0.1, 0, 0.2}, {0, 0, 1}, 0}, 0);
  ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()), 0);
  VolumeContact term(m.local, std::make_shared<const Bodies>(std::vector<RigidMotion>{rising}), {v},
                     {kNode, kNode});
  m.state.x = {Vec3(0, 0, 0.12), Vec3(0, 50, 50)};
  const double h = 1e-3;
  for (int i = 1; i <= 200; ++i) {
    term.prepare(m.state.view(h), h);
    m.state.time = i * h;
    term.commit(m.state.view(h));
  }
  const Energy e = term.energy(m.state.view(h));
  EXPECT_NEAR(term.largest_penetration().depth, 0.02, 1e-12);
  EXPECT_NEAR(e.work, e.strain + e.damping + e.friction, 1e-3 * e.work);
  EXPECT_GT(e.strain, 10);
  EXPECT_GT(e.friction, 1);
}

// Model and line turned together: forces turn.
TEST(VolumeContact, TurnsWithEverything) {
  const Mat3 Q = exp_so3({0.4, 1.3, -0.8}).toRotationMatrix();
  Vec3 plain = Vec3::Zero();
  for (bool turned : {false, true}) {
    const Mat3 R = turned ? Q : Mat3(Mat3::Identity());
    Model m;
    ContactVolume v = volume(std::make_shared<CylinderSurface>(R * Vec3(0, -3, 0), R * Vec3(0, 3, 0), 2));
    v.settings.friction = {0.3, 0.1, 0.004, 0};
    VolumeContact term(m.local, nullptr, {v}, {kNode, kNode});
    m.state.x = {R * Vec3(2.09 * 0.6, 0.4, 2.09 * 0.8), R * Vec3(2.5, 1, 1.7)};
    term.prepare(m.state.view(0), 0.1);
    m.next = m.state;
    m.next.x[0] += R * Vec3(1e-3, 3e-3, -2e-3);
    const Vec3 f = term.force(m.next.view(0.1), 0, false).total;
    if (!turned) plain = f;
    EXPECT_LT((f - R * plain).norm(), 1e-10 * f.norm());
    EXPECT_GT(f.norm(), 100);
  }
}

TEST(VolumeContact, HistoryGoesThroughACheckpoint) {
  Model m;
  const ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()));
  VolumeContact term(m.local, nullptr, {v}, {kNode, kNode}), copy(m.local, nullptr, {v}, {kNode, kNode});
  m.state.x = {Vec3(0, 0, 0.09), Vec3(0, 1, 0.095)};
  const double h = 0.01;
  for (int i = 1; i <= 3; ++i) {
    term.prepare(m.state.view(h), h);
    m.state.time = i * h;
    m.state.x[0] += Vec3(2e-3, 1e-3, -1e-3);
    m.state.x[1] += Vec3(0.2, 0.1, -1e-3);
    term.commit(m.state.view(h));
  }
  auto records = term.save();
  ASSERT_EQ(records.size(), 4u);
  std::reverse(records.begin(), records.end());
  copy.restore(records);
  for (VolumeContact* t : {&term, &copy}) t->prepare(m.state.view(h), h);
  m.state.time += h;
  m.state.x[0] += Vec3(1e-4, -3e-4, 0);
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(
        (term.force(m.state.view(h), i, false).total - copy.force(m.state.view(h), i, false).total).norm(),
        0);
  for (VolumeContact* t : {&term, &copy}) t->commit(m.state.view(h));
  EXPECT_EQ(term.energy(m.state.view(h)).friction, copy.energy(m.state.view(h)).friction);
  EXPECT_EQ(term.energy(m.state.view(h)).strain, copy.energy(m.state.view(h)).strain);
  EXPECT_EQ(term.largest_penetration().depth, copy.largest_penetration().depth);
  EXPECT_EQ(copy.largest_penetration().node, term.largest_penetration().node);
}

TEST(VolumeContact, FrictionCanBeOffAndFarPairsAreNoCandidates) {
  Model m;
  const ContactVolume v = volume(std::make_shared<CylinderSurface>(Vec3(0, -3, 0), Vec3(0, 3, 0), 2));
  VolumeContact term(m.local, nullptr, {v}, {kNode, kNode});
  m.state.x = {Vec3(0, 0, 2.09), Vec3(0, 0, 4)};
  term.prepare(m.state.view(0), 0.01);
  EXPECT_EQ(term.candidates(), 1);
  m.state.v[1] = Vec3(0, 0, -100);  // comes down within two steps
  term.prepare(m.state.view(0), 0.01);
  EXPECT_EQ(term.candidates(), 2);
  term.prepare(m.state.view(0), 0);  // statics: anything may move anywhere
  EXPECT_EQ(term.candidates(), 2);
  m.next = m.state;
  m.next.x[0] += Vec3(0, 1e-3, 0);
  m.next.x[1] = Vec3(0, 0, 2.08);
  EXPECT_GT(term.force(m.next.view(0), 0, false).friction.norm(), 1);
  EXPECT_NEAR(term.force(m.next.view(0), 1, false).total.z(), 2000, 1e-6);
  m.next.x[1] = Vec3(0, 0, 4);  // away and back: the cached distance does not hide it
  EXPECT_EQ(term.force(m.next.view(0), 1, false).total.z(), 0);
  m.next.x[1] = Vec3(0, 0, 2.07);
  EXPECT_NEAR(term.force(m.next.view(0), 1, false).total.z(), 3000, 1e-6);
  term.enable_friction(false);
  EXPECT_EQ(term.force(m.next.view(0), 0, false).friction.norm(), 0);
  EXPECT_GT(term.force(m.next.view(0), 0, false).total.norm(), 100);
}

TEST(VolumeContact, StiffnessByBasis) {
  for (const auto& [basis, force] : {std::pair(model::StiffnessBasis::per_point, 1000.0),
                                     std::pair(model::StiffnessBasis::per_length, 500.0),
                                     std::pair(model::StiffnessBasis::per_area, 100.0)}) {
    Model m;
    ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()));
    v.settings.basis = basis;
    VolumeContact term(m.local, nullptr, {v}, {kNode, kNode});
    m.state.x = {Vec3(0, 0, 0.09), Vec3(0, 1, 5)};
    term.prepare(m.state.view(0), 0);
    EXPECT_NEAR(term.force(m.state.view(0), 0, false).total.z(), force, 1e-9);
  }
  Model m;
  ContactVolume v = volume(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ()));
  v.settings.basis = model::StiffnessBasis::automatic;
  EXPECT_THROW(VolumeContact(m.local, nullptr, {v}, {kNode, kNode}), std::invalid_argument);
  v.settings.basis = model::StiffnessBasis::per_point;
  EXPECT_THROW(VolumeContact(m.local, nullptr, {v}, {kNode}), std::invalid_argument);
  v.body = 0;
  EXPECT_THROW(VolumeContact(m.local, nullptr, {v}, {kNode, kNode}), std::invalid_argument);
}

}  // namespace
}  // namespace hawser::volume_contact_test
