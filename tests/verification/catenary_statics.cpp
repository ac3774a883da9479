// Suspended lines against the elastic catenary: force at the upper end, for cables and for beams of little
// bending stiffness, from two start shapes.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/rig.hpp"

namespace hawser::catenary_statics_test {

using namespace hawser::test;

namespace {

constexpr double kGravity = 9.80665;

// A suspended line from (0, 0, 0) to (X, 0, Z): length L, weight w [N/m], and the force H, V [N] at its upper
// end.
struct Suspended {
  const char* name;
  double X, Z, L, EA, w, H, V;
};

struct End {
  double H = 0, V = 0;
  StaticsReport report;
};

End solve(const Suspended& s, int elements, bool bends, model::Start start) {
  const double EI = 1e-3 * s.w;
  const model::LineType t =
      bends ? beam_type(s.EA, EI, EI, s.w / kGravity) : cable_type(s.EA, s.w / kGravity);
  model::Case c = one_line(t, s.L, elements, anchor(Vec3::Zero()), anchor(Vec3(s.X, 0, s.Z)));
  c.environment.gravity = kGravity;
  c.lines[0].start = start;
  run::Simulation sim(PETSC_COMM_WORLD, c);
  End e;
  e.report = sim.solve_statics();
  const size_t b = 3 * static_cast<size_t>(sim.local().block[static_cast<size_t>(elements)]);
  e.H = sim.system().reactions()[b];
  e.V = sim.system().reactions()[b + 2];
  return e;
}

void check_step(const Suspended& s) {
  const double T = std::hypot(s.H, s.V);
  for (bool bends : {false, true})
    for (auto start : {model::Start::automatic, model::Start::straight}) {
      const bool straight = start == model::Start::straight;
      const End e = solve(s, 40, bends, start);
      const double H = e.H / s.H - 1;
      const double V = e.V / s.V - 1;
      const double tension = std::hypot(e.H, e.V) / T - 1;
      std::printf("%-8s %-6s from %-8s: H %+.1e, V %+.1e, tension %+.1e, %d iterations\n", s.name,
                  bends ? "beams" : "cables", straight ? "straight" : "catenary", H, V, tension,
                  e.report.iterations);
      EXPECT_LT(std::abs(tension), 5e-4) << s.name;
      // The horizontal force of a steep line is small: its error is that of the direction of the tension.
      EXPECT_LT(std::abs(H) * (s.H < 0.25 * s.V ? s.H / T : 1), 5e-4) << s.name;
      EXPECT_LT(std::abs(V), 5e-4) << s.name;
      EXPECT_EQ(e.report.negative_eigenvalues, 0) << s.name;
    }
}

}  // namespace

// Closed form of Irvine (1981), Cable Structures, solved with 30 digits. The last row is the near-taut line
// of MoorPy's tests, whose published 56 804.6 N and 60 803.4 N at the two ends are not in balance with the
// weight.
TEST(Catenary, ElasticSuspendedLine) {
  for (const Suspended& s :
       {Suspended{"O01a", 100, 60, 130, 5e7, 800, 42367.282133441084, 84534.59422133592},
        Suspended{"O01b", 100, 60, 110, 2e5, 300, 19441.541310991368, 29737.876520897935},
        Suspended{"O01c", 100, 0, 120, 1e12, 1000, 46954.14215486048, 60000},
        Suspended{"O01d", 246.22420940032947, 263.55766330843164, 360.63566262396927, 7e8, 3.08735,
                  58377.24142265001, 63044.41295591721}})
    check_step(s);
}

// Suspended part of lines on a seabed with friction 5, 0 and 0.1 (geometry of MoorPy's tests) or 1 (of
// MAP++), by the closed form with 30 digits: the touchdown point is at x_td after a length LB.
TEST(Catenary, PartAboveTouchdown) {
  struct {
    const char* name;
    double x_td, LB, H, V;
  } const rows[] = {{"O05 5", 202.81028434468666, 202.81028418922796, 96643.46040391113, 237751.77264861763},
                    {"O05 0", 202.81029256714444, 202.81028995725273, 96643.45354712023, 237751.76803419783},
                    {"O05 0.1", 202.8102918332215, 202.81028944240842, 96643.454159146, 237751.76844607329}};
  // The line of MAP++'s tests is steep: 125 m of line in 100 m of water.
  check_step({"O05 MAP", 50 - 12.638384812729416, 100, 125 - 12.63817471418034, 5.45e8, 1327.647744080927,
              17449.668166213807, 149176.92386153372});
  for (const auto& r : rows) check_step({r.name, 400 - r.x_td, 200, 500 - r.LB, 7.51e12, 800, r.H, r.V});
}

// The error of cables falls with the square of the element length, that of beams (cubic shape functions)
// faster.
TEST(Catenary, CablesAndBeamsConverge) {
  const Suspended s{"O01a", 100, 60, 130, 5e7, 800, 42367.282133441084, 84534.59422133592};
  for (bool bends : {false, true}) {
    double e[3];
    for (int i = 0; i < 3; ++i)
      e[i] = std::abs(solve(s, 10 << i, bends, model::Start::automatic).H / s.H - 1);
    std::printf("O01a %s: H within %.2e %.2e %.2e (10, 20, 40 elements)\n", bends ? "beams" : "cables", e[0],
                e[1], e[2]);
    EXPECT_GT(std::log2(e[0] / e[1]), 1.9);
  }
}

// A line longer than its height starts straight and vertical. In axial compression this shape is an
// equilibrium, weight included, but unstable. Statics must leave it for the bight below the lower end, which
// it also finds from a start shape with a bight.
TEST(Catenary, FalseBalanceIsLeft) {
  const double Z = 100, L = 130, w = 800;
  model::LineType t = beam_type(5e7, 8e5, 8e5, w / kGravity);
  t.EI2 = 1.6e6;  // otherwise the bight may lie in any plane, and one eigenvalue is zero
  double V[2], H[2], energy[2];
  StaticsReport report[2];
  for (size_t i = 0; i < 2; ++i) {
    model::Case c = one_line(t, L, 80, anchor(Vec3::Zero()), anchor(Vec3(0, 0, Z)));
    c.environment.gravity = kGravity;
    c.lines[0].start = i == 0 ? model::Start::straight : model::Start::points;
    if (i == 1) c.lines[0].points = {{0, 0, 0}, {2, 0, -14}, {4, 0, -14}, {0, 0, Z}};
    run::Simulation s(PETSC_COMM_WORLD, c);
    report[i] = s.solve_statics();
    const double* top = s.system().reactions().data() + 3 * s.local().block[80];
    V[i] = top[2];
    H[i] = std::hypot(top[0], top[1]);
    const Energy e = s.system().energy(s.state().at_rest());
    energy[i] = e.strain + e.potential;
  }
  std::printf(
      "vertical line, straight start: %d escapes, %d iterations; against a bight: V %+.1e, H %+.1e, energy "
      "%+.1e\n",
      report[0].escapes, report[0].iterations, V[0] / V[1] - 1, H[0] / H[1] - 1, energy[0] / energy[1] - 1);
  EXPECT_GE(report[0].escapes, 1);
  EXPECT_EQ(report[0].negative_eigenvalues, 0);
  EXPECT_NEAR(V[0], V[1], 1e-5 * V[1]);
  EXPECT_NEAR(H[0], H[1], 1e-2 * H[1]);
  EXPECT_NEAR(energy[0], energy[1], 1e-6 * energy[1]);
}

}  // namespace hawser::catenary_statics_test
