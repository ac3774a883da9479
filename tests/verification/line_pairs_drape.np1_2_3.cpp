// A slack rope starts above a taut wire and must come to rest on it. Statics moves the rope by many diameters
// in one iteration, but not through the wire.
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::line_pairs_drape {
namespace {

constexpr double kDiameter = 0.1, kAbove = 0.4, kSpan = 10;

struct Draped {
  double rope = 0, wire = 0, force = 0;  // m, heights at the crossing; N
};

// The rope crosses the wire at `off` from the wire's middle; `nodes`: elements of the wire.
Draped drape(double stiffness, int nodes, double off, bool touch_at_all = true) {
  model::Case c;
  c.environment.gravity = 9.81;
  model::LineType wire = beam_type(1e7, 1e4, 1e4, 20);
  model::LineType rope = beam_type(1e7, 500, 500, 30);
  wire.name = "wire";
  rope.name = "rope";
  wire.contact_diameter = rope.contact_diameter = kDiameter;
  c.line_types = {wire, rope};
  c.lines = {
      straight_line("wire", "wire", kSpan * (1 - 5e-3), nodes, anchor({-5, off, 0}), anchor({5, off, 0})),
      straight_line("rope", "rope", 1.06 * kSpan, nodes + 1, anchor({0, -5, kAbove}),
                    anchor({0, 5, kAbove}))};
  touch(c, stiffness, 1e-4);
  c.contact.between_lines.enabled = touch_at_all;
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  // Heights at the crossing, from the nearest nodes.
  Draped d;
  double most[3] = {1e9, 1e9, s.line_pairs() ? s.line_pairs()->normal_force() : 0};
  double heights[2] = {0, 0};
  for (int n = 0; n < s.local().owned; ++n) {
    const size_t i = static_cast<size_t>(n);
    const int line = s.mesh().node(static_cast<size_t>(s.local().global[i])).line;
    const Vec3 x = s.state().x[i] - Vec3(0, off, 0);
    const double away = std::hypot(x.x(), x.y());
    if (away < most[line]) {
      most[line] = away;
      heights[line] = x.z();
    }
  }
  for (int line = 0; line < 2; ++line) {
    struct {
      double value;
      int rank;
    } best{most[line], 0};
    MPI_Comm_rank(PETSC_COMM_WORLD, &best.rank);
    MPI_Allreduce(MPI_IN_PLACE, &best, 1, MPI_DOUBLE_INT, MPI_MINLOC, PETSC_COMM_WORLD);
    MPI_Bcast(&heights[line], 1, MPI_DOUBLE, best.rank, PETSC_COMM_WORLD);
  }
  MPI_Allreduce(&most[2], &d.force, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  d.wire = heights[0];
  d.rope = heights[1];
  return d;
}

TEST(Drape, TheRopeComesToLieOnTheWire) {
  // Without contact the rope hangs far below.
  const Draped free = drape(1e6, 20, 0, false);
  EXPECT_LT(free.rope, free.wire - 1);
  for (const int elements : {20, 33})
    for (const double off : {0.0, 1.3}) {
      const Draped d = drape(1e6, elements, off);
      int rank = 0;
      MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
      if (rank == 0)
        std::printf("%d elements, crossing %.1f m off: rope %.4f m, wire %.4f m, %.1f N\n", elements, off,
                    d.rope, d.wire, d.force);
      EXPECT_GT(d.rope, d.wire + 0.5 * kDiameter);
      EXPECT_LT(d.rope, d.wire + 2.5 * kDiameter);
      // About half of the rope's weight of 3.1 kN, more where the rope bends over the wire.
      EXPECT_GT(d.force, 1000);
      EXPECT_LT(d.force, 3200);
    }
}

// With a contact stiffness so small that no equilibrium has the rope above the wire, statics stops with an
// error.
TEST(Drape, WhereThereIsNoPathTheMessageReportsIt) {
  try {
    const Draped d = drape(1, 20, 0);
    ADD_FAILURE() << "rope " << d.rope << " m, wire " << d.wire << " m";
  } catch (const SolveError& e) {
    EXPECT_NE(std::string(e.what()).find("would pass through each other"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs_drape
