// A mooring line on a bed with friction, its fairlead on a ship in motion, and the difference between two
// runs of it.
#pragma once

#include <algorithm>

#include "support/rig.hpp"

namespace hawser::test {

// A chain of 835 m in a water depth of 200 m; the fairlead is at 795 m from the anchor.
inline model::Case moored_chain(const Vec3& from, int elements, double bed_stiffness, const Vec3& amplitude) {
  model::LineType t = cable_type(7.536e8, 113.35);
  t.outer_diameter = t.contact_diameter = 0.0766;
  model::Case c = one_line(t, 835, elements, anchor(from), {});
  c.contact.between_lines.enabled = false;  // so that the partition cuts the line
  c.environment.gravity = 9.80665;
  c.environment.water.present = true;
  c.environment.water.depth = 200;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true;
  bed.depth = 200;
  bed.normal_stiffness = bed_stiffness;
  bed.damping = 0.1 * bed_stiffness;
  bed.friction.axial = 0.6;
  bed.friction.lateral = 0.9;
  bed.friction.mobilisation_length = 0.01;
  model::Body b;
  b.name = "ship";
  b.position = {795, 0, -14};
  model::HarmonicMotion m;
  m.amplitude = amplitude;
  m.period = 8;
  b.motion = m;
  b.ramp = 4;
  c.bodies.push_back(b);
  model::End e;
  e.kind = model::EndKind::body;
  e.carrier = "ship";
  c.lines[0].end_b = e;
  c.dynamics.enabled = true;
  c.dynamics.step = 0.1;
  return c;
}

// Dynamics, starting from the result of statics.
inline void run(Simulation& s, double until) {
  s.dynamics().start(s.state());
  s.dynamics().run(
      until, [until](double) { return until; }, [](const StepInfo&) { return true; });
}

// Expects that the positions on all ranks equal those of a run on one rank, to `most` [m].
inline void expect_same_positions(const Simulation& all, const Kinematics& a, const Kinematics& alone,
                                  double most, const char* when) {
  double off = 0;
  for (int n = 0; n < all.local().owned; ++n)
    off = std::max(off, (a.x[static_cast<size_t>(n)] -
                         alone.x[static_cast<size_t>(all.local().global[static_cast<size_t>(n)])])
                            .norm());
  MPI_Allreduce(MPI_IN_PLACE, &off, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  EXPECT_LT(off, most) << when;
  printf("  %s: %.1e m apart\n", when, off);
}

}  // namespace hawser::test
