// The seabed at single nodes: friction along given paths against the published formulas, the forces on a
// plane bed given as a formula, a grid or a mesh, and touchdown.
#include <gtest/gtest.h>

#include "hawser/geometry/ground.hpp"
#include "hawser/geometry/height_grid.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/bed_contact.hpp"
#include "support/taylor_cases.hpp"

namespace hawser::test::seabed_test {
namespace {

// Two nodes 1 m apart along x; only the first is in contact with the bed.
struct OneNode {
  Mesh mesh;
  LocalMesh local;
  std::unique_ptr<BedContact> bed;
  State state;
  double h = 0.1;

  template <class Bed>
  OneNode(const Bed& shape, const BedContact::PointLaw& law) {
    for (int i = 0; i < 2; ++i) mesh.add(Node{0, 1.0 * i, 0.5, false});
    mesh.add(Element{0, 0, 1, 0, 1.0, false});
    LineSpan span;
    span.nodes = 2;
    span.elements = 1;
    span.length = 1;
    mesh.lines.push_back(span);
    local = local_mesh(mesh, NodeRanks::all_of(2), 0, 1);
    BedContact::PointLaw none;
    none.radius = -1;
    bed = std::make_unique<BedContact>(local, shape, BedContact::PointLaws{{law, none}, {}});
    state = State(2);
  }
  // Commits a step to x; returns the friction force on the node.
  Vec3 go(const Vec3& x) {
    bed->prepare(state.after_step(h), h);
    state.x[0] = x;
    state.x[1] = x + Vec3::UnitX();
    state.time += h;
    bed->commit(state.after_step(h));
    FieldRegistry fields;
    bed->fields(fields);
    std::vector<double> f(6);
    for (const FieldSource& s : fields.sources())
      if (s.name == "seabed_friction") s.fill(state.after_step(h), f);
    return {f[0], f[1], f[2]};
  }
  double work() const { return bed->energy(state.after_step(h)).friction; }
};

// Normal force 1000 N, coefficients 0.3 and 0.8, mobilisation lengths 0.01 and 0.04 m, as in the paper
// (OMAE2006-92155, eqs 6-10: Michalopoulos' spring, return along the radius).
BedContact::PointLaw paper() {
  BedContact::PointLaw law;
  law.radius = 0.1;
  law.law.normal.stiffness = 1e6;
  FrictionLaw& f = law.law.friction;
  f.axial = 0.3;
  f.lateral = 0.8;
  f.axial_length = 0.01;
  f.lateral_length = 0.04;
  f.spring = FrictionSpring::michalopoulos;
  return law;
}
constexpr double kDeep = 0.1 - 1e-3;  // m, depth of the axis at a normal force of 1000 N

const BedContact::Plane kFlat{Vec3::Zero(), Vec3::UnitZ()};

// Friction force after a displacement in one step from rest. The reference is a separate evaluation of eqs
// 6-10 in Python, double precision.
TEST(SeabedFriction, PaperFormula) {
  const double rows[][4] = {{0.002, 0, 60, 0},
                            {0, 0.01, 0, 200},
                            {0.002, 0.01, 18.836339673824433, 251.1511956509924},
                            {0.005, 0.02, 51.44957554275265, 548.7954724560284},
                            {0.01, 0, 300, 0},
                            {0, 0.04, 0, 800},
                            {0.007, 0.03, 68.16888468192553, 779.0729677934346},
                            {0.02, 0.05, 111.41720290623111, 742.7813527082074},
                            {-0.003, 0.06, -14.981285083167672, 799.0018711022758}};
  for (const auto& r : rows) {
    OneNode n(kFlat, paper());
    n.go({0, 0, kDeep});
    const Vec3 f = n.go({r[0], r[1], kDeep});
    EXPECT_NEAR(f.x(), -r[2], 1e-10) << r[0] << ' ' << r[1];
    EXPECT_NEAR(f.y(), -r[3], 1e-10) << r[0] << ' ' << r[1];
  }
}

// A table of a case per area and per length: a node has its share of the force and of the potential.
TEST(SeabedTable, ForceAndPotentialOfANode) {
  Mesh mesh;
  mesh.add(Node{0, 0, 1, false});
  mesh.add(Node{0, 2, 1, false});
  mesh.add(Element{0, 0, 1, 0, 2, true});
  mesh.lines = {{0, 2, 0, 1, 2}};
  const LocalMesh local = local_mesh(mesh, NodeRanks::all_of(2), 0, 1);
  const std::vector<ContactForceTable::Row> rows{{0.01, 100}, {0.05, 900}, {0.1, 1000}};
  for (const bool by_length : {false, true}) {
    model::Case c;
    c.lines.emplace_back();
    model::LineType& t = c.line_types.emplace_back();
    t.outer_diameter = t.contact_diameter = 0.4;
    t.mass_per_length = 50;
    model::Seabed& bed = c.environment.seabed;
    bed.present = true;
    bed.depth = 90;
    bed.basis = by_length ? model::StiffnessBasis::per_length : model::StiffnessBasis::per_area;
    bed.force_table = std::make_shared<const ContactForceTable>(rows);
    bed.normal_stiffness = bed.force_table->largest_slope();
    const double share = by_length ? 1 : 0.4;  // half of the element
    BedContact term(local, c, {1});
    bed.force_table.reset();  // the term shares this law
    const auto at = [&](double deep, double step) {
      State s(2);
      s.x = {Vec3(0, 0, -90 + 0.2 - deep), Vec3(2, 0, 0)};
      const Kinematics end = at_end(s, step);
      term.prepare(end, step);
      term.commit(end);
      return std::pair(term.node_force(0).z(), term.energy(end).strain);
    };
    EXPECT_EQ(at(-1e-6, 0).first, 0);
    for (const auto& [deep, force] : rows) EXPECT_NEAR(at(deep, 0.1).first, share * force, 1e-9);
    for (const double deep : {0.004, 0.03, 0.07, 0.2}) {
      const double h = 1e-5;
      EXPECT_NEAR(at(deep, 0).first, (at(deep + h, 0).second - at(deep - h, 0).second) / (2 * h), 1e-4)
          << deep;
      EXPECT_EQ(at(deep, 0).second, at(deep, 0.1).second);
    }
  }
}

// Pressed in by 4 mm, lifted, released 10 mm above that, landed again: the pull is at most 500 N; its work;
// and the same results after a restart from a checkpoint.
template <class Bed>
void expect_suction(const Bed& shape) {
  BedContact::PointLaw law;
  law.radius = 0.1;
  law.law.normal.stiffness = 1e5;
  law.suction = {500, 0.01};
  OneNode n(shape, law);
  OneNode copy(shape, law);
  const auto force = [&](double gap, OneNode& of) {
    of.go({0, 0, 0.1 + gap});
    return of.bed->node_force(0).z();
  };
  EXPECT_NEAR(force(-0.004, n), 400, 1e-9);
  EXPECT_NEAR(force(-0.003, n), 300 - 500 * 16 * 0.01 * 0.81, 1e-9);
  copy.bed->restore(n.bed->save());
  copy.state = n.state;
  for (OneNode* of : {&n, &copy}) {
    EXPECT_NEAR(force(0.001, *of), -500, 1e-9);
    EXPECT_NEAR(force(0.004, *of), -500 * 16 * 0.64 * 0.04, 1e-9);
    EXPECT_NEAR(force(-0.004, *of), 400, 1e-9);  // on the same curve
    EXPECT_EQ(force(0.0061, *of), 0);            // released
    EXPECT_EQ(force(0.001, *of), 0);             // no pull remains after the release
    EXPECT_NEAR(force(-0.002, *of), 200, 1e-9);  // lands again
    EXPECT_NEAR(force(0.003, *of), -500, 1e-9);
    EXPECT_EQ(force(0.6, *of), 0);
    EXPECT_EQ(force(0.0001, *of), 0);
  }
  const double before = n.bed->energy(n.state.after_step(n.h)).damping;
  EXPECT_NEAR(force(-0.004, n), 400, 1e-9);
  const double landed = n.bed->energy(n.state.after_step(n.h)).damping;
  EXPECT_EQ(landed, before);
  for (int i = 1; i <= 1000; ++i) force(-0.004 + i * 1.2e-5, n);
  EXPECT_NEAR(n.bed->energy(n.state.after_step(n.h)).damping - landed, 8. / 15 * 500 * 0.01, 1e-6);
}

TEST(SeabedSuction, HoldsWhatIsLiftedUntilItIsFarEnough) {
  expect_suction(kFlat);
  const std::vector<double> at{-2, 0, 2};
  expect_suction(std::shared_ptr<const Surface>(
      std::make_shared<const HeightGrid>(at, at, std::vector<double>(9, 0.0))));
}

struct Leg {
  double x, y, fx, fy, work;
};

// A path of six legs: force at their ends under a normal force of 1000 N, and work so far by the trapezoidal
// rule.
void follow(int steps, const std::vector<Leg>& legs, double tolerance) {
  OneNode n(kFlat, paper());
  n.go({0, 0, kDeep});
  Vec3 from(0, 0, kDeep);
  for (const Leg& l : legs) {
    const Vec3 to(l.x, l.y, kDeep);
    Vec3 f;
    for (int i = 1; i <= steps; ++i) f = n.go(from + (to - from) * i / steps);
    from = to;
    EXPECT_NEAR(f.x(), -l.fx, tolerance * 1000) << l.x << ' ' << l.y;
    EXPECT_NEAR(f.y(), -l.fy, tolerance * 1000) << l.x << ' ' << l.y;
    EXPECT_NEAR(n.work(), l.work, tolerance * l.work) << l.x << ' ' << l.y;
  }
}

// The reference is a separate evaluation of eqs 6-10 in Python, double precision, with one and ten steps a
// leg.
TEST(SeabedFriction, PaperPath) {
  follow(1,
         {{0.006, 0, 180, 0, 0.54},
          {0.006, 0.03, 56.50901902147329, 753.4535869529773, 11.84180380429466},
          {0.02, 0.03, 166.41005886756875, 665.6402354702749, 13.402237349517954},
          {-0.02, 0.03, -272.70895009510326, 333.3848337605079, 15.528215174068643},
          {-0.02, -0.05, -39.16708155928443, -793.152650448142, 33.91892784157401},
          {0, 0, 217.23968167015445, 551.7288912845186, 29.664059863592122}},
         1e-12);
  follow(10,
         {{0.006, 0, 180, 0, 0.54},
          {0.006, 0.03, 56.50901902147329, 753.4535869529773, 15.304011567002503},
          {0.02, 0.03, 208.37374780541083, 575.53302815098, 17.136592151397867},
          {-0.02, 0.03, -295.36980921964425, 140.01081359002268, 22.635038090768095},
          {-0.02, -0.05, -24.25846431851841, -797.3802746891471, 77.44290796758501},
          {0, 0, 223.50698124805086, 533.6307792780967, 64.63415838440208}},
         1e-12);
}

// Against the closed form of the continuous law on each leg, with a thousand steps a leg. A closed loop
// within the ellipse absorbs work in one direction and generates work in the other.
TEST(SeabedFriction, PaperPathInTheLimit) {
  follow(1000,
         {{0.006, 0, 180, 0, 0.54},
          {0.006, 0.03, 56.50901902147329, 753.4535869529773, 15.352591756941342},
          {0.02, 0.03, 216.3698159397399, 554.1542681332817, 17.23930107738766},
          {-0.02, 0.03, -297.8171822576171, 96.3300235512911, 22.892832333284396},
          {-0.02, -0.05, -21.286306363183407, -797.9836507884115, 78.76354995037966},
          {0, 0, 214.25514465833777, 559.9665576518164, 65.80545273062825}},
         1e-3);
  const Vec3 corners[] = {Vec3(0, 0, kDeep), Vec3(0.006, 0, kDeep), Vec3(0.006, 0.025, kDeep),
                          Vec3(0, 0.025, kDeep)};
  for (const bool back : {false, true}) {
    OneNode n(kFlat, paper());
    n.go(corners[0]);
    for (int leg = 0; leg < 4; ++leg) {
      const Vec3& a = corners[back ? (4 - leg) % 4 : leg];
      const Vec3& b = corners[back ? 3 - leg : (leg + 1) % 4];
      for (int i = 1; i <= 2000; ++i) n.go(a + (b - a) * i / 2000);
    }
    EXPECT_NEAR(n.work(), back ? -5.375583661 : 5.375583661, 1e-3);
  }
}

// Back and forth by 3 mobilisation lengths: 4 mu N (D - d) of work a cycle. On a circle, the force lags by
// asin(d/rho) behind the direction of a step, its chord: 2 pi rho mu N sqrt(1 - (d/rho)²) of work a turn.
TEST(SeabedFriction, CyclesAndCircles) {
  BedContact::PointLaw law = paper();
  law.law.friction.axial = law.law.friction.lateral = 0.3;
  law.law.friction.lateral_length = 0.01;
  OneNode n(kFlat, law);
  n.go({0, 0, kDeep});
  const double rows[][2] = {{0.005, 150}, {0.01, 300},   {0.03, 300}, {0.02, 0},
                            {0.01, -300}, {-0.03, -300}, {-0.02, 0},  {-0.01, 300}};
  for (const auto& r : rows) EXPECT_NEAR(n.go({r[0], 0, kDeep}).x(), -r[1], 1e-10) << r[0];
  n.go({0.03, 0, kDeep});
  const double before = n.work();
  for (const double x : {0.01, -0.03, -0.01, 0.03}) n.go({x, 0, kDeep});
  EXPECT_NEAR(n.work() - before, 24, 1e-10);

  law.law.friction.axial = law.law.friction.lateral = 0.5;
  OneNode c(kFlat, law);
  const double rho = 0.05;
  double turn = 0, lag = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = M_PI * i / 1000;
    if (i == 2000) turn = c.work();
    const Vec3 last = c.state.x[0];
    const Vec3 f = c.go({rho * std::cos(angle), rho * std::sin(angle), kDeep});
    const Vec3 way = c.state.x[0] - last;
    lag = way.cross(f).z() / (way.norm() * f.norm());
  }
  EXPECT_NEAR(c.work() - turn, 153.90597961942368, 1e-3 * 153.906);
  EXPECT_NEAR(lag, 0.2, 1e-3 * 0.2);
  EXPECT_NEAR(lag, 0.2 * std::cos(M_PI / 2000), 1e-9);
}

// A node that was lifted and set down elsewhere, within a step or after many steps, starts without friction;
// its former place has no effect. Only the part of the step after the touch contributes.
TEST(SeabedFriction, LandsElsewhere) {
  for (const bool grid : {false, true}) {
    std::vector<double> at{-10, 0, 10}, z(9, 0);
    BedContact::PointLaw law = paper();
    law.law.normal.smoothing = 1e-4;
    const auto run = [&](auto& n) {
      n.go({0, 0, kDeep});
      EXPECT_NEAR(n.go({0.02, 0, kDeep}).x(), -300, 1e-9);
      n.go({0.02, 0, 0.2});
      EXPECT_EQ(n.go({3, 1, 0.2}).norm(), 0);
      const Vec3 landed = n.go({3, 1, kDeep});  // straight down
      EXPECT_EQ(landed.norm(), 0);
      EXPECT_NEAR(n.go({3.002, 1, kDeep}).x(), -60, 1e-9);
      n.go({3, 1, 0.2});
      // Down from 0.1 m above with 0.02 m along: the last (1e-3 + 1e-4)/(0.1 + 1e-3) of the step contributes.
      const double part = (1e-3 + 1e-4) / (0.1 + 1e-3);
      EXPECT_NEAR(n.go({3.02, 1, kDeep}).x(), -0.3 * 1000 * 0.02 * part / 0.01, 1e-6);
    };
    if (grid) {
      OneNode n(std::shared_ptr<const Surface>(std::make_shared<const HeightGrid>(at, at, z)), law);
      run(n);
    } else {
      OneNode n(kFlat, law);
      run(n);
    }
  }
}

// A slope given by a formula, a grid and a mesh: the forces along a path are the same.
TEST(SeabedShapes, SlopesAreTheSame) {
  const auto slope = [](double x, double y) { return -50 + 0.2 * x - 0.1 * y; };
  std::vector<double> at, z;
  for (int i = -3; i <= 5; ++i) at.push_back(7.5 * i);
  TriangleMesh sheet;
  for (const double y : at)
    for (const double x : at) {
      z.push_back(slope(x, y));
      sheet.vertices.push_back({x, y, z.back()});
    }
  const int n = static_cast<int>(at.size());
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const int a = j * n + i;
      // One triangle of each pair is reversed: the bed corrects its orientation.
      sheet.triangles.push_back({a, a + 1, a + n + 1});
      sheet.triangles.push_back({a, a + n, a + n + 1});
    }
  TriangleMesh ground = ground_under(sheet);
  std::vector<bool> active(ground.triangles.size(), false);
  std::fill_n(active.begin(), sheet.triangles.size(), true);
  const BedContact::Plane plane{Vec3(0, 0, -50), Vec3(-0.2, 0.1, 1).normalized()};
  OneNode formula(plane, paper());
  OneNode grid(std::shared_ptr<const Surface>(std::make_shared<const HeightGrid>(at, at, z)), paper());
  OneNode mesh(std::shared_ptr<const Surface>(std::make_shared<const MeshSurface>(ground, active)), paper());
  const Vec3 above = Vec3(0, 15, slope(0, 15)) + 0.3 * plane.normal;
  formula.go(above);
  grid.go(above);
  mesh.go(above);
  for (int i = 0; i < 60; ++i) {
    const double t = 0.1 * i;
    const double x = 20 * std::sin(t);
    const double y = 15 * std::cos(1.7 * t);
    const Vec3 p = Vec3(x, y, slope(x, y)) + (0.0985 + 0.01 * std::sin(3 * t)) * plane.normal;
    const Vec3 f = formula.go(p);
    const Vec3 all = formula.bed->node_force(0);
    EXPECT_LT((grid.go(p) - f).norm(), 1e-6) << i;
    EXPECT_LT((mesh.go(p) - f).norm(), 1e-6) << i;
    EXPECT_LT((grid.bed->node_force(0) - all).norm(), 1e-6) << i;
    EXPECT_LT((mesh.bed->node_force(0) - all).norm(), 1e-6) << i;
  }
}

// Cached neighbours do not change results: the force equals that of a bed without earlier queries.
TEST(SeabedShapes, AnswersDoNotDependOnThePath) {
  const auto bed = hilly();
  BedContact::PointLaw law = paper();
  law.law.friction = {};
  OneNode walker(std::shared_ptr<const Surface>(bed), law);
  int touching = 0;
  for (int i = 0; i < 400; ++i) {
    const double t = 0.37 * i;
    const double x = 4 + 6 * std::sin(t);
    const double y = 3 + 5 * std::cos(1.3 * t);
    const Vec3 p(x, y, bed->at(x, y).z + 0.4 * std::sin(5.1 * t));
    walker.go(p);
    OneNode fresh(std::shared_ptr<const Surface>(bed), law);
    fresh.go(p);
    const Vec3 a = walker.bed->node_force(0);
    const Vec3 b = fresh.bed->node_force(0);
    EXPECT_EQ(a, b) << i;
    touching += a.norm() > 0;
  }
  EXPECT_GT(touching, 100);
  EXPECT_LT(touching, 380);
}

TEST(SeabedShapes, RefusesWhatIsNoSheet) {
  const auto refusal = [](const TriangleMesh& m) -> std::string {
    try {
      ground_under(m);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  TriangleMesh m;
  m.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.9, 0.2, 1)};
  m.triangles = {{0, 1, 2}};
  EXPECT_EQ(refusal(m), "");
  EXPECT_TRUE(inspect(ground_under(m)).valid());
  m.triangles = {{0, 1, 3}};
  EXPECT_NE(refusal(m).find("stands upright"), std::string::npos);
  m.triangles = {{0, 1, 2}, {0, 1, 4}};
  EXPECT_NE(refusal(m).find("folded over itself"), std::string::npos);
  m.triangles = {{0, 1, 2}, {0, 1, 4}, {1, 0, 2}};
  EXPECT_NE(refusal(m).find("more than two triangles"), std::string::npos);
}

// The point half way along an element whose nodes are on two ranks: both ranks have its history, restored
// from the records of either node or of one rank; its energy is counted once.
TEST(SeabedHalfWay, HistoryIsWithBothNodes) {
  Mesh mesh;
  for (int i = 0; i < 2; ++i) mesh.add(Node{0, 1.0 * i, 0.5, false});
  mesh.add(Element{0, 0, 1, 0, 1.0, false});
  mesh.lines = {{0, 2, 0, 1, 1}};
  BedContact::PointLaw none;
  none.radius = -1;
  const double h = 0.1;
  struct Part {
    LocalMesh local;
    std::unique_ptr<BedContact> bed;
    State state{2};
    // Moves the middle point to x under 1000 N.
    void go(double x) {
      bed->prepare(state.after_step(0.1), 0.1);
      for (size_t n = 0; n < 2; ++n) state.x[n] = Vec3(x + local.global[n], 0, kDeep);
      bed->commit(state.after_step(0.1));
    }
    Vec3 force(int node) const { return bed->node_force(local.find(node)); }
  };
  const auto part = [&](const std::vector<int>& owner, int rank) {
    Part p;
    p.local = local_mesh(mesh, owner, rank, owner[1] + 1);
    return p;
  };
  Part all = part({0, 0}, 0);
  Part two[] = {part({0, 1}, 0), part({0, 1}, 1)};
  for (Part* p : {&all, &two[0], &two[1]})
    p->bed = std::make_unique<BedContact>(
        p->local, kFlat,
        BedContact::PointLaws{std::vector(static_cast<size_t>(p->local.owned), none), {paper()}});
  for (Part* p : {&all, &two[0], &two[1]})
    for (const double x : {0.0, 0.004, 0.02, 0.017}) p->go(x);
  const auto points = [](const BedContact& bed) {
    std::vector<CheckpointRecord> records = bed.save();
    std::erase_if(records, [](const CheckpointRecord& r) { return r.kind != 0; });
    return records;
  };
  const std::vector<CheckpointRecord> whole = points(*all.bed);
  EXPECT_EQ(whole.size(), 2u);
  EXPECT_GT(all.bed->energy(all.state.after_step(h)).friction, 1);
  EXPECT_EQ(two[0].bed->energy(two[0].state.after_step(h)).friction +
                two[1].bed->energy(two[1].state.after_step(h)).friction,
            all.bed->energy(all.state.after_step(h)).friction);
  for (int rank = 0; rank < 2; ++rank) {
    Part& p = two[rank];
    EXPECT_EQ(p.force(rank), all.force(rank));
    EXPECT_NEAR(p.force(rank).z(), 500, 1e-9);
    const std::vector<CheckpointRecord> own = points(*p.bed);
    ASSERT_EQ(own.size(), 1u);
    std::vector<CheckpointRecord> of_whole;
    for (const CheckpointRecord& r : whole)
      if (r.node == rank) of_whole.push_back(r);
    ASSERT_EQ(of_whole.size(), 1u);
    EXPECT_EQ(own[0].key, of_whole[0].key);
    EXPECT_EQ(own[0].values, of_whole[0].values);
    const Vec3 before = p.force(rank);
    p.bed->restore({});
    EXPECT_EQ(p.force(rank), Vec3(0, 0, 0));
    p.bed->restore(of_whole);
    EXPECT_EQ(p.force(rank), before);
    p.go(0.018);
  }
  all.go(0.018);
  for (int rank = 0; rank < 2; ++rank) EXPECT_EQ(two[rank].force(rank), all.force(rank));
}

}  // namespace
}  // namespace hawser::test::seabed_test
