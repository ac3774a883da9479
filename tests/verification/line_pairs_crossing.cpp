// Two crossing beams: contact force by the compliances of both beams and of the contact in series.
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_crossing_test {
namespace {

// Linear form of Meier, Popp & Wall's set-up: EI 1e5 and 2e5 N m², spans 4 and 5 m, simply supported, contact
// stiffness 1e6 N/m, 0.02 m apart, supports moved together by D: F = (D - 0.02) / (L1³/48EI1 + L2³/48EI2 +
// 1/k).
TEST(CrossingBeams, CompliancesInSeries) {
  const double reach = 0.2;
  for (const auto& [D, force, pressed] :
       {std::tuple(0.05, 1096.725057, 0.001096725057), {0.1, 2924.600152, 0.002924600152}}) {
    // Stiffness per length for which this force has the penetration of a spring of 1e6 N/m.
    const double k = force / crossing_force(1, reach, pressed, M_PI / 2);
    for (const int elements : {8, 7, 20}) {  // nodes under the crossing or beside it
      model::Case c;
      c.environment.gravity = 0;
      model::LineType first = beam_type(1e4, 1e5, 1e5);
      model::LineType second = beam_type(1e4, 2e5, 2e5);
      first.name = "first";
      second.name = "second";
      first.contact_diameter = second.contact_diameter = reach;
      c.line_types = {first, second};
      const double z = reach + 0.02 - D;
      c.lines = {straight_line("first", "first", 4, elements, anchor({-2, 0, 0}), anchor({2, 0, 0})),
                 straight_line("second", "second", 5, elements, anchor({0, -2.5, z}), anchor({0, 2.5, z}))};
      touch(c, k, 1e-7);
      Simulation s(PETSC_COMM_WORLD, c);
      ASSERT_NE(s.line_pairs(), nullptr);
      const int its = s.solve_statics().iterations;
      const double F = s.line_pairs()->normal_force();
      const double p = s.line_pairs()->deepest().depth;
      printf("  D %.2f m, %d elements: force %.3f N (%.3f), pressed in by %.4f mm (%.4f), %d iterations\n", D,
             elements, F, force, 1e3 * p, 1e3 * pressed, its);
      EXPECT_NEAR(F, force, 0.005 * force);
      EXPECT_NEAR(p, pressed, 0.005 * pressed);
      // From a less bent shape the last iterations are quadratic.
      for (int n = 0; n < s.local().owned; ++n)
        s.state().x[static_cast<size_t>(n)].z() *=
            1 - 0.02 * (s.mesh().node(static_cast<size_t>(n)).line == 0);
      std::vector<double> residuals;
      settle(s, 1e-11, &residuals);
      print_residuals(residuals);
      EXPECT_LT(newton_square(residuals), 10);
    }
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs_crossing_test
