// Lines on a level bed against MAP++ and MoorPy, on a sloping bed against a separate solver.
#include "hawser/kernels/catenary_on_bed.hpp"

#include <gtest/gtest.h>

#include "support/leg_on_bed.hpp"

namespace hawser::catenary_on_bed_test {
namespace {

struct Line {
  const char* name;
  double x, z;  // m, from the anchor to end B
  std::vector<CatenarySection> sections;
  double friction;
  double H, V, grounded, H_anchor;
};

CatenarySection part(double w, double length, double EA) {
  return {length, Vec3(0, 0, -w), EA, Vec3::Zero()};
}

// Single lines: MAP++ 1.20.10 (OC3-Hywind, OC4-DeepCwind, its own baseline), MoorPy's test_catenary and lines
// of two and three sections of Lozon et al. 2025; closed form, solved to 1e-12.
TEST(CatenaryOnBed, ReferenceLines) {
  const double w3 = 698.0945369;
  const double w4 = (113.35 - 1025 * M_PI / 4 * 0.0766 * 0.0766) * 9.80665;
  const double x4 = std::hypot(418.8 - 20.434, 725.383 - 35.393);
  const double wv = (685 - 1025 * M_PI / 4 * 0.333 * 0.333) * 9.80665;
  const std::vector<Line> lines = {
      {"OC3",
       848.67,
       250,
       {part(w3, 902.2, 384243000)},
       0.001,
       736939.2901,
       535727.9918,
       134.7853255,
       736845.1972},
      {"OC3 -20",
       828.67,
       250,
       {part(w3, 902.2, 384243000)},
       0,
       384523.85,
       405507.2758,
       321.3222446,
       384523.85},
      {"OC3 +10", 858.67, 250, {part(w3, 902.2, 384243000)}, 0, 1080509.312, 637454.2196, 0, 1080509.312},
      {"OC3 +20", 868.67, 250, {part(w3, 902.2, 384243000)}, 0, 1998177.459, 894314.1133, 0, 1998177.459},
      {"OC4", x4, 186, {part(w4, 835.35, 753600000)}, 1, 909408.4262, 631704.299, 242.3459074, 651246.7145},
      {"VolturnUS",
       779.6,
       186,
       {part(wv, 850, 3270000000)},
       0,
       1349553.498,
       2027475.384,
       502.955676,
       1349553.498},
      {"VolturnUS rough",
       779.6,
       186,
       {part(wv, 850, 3270000000)},
       1,
       1356980.752,
       2031446.892,
       502.2758703,
       0},
      {"MAP base",
       50,
       100,
       {part(1327.647744, 125, 545000000)},
       1,
       17449.66817,
       149176.9239,
       12.63817471,
       670.6240176},
      {"MoorPy 0", 400, 200, {part(800, 500, 7.51e12)}, 5, 96643.4604, 237751.7726, 202.8102842, 0},
      {"MoorPy 2",
       400,
       200,
       {part(800, 500, 7.51e12)},
       0.1,
       96643.45416,
       237751.7684,
       202.8102894,
       80418.631},
      {"Gulf of Maine",
       642,
       186,
       {part(4101.341951, 497.7, 2058000000), part(56.61546721, 199.8, 142000000)},
       0,
       944887.4574,
       746990.9908,
       318.3247542,
       944887.4574},
      {"Humboldt",
       1342,
       786,
       {part(2455.981102, 80, 1232000000), part(59.5673446, 1378.9, 145000000),
        part(2455.981102, 80, 1232000000)},
       0,
       1509877.596,
       1122681.864,
       0,
       1509877.596}};
  for (const Line& l : lines) {
    const Vec3 anchor(3, -7, -200);
    const Vec3 b = anchor + Vec3(0.6 * l.x, 0.8 * l.x, l.z);
    const auto s = catenary_on_bed(anchor, b, l.sections, l.friction);
    ASSERT_TRUE(s) << l.name;
    const Vec3 T = s->tension_b();
    const Vec3 A = s->tension_a();
    const double near = std::string(l.name).starts_with("OC3 ")
                            ? 1e-6
                            : 1e-8;  // the published positions of the ends are not more accurate
    EXPECT_NEAR(T.head<2>().norm(), l.H, near * l.H) << l.name;
    EXPECT_NEAR(T.z(), l.V, near * l.V) << l.name;
    EXPECT_NEAR(s->grounded(), l.grounded, 1e3 * near) << l.name;
    EXPECT_NEAR(A.head<2>().norm(), l.H_anchor, near * l.H) << l.name;
    double length = 0;
    for (const auto& p : l.sections) length += p.length;
    EXPECT_LT((s->position(length) - b).norm(), 1e-8 * length) << l.name;
    EXPECT_LT((s->position(0) - anchor).norm(), 1e-8 * length) << l.name;
    // No kinks, nothing below the bed, and the tension matches the strain.
    for (double at = 0; at < length; at += length / 997) {
      const double h = 1e-4;
      if (at + h > length) break;
      const Vec3 p = s->position(at);
      const Vec3 d = s->position(at + h) - p;
      EXPECT_GE(p.z(), anchor.z() - 1e-9) << l.name;
      EXPECT_GT(d.norm(), h * (1 - 1e-6)) << l.name;
      EXPECT_LT(d.norm(), 1.05 * h) << l.name;
    }
  }
}

// A clump weight on the bed, and a lifted one: equilibrium at the joint and end positions.
TEST(CatenaryOnBed, ClumpWeight) {
  for (const double weight : {1e5, 3e5, 3e6}) {
    std::vector<CatenarySection> s = {part(800, 250, 5e8), part(800, 250, 5e8)};
    s[0].end_load = Vec3(0, 0, -weight);
    const auto c = catenary_on_bed(Vec3::Zero(), Vec3(420, 0, 200), s, 0);
    ASSERT_TRUE(c) << weight;
    EXPECT_LT((c->position(500) - Vec3(420, 0, 200)).norm(), 1e-8) << weight;
    const Vec3 below = c->tension(250 - 1e-6);
    const Vec3 above = c->tension(250 + 1e-6);
    EXPECT_NEAR(below.x(), above.x(), 1e-6 * above.x()) << weight;
    EXPECT_LE(above.z() - below.z(), weight * (1 + 1e-6)) << weight;
    if (c->grounded() < 250 - 1e-9) {
      EXPECT_NEAR(above.z() - below.z(), weight, 1e-2) << weight;
    }
    printf("  clump %g: grounded %g m, tension %g N\n", weight, c->grounded(), c->tension_b().norm());
  }
}

// Beds that rise and fall towards end B, slack and taut lines, against a separate solver: loads, end
// positions, and length on the plane.
TEST(CatenaryOnBed, SlopingBed) {
  constexpr double kLength = 500;
  for (const double slope : {-0.15, -0.05, 0.05, 0.15})
    for (const double x : {400.0, 430.0, 450.0}) {
      const test::LegOnBed leg{.length = kLength,
                               .weight = 1500,
                               .EA = 8e8,
                               .friction = 0.6,
                               .slope = slope,
                               .x = x,
                               .z = x * std::tan(slope) + 100};
      const std::optional<test::LegLoads> own = test::LegSolver(leg).solve();
      ASSERT_TRUE(own) << slope << ' ' << x;
      const auto c = catenary_on_bed(Vec3::Zero(), Vec3(x, 0, leg.z), {part(leg.weight, kLength, leg.EA)},
                                     0.6 * std::cos(slope) + std::sin(slope), std::tan(slope));
      ASSERT_TRUE(c) << slope << ' ' << x;
      EXPECT_NEAR(c->tension_b().norm(), own->fairlead, 1e-4 * own->fairlead) << slope << ' ' << x;
      EXPECT_NEAR(c->tension_a().norm(), own->anchor, 1e-3 * own->fairlead) << slope << ' ' << x;
      EXPECT_NEAR(c->grounded(), own->lying, 1e-3 * kLength) << slope << ' ' << x;
      EXPECT_LT(c->position(0).norm(), 1e-7 * kLength);
      EXPECT_LT((c->position(kLength) - Vec3(x, 0, leg.z)).norm(), 1e-7 * kLength);
      for (double at = 0; at < c->grounded(); at += 7)
        EXPECT_NEAR(c->position(at).z(), c->position(at).x() * std::tan(slope), 1e-9);
    }
}

TEST(CatenaryOnBed, NothingWhereThereIsNoSuchShape) {
  const std::vector<CatenarySection> s = {part(800, 500, 5e8)};
  EXPECT_FALSE(catenary_on_bed(Vec3::Zero(), Vec3(200, 0, 200), s, 0));  // the line hangs straight down
  EXPECT_FALSE(catenary_on_bed(Vec3::Zero(), Vec3(400, 0, -10), s, 0));
  EXPECT_FALSE(catenary_on_bed(Vec3::Zero(), Vec3(400, 0, 200), {part(-800, 500, 5e8)}, 0));
}

// Warm sections are longer with the same total weight; friction is proportional to that weight.
TEST(CatenaryOnBed, FreeStrainIsALongerLine) {
  const double by[] = {1.002, 0.999};
  for (const double x : {770.0, 790.0}) {
    std::vector<CatenarySection> warm{part(1200, 500, 7e8), part(900, 335, 5e8)};
    std::vector<CatenarySection> longer = warm;
    for (size_t i = 0; i < 2; ++i) {
      warm[i].free_strain = by[i] - 1;
      longer[i].length *= by[i];
      longer[i].EA *= by[i];
      longer[i].load /= by[i];
    }
    const auto w = catenary_on_bed({0, 0, -200}, {x, 0, -14}, warm, 0.6);
    const auto l = catenary_on_bed({0, 0, -200}, {x, 0, -14}, longer, 0.6);
    ASSERT_TRUE(w && l);
    EXPECT_GT(w->grounded(), 10);
    EXPECT_NEAR(w->grounded() * by[0], l->grounded(), 1e-7);
    EXPECT_LT((w->tension_a() - l->tension_a()).norm(), 1e-9 * l->tension_b().norm());
    EXPECT_LT((w->tension_b() - l->tension_b()).norm(), 1e-9 * l->tension_b().norm());
    for (const double s : {5.0, 200.0, 450.0})
      EXPECT_LT((w->position(s) - l->position(s * by[0])).norm(), 1e-7) << s;
    EXPECT_LT((w->position(835) - Vec3(x, 0, -14)).norm(), 1e-7);
  }
}

}  // namespace
}  // namespace hawser::catenary_on_bed_test
