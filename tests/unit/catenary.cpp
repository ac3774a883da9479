// Elastic catenaries: against closed forms, published lines and an integration along the line; special cases,
// random lines and derivatives.
#include "hawser/kernels/catenary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace hawser::catenary_test {
namespace {

struct Planar {
  double X, Z, L, EA, w;  // span, rise, length [m], EA [N], weight per length [N/m]
  double H, V;            // N, at the upper end B
};

void expect_planar(const Planar& c, double tolerance) {
  const CatenaryShape s = catenary({0, 0, 0}, {c.X, 0, c.Z}, {{c.L, {0, 0, -c.w}, c.EA}});
  const double T = std::hypot(c.H, c.V);
  EXPECT_NEAR(s.tension_b().x(), c.H, tolerance * T);
  EXPECT_NEAR(s.tension_b().y(), 0, tolerance * T);
  EXPECT_NEAR(s.tension_b().z(), c.V, tolerance * T);
  EXPECT_NEAR(s.tension_a().z(), c.V - c.w * c.L, tolerance * T);
  EXPECT_NEAR((s.end_b() - Vec3(c.X, 0, c.Z)).norm(), 0, 1e-10 * c.L);
}

// Irvine's suspended elastic catenary: closed form solved with 30 digits and checked by an ODE to 1e-12. The
// last row is a nearly taut line of a published test whose published forces violate vertical equilibrium.
TEST(Catenary, SuspendedLines) {
  expect_planar({100, 60, 130, 5e7, 800, 42367.282133441084, 84534.59422133592}, 1e-11);
  expect_planar({100, 60, 110, 2e5, 300, 19441.541310991368, 29737.876520897935}, 1e-11);
  expect_planar({100, 0, 120, 1e12, 1000, 46954.14215486048, 60000}, 1e-10);
  expect_planar({246.22420940032947, 263.55766330843164, 360.63566262396927, 7e8, 3.08735, 58377.24142265001,
                 63044.41295591721},
                1e-8);  // strain of 1e-4: 16 digits of data give 12 in the force
}

// The part above the touchdown point of lines on a flat seabed (MAP++ baseline, MoorPy test_catenary; solved
// as above): length, span minus the part on the ground, zero vertical force at the touchdown point.
TEST(Catenary, SuspendedPartAboveTouchdown) {
  expect_planar({50 - 12.638384812729416, 100, 125 - 12.63817471418034, 5.45e8, 1327.647744,
                 17449.668166213807, 149176.92386153372},
                1e-9);
  expect_planar({400 - 202.81029256714444, 200, 500 - 202.81028995725273, 7.51e12, 800, 96643.45354712023,
                 237751.76803419783},
                1e-9);
}

// Integrates r' = T/|T| + T/EA by the midpoint rule.
Vec3 integrate(const CatenaryShape& s, const std::vector<CatenarySection>& sections, double to) {
  Vec3 r = s.position(0);
  double begin = 0;
  for (const CatenarySection& section : sections) {
    const double length = std::min(section.length, to - begin);
    const int n = 20000;
    for (int i = 0; i < n && length > 0; ++i) {
      const Vec3 T = s.tension(begin + (i + 0.5) * length / n);
      r += length / n * (T / T.norm() + T / section.EA);
    }
    begin += section.length;
  }
  return r;
}

TEST(Catenary, SectionsWithLateralLoadsAndPointLoads) {
  const std::vector<CatenarySection> sections{{120, {0, 5, -900}, 4e8},
                                              {60, {20, 0, -150}, 2e7, {0, 0, -30000}},
                                              {90, {-10, 30, 60}, 5e6, {0, 0, 8000}},
                                              {80, {0, 0, -300}, 1e8}};
  const Vec3 a(10, -5, -100), b(200, 60, 20);
  const CatenaryShape s = catenary(a, b, sections);
  EXPECT_LT((s.end_b() - b).norm(), 1e-9);
  EXPECT_LT((s.position(s.length()) - b).norm(), 1e-9);
  for (double at : {50.0, 120.0, 150.0, 260.0, 350.0})
    EXPECT_LT((s.position(at) - integrate(s, sections, at)).norm(), 1e-6) << at;
  const Vec3 load = 120 * sections[0].load + 60 * sections[1].load + 90 * sections[2].load +
                    80 * sections[3].load + sections[1].end_load + sections[2].end_load;
  EXPECT_LT((s.tension_a() - s.tension_b() - load).norm(), 1e-6);
}

TEST(Catenary, LooseVerticalTightAndReversed) {
  const std::vector<CatenarySection> hose{{100, {0, 0, -50}, 1e7}};
  // Both ends at one point: the line is folded, with half of the weight on each leg.
  CatenaryShape s = catenary({0, 0, 0}, {0, 0, 0}, hose);
  EXPECT_NEAR(s.tension_b().z(), 2500, 1e-3);
  EXPECT_NEAR(s.position(50).z(), -50 * (1 + 50 * 50 / (2 * 1e7)), 1e-3);
  // Ends one above the other, slack and tight.
  s = catenary({0, 0, 0}, {0, 0, 60}, hose);
  EXPECT_LT((s.end_b() - Vec3(0, 0, 60)).norm(), 1e-6);
  EXPECT_NEAR(s.tension_b().z(), 4000, 5);  // 80 m of line below end B
  s = catenary({0, 0, 0}, {0, 0, 102}, hose);
  EXPECT_NEAR(s.tension_a().z(), 2e5 - 2500, 1e-3);
  // Shorter than its span.
  s = catenary({0, 0, 0}, {104, 0, 0}, hose);
  EXPECT_NEAR(s.tension_a().x(), 4e5, 100);
  // The line from B to A is the same as that from A to B.
  const CatenaryShape u = catenary({0, 0, 0}, {70, 5, 30}, hose);
  const CatenaryShape v = catenary({70, 5, 30}, {0, 0, 0}, hose);
  EXPECT_LT((u.tension_a() + v.tension_b()).norm(), 1e-8 * u.tension_a().norm());
  EXPECT_LT((u.position(30) - v.position(70)).norm(), 1e-9);
  // A line that is very slack, and one that is very light.
  EXPECT_NO_THROW(catenary({0, 0, 0}, {1e-3, 0, 0}, hose));
  EXPECT_NO_THROW(catenary({0, 0, 0}, {101, 0, 0}, {{100, {0, 0, -1e-9}, 1e9}}));
  // Without load a line is straight if it is in tension, and refused if it is slack.
  s = catenary({0, 0, 0}, {0, 101, 0}, {{100, {0, 0, 0}, 1e7}});
  EXPECT_NEAR(s.tension_b().y(), 1e5, 1e-4);
  EXPECT_THROW(catenary({0, 0, 0}, {0, 99, 0}, {{100, {0, 0, 0}, 1e7}}), std::invalid_argument);
  EXPECT_THROW(catenary({0, 0, 0}, {0, 99, 0}, {{0, {0, 0, -1}, 1e7}}), std::invalid_argument);
  EXPECT_THROW(catenary({0, 0, 0}, {0, 99, 0}, {{100, {0, 0, -1}, 0}}), std::invalid_argument);
}

// Random proportions: lengths, loads (some upward), stiffness over five decades, spans from zero to too long.
TEST(Catenary, RandomLines) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto u = [&] { return uniform(generator); };
  const auto decades = [&](double from, double to) { return from * std::pow(to / from, u()); };
  for (int i = 0; i < 20000; ++i) {
    std::vector<CatenarySection> sections(1 + static_cast<size_t>(u() * 4));
    double length = 0;
    for (CatenarySection& s : sections) {
      s.length = decades(1, 1000);
      s.EA = decades(1e5, 1e10);
      s.load = Vec3(u() - 0.5, u() - 0.5, -decades(0.1, 50)) * decades(1, 100);
      if (u() < 0.2) s.load = -s.load;
      if (u() < 0.2) s.end_load = {0, 0, (u() - 0.5) * 1e5};
      length += s.length;
    }
    Vec3 b = Vec3(u() - 0.5, u() - 0.5, u() - 0.5).normalized() * length *
             (u() < 0.3 ? decades(1e-6, 1) : 1.1 * u());
    if (u() < 0.1) b = {0, 0, b.z()};
    ASSERT_NO_THROW({
      EXPECT_LT((catenary({0, 0, 0}, b, sections).end_b() - b).norm(), 1e-11 * length);
    }) << i;
  }
}

TEST(Catenary, FreeEnds) {
  const std::vector<CatenarySection> hose{{100, {20, 0, -50}, 1e6}, {50, {0, 0, -80}, 2e6, {0, 0, -1000}}};
  const CatenaryShape b = catenary_free_b({1, 2, 3}, hose);
  EXPECT_LT((b.tension_b() - Vec3(0, 0, -1000)).norm(), 1e-9);
  EXPECT_LT((b.tension_a() - Vec3(2000, 0, -10000)).norm(), 1e-9);
  EXPECT_LT((b.position(130) - integrate(b, hose, 130)).norm(), 1e-6);
  const std::vector<CatenarySection> reversed{{50, {0, 0, -80}, 2e6}, {100, {20, 0, -50}, 1e6}};
  const CatenaryShape a = catenary_free_a({1, 2, 3}, reversed);
  EXPECT_LT(a.tension_a().norm(), 1e-12);
  EXPECT_LT((a.end_b() - Vec3(1, 2, 3)).norm(), 1e-12);
  EXPECT_LT((a.tension_b() - Vec3(-2000, 0, 9000)).norm(), 1e-9);
  EXPECT_TRUE(a.position(0).allFinite());
  EXPECT_LT((a.position(80) - integrate(a, reversed, 80)).norm(), 1e-6);
}

TEST(Catenary, ChordDerivative) {
  const Vec3 load(3, -7, -50);
  for (const Vec3& T : {Vec3(1000, 300, 4000), Vec3(200, 0, -3000), Vec3(100, 40, -9000), Vec3(-30, 5, 2),
                        Vec3(3e6, 1e6, 2e6)}) {
    Mat3 K;
    catenary_chord(T, load, 100, 1e6, &K);
    for (int c = 0; c < 3; ++c) {
      const double h = 1e-4 * T.norm();
      const Vec3 d = h * Vec3::Unit(c);
      const Vec3 difference =
          (8 * (catenary_chord(T + d, load, 100, 1e6) - catenary_chord(T - d, load, 100, 1e6)) -
           (catenary_chord(T + 2 * d, load, 100, 1e6) - catenary_chord(T - 2 * d, load, 100, 1e6))) /
          (12 * h);
      EXPECT_LT((K.col(c) - difference).norm(), 1e-6 * K.norm()) << T.transpose() << " " << c;
    }
  }
  // The limit of zero load is smooth.
  const Vec3 T(1000, 300, 4000);
  Mat3 K0, K1;
  const Vec3 r0 = catenary_chord(T, Vec3::Zero(), 100, 1e6, &K0);
  const Vec3 r1 = catenary_chord(T, {0, 0, -1e-9}, 100, 1e6, &K1);
  EXPECT_LT((r0 - r1).norm(), 1e-8);
  EXPECT_LT((K0 - K1).norm(), 1e-10 * K0.norm());
}

// A line elongated by e equals one of length (1 + e) L with the same total weight and (1 + e) EA.
TEST(Catenary, FreeStrainIsALongerLine) {
  const double e = 0.03;
  std::vector<CatenarySection> warm{{100, {20, 0, -50}, 1e6}, {50, {0, 0, -80}, 2e6, {0, 0, -1000}}};
  std::vector<CatenarySection> longer = warm;
  warm[0].free_strain = e;
  warm[1].free_strain = -e;
  for (CatenarySection& s : longer) {
    const double by = &s == &longer[0] ? 1 + e : 1 - e;
    s.length *= by;
    s.EA *= by;
    s.load /= by;
  }
  for (const Vec3& b : {Vec3(120, 10, 30), Vec3(150, 0, 20)}) {
    const CatenaryShape w = catenary({0, 0, 0}, b, warm);
    const CatenaryShape l = catenary({0, 0, 0}, b, longer);
    EXPECT_LT((w.end_b() - b).norm(), 1e-9);
    EXPECT_LT((w.tension_a() - l.tension_a()).norm(), 1e-9 * w.tension_a().norm());
    EXPECT_LT((w.position(70) - l.position(70 * (1 + e))).norm(), 1e-9);
    EXPECT_LT((w.position(120) - l.position(100 * (1 + e) + 20 * (1 - e))).norm(), 1e-9);
    EXPECT_EQ(w.length(), 150);
  }
  const Vec3 T(1000, 300, 4000), load(3, -7, -50);
  Mat3 K, L;
  const Vec3 r = catenary_chord(T, load, 100, 1e6, &K, e);
  EXPECT_LT((r - catenary_chord(T, load / (1 + e), 100 * (1 + e), 1e6 * (1 + e), &L)).norm(), 1e-11);
  EXPECT_LT((K - L).norm(), 1e-12 * L.norm());
  EXPECT_THROW(catenary({0, 0, 0}, {0, 104, 0}, {{100, {0, 0, 0}, 1e7, {0, 0, 0}, 0.05}}),
               std::invalid_argument);  // slack without a load
}

}  // namespace
}  // namespace hawser::catenary_test
