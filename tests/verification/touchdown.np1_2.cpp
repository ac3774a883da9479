// Touchdown points and laid lengths of lines at rest against closed forms, on rigid and on soft ground, for
// touchdown anywhere between nodes; on 1 and 2 ranks.
#include "hawser/record/touchdown.hpp"

#include "hawser/kernels/catenary_on_bed.hpp"
#include "support/rig.hpp"

namespace hawser::test::touchdown_test {
namespace {

constexpr double kWeight = 1000, kHeight = 100;  // N/m, m

// A line of 0.1 m from an anchor `above` its height on the bed to an end `away` from it and kHeight above the
// bed.
model::Case line_on_bed(double length, int elements, double stiffness, double away, double above = 0) {
  model::LineType t = cable_type(1e9, kWeight / 9.81);
  t.outer_diameter = t.contact_diameter = 0.1;
  model::Case c = one_line(t, length, elements, anchor({0, 0, above - kHeight + 0.05}), anchor({away, 0, 0}));
  c.contact.between_lines.enabled = false;  // so that the line is cut between ranks
  c.environment.gravity = 9.81;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true;
  bed.depth = kHeight;
  bed.normal_stiffness = stiffness;
  bed.basis = model::StiffnessBasis::per_length;
  c.dynamics.enabled = false;
  return c;
}

struct Rest {
  record::Touchdown touchdown;
  double pull = 0;  // N, horizontal
};

Rest at_rest(const model::Case& c) {
  Simulation sim(PETSC_COMM_WORLD, c);
  sim.solve_statics();
  Rest out;
  out.touchdown =
      record::Touchdowns(PETSC_COMM_WORLD, c, sim.local()).of_all_lines(sim.state().at_rest()).at(0);
  return out;
}

// Elements of 5 m; the touchdown point lies at different places within an element.
TEST(Touchdown, OfACatenaryOnRigidGround) {
  for (const double length : {391.0, 392.3, 393.6, 394.9, 396.2}) {
    const int elements = 78;
    const model::Case c = line_on_bed(length, elements, 1e8, 360);
    const Rest rest = at_rest(c);
    const auto closed = catenary_on_bed(Vec3(0, 0, 0.05 - kHeight), Vec3(360, 0, 0),
                                        {{length, Vec3(0, 0, -kWeight), 1e9, Vec3::Zero(), 0}}, 0);
    ASSERT_TRUE(closed && rest.touchdown.from_a && rest.touchdown.from_b);
    printf("  %.1f m: touchdown at %.3f m, closed form %.3f m\n", length, rest.touchdown.from_a->arc,
           closed->grounded());
    EXPECT_NEAR(rest.touchdown.from_a->arc, closed->grounded(), 0.2);  // 4 % of an element
    EXPECT_EQ(rest.touchdown.from_a->arc, rest.touchdown.from_b->arc);
    EXPECT_NEAR(rest.touchdown.laid, rest.touchdown.from_a->arc, 1e-9);
    EXPECT_NEAR(rest.touchdown.from_a->position.x(), closed->position(closed->grounded()).x(), 0.4);
  }
}

// On soft ground the gap is zero sqrt(H / k) beyond the touchdown point of rigid ground.
TEST(Touchdown, OnSoftGround) {
  // The vertex of the suspended parabola is w / 2k below the bed; the closed form has the ground there.
  const double length = 393, k = 4000;
  const auto closed = catenary_on_bed(Vec3(0, 0, 0.05 - 0.5 * kWeight / k - kHeight), Vec3(360, 0, 0),
                                      {{length, Vec3(0, 0, -kWeight), 1e9, Vec3::Zero(), 0}}, 0);
  ASSERT_TRUE(closed);
  const double soft = closed->grounded() + std::sqrt(closed->tension(0).head<2>().norm() / k);
  for (const int elements : {78, 400}) {
    model::Case c = line_on_bed(length, elements, k, 360);
    c.environment.seabed.smoothing = 1e-4;
    const Rest rest = at_rest(c);
    ASSERT_TRUE(rest.touchdown.from_a);
    printf("  %d elements: touchdown at %.3f m, closed form %.3f m (%.3f m on rigid ground)\n", elements,
           rest.touchdown.from_a->arc, soft, closed->grounded());
    EXPECT_NEAR(rest.touchdown.from_a->arc, soft, 0.15);
  }
}

// A slack line between two ends above the bed lies on it in the middle: two symmetric touchdown points.
TEST(Touchdown, FromBothEnds) {
  model::Case c = line_on_bed(420, 84, 1e8, 300, kHeight);
  const Rest rest = at_rest(c);
  ASSERT_TRUE(rest.touchdown.from_a && rest.touchdown.from_b);
  EXPECT_NEAR(rest.touchdown.from_a->arc, 420 - rest.touchdown.from_b->arc, 0.1);
  EXPECT_NEAR(rest.touchdown.laid, rest.touchdown.from_b->arc - rest.touchdown.from_a->arc, 1e-9);
  const double laid = rest.touchdown.laid;
  EXPECT_GT(laid, 50);
  EXPECT_LT(laid, 250);
  // One half, from the bed to its end.
  const double half = 0.5 * (420 - laid);
  const auto closed = catenary_on_bed(Vec3(0, 0, 0.05 - kHeight), Vec3(150, 0, 0),
                                      {{210, Vec3(0, 0, -kWeight), 1e9, Vec3::Zero(), 0}}, 0);
  ASSERT_TRUE(closed);
  EXPECT_NEAR(half, 210 - closed->grounded(), 0.3);
}

TEST(Touchdown, WhatHangsOrLiesHasNone) {
  const Rest hangs = at_rest(line_on_bed(330, 33, 1e6, 300, kHeight));
  EXPECT_FALSE(hangs.touchdown.from_a || hangs.touchdown.from_b);
  EXPECT_EQ(hangs.touchdown.laid, 0);
  model::Case c = line_on_bed(300, 30, 1e6, 300);
  c.lines[0].end_b = anchor({300, 0, 0.05 - kHeight});
  c.lines[0].start = model::Start::straight;
  const Rest lies = at_rest(c);
  EXPECT_FALSE(lies.touchdown.from_a || lies.touchdown.from_b);
  EXPECT_NEAR(lies.touchdown.laid, 300, 1e-9);
}

// A pipe: with elements of 1 m and 4 m the touchdown point is the same within 0.4 m.
TEST(Touchdown, OfABeam) {
  double found[2] = {};
  for (const int i : {0, 1}) {
    model::Case c = line_on_bed(392, i == 0 ? 98 : 392, 1e5, 360);
    c.line_types[0].kind = model::LineKind::beam;
    c.line_types[0].EI2 = c.line_types[0].EI3 = 2e7;
    c.line_types[0].GJ = 1.5e7;
    const Rest rest = at_rest(c);
    ASSERT_TRUE(rest.touchdown.from_a);
    found[i] = rest.touchdown.from_a->arc;
  }
  printf("  %.3f m by elements of 4 m, %.3f m by 1 m\n", found[0], found[1]);
  EXPECT_NEAR(found[0], found[1], 0.4);
}

}  // namespace
}  // namespace hawser::test::touchdown_test
