// Beams joined rigidly, against the deflections of slender frames.
#include <gtest/gtest.h>

#include "support/rig.hpp"

namespace hawser::test::frames_of_beams {
namespace {

// A column of 4 m, clamped at its foot, with an arm of 3 m joined rigidly to its head, loaded at the tip.
// Slopes are small, axial strain is negligible: down P b³/3EI + P b² a/EI, sideways P (a³ + b³)/3EI + P b²
// a/GJ.
TEST(FramesOfBeams, ArmOnAColumn) {
  const double a = 4, b = 3, EI = 1e6, GJ = 8e5;
  for (const bool sideways : {false, true}) {
    model::Case c;
    c.environment.gravity = 0;
    c.line_types = {beam_type(1e10, EI, GJ)};
    c.joints = {{"head", {0, 0, a}, true}};
    model::End head;
    head.kind = model::EndKind::joint, head.body = "head", head.at = {0, 0, a};
    model::End arm = head;
    arm.direction = Vec3::UnitX();
    for (const bool column : {true, false}) {
      model::Line l;
      l.name = column ? "column" : "arm";
      l.sections.push_back({"beam", column ? a : b, 8, 1});
      l.end_a = column ? clamp(Vec3::Zero(), Vec3::UnitZ()) : arm;
      if (column) l.end_b = head;
      l.start = model::Start::straight;
      if (!column) {
        model::PointLoad p;
        p.at = b, p.force = sideways ? Vec3(0, 10, 0) : Vec3(0, 0, -10);
        l.point_loads.push_back(p);
      }
      c.lines.push_back(l);
    }
    Simulation s(PETSC_COMM_WORLD, c);
    s.solve_statics();
    const int tip = s.local().find(s.mesh().lines[1].first_node + 8);
    double moved = 0;
    if (tip >= 0 && tip < s.local().owned) {
      const Vec3& x = s.state().x[static_cast<size_t>(tip)];
      moved = sideways ? x.y() : a - x.z();
    }
    MPI_Allreduce(MPI_IN_PLACE, &moved, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    const double exact = sideways ? 10 * ((a * a * a + b * b * b) / (3 * EI) + b * b * a / GJ)
                                  : 10 * (b * b * b / (3 * EI) + b * b * a / EI);
    printf("arm on a column, %s: %.6e m, closed form %.6e m (%.4f %%)\n", sideways ? "sideways" : "down",
           moved, exact, 100 * (moved / exact - 1));
    EXPECT_NEAR(moved, exact, 1e-3 * exact);
  }
}

}  // namespace
}  // namespace hawser::test::frames_of_beams
