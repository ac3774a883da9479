// Cable element: a straight bar that carries tension only.
#pragma once

#include "hawser/kernels/stiffness_table.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct CableSection {
  double length = 0;  // m, unstretched
  double EA = 0;      // N
  double beta = 0;    // s, stiffness-proportional damping of a taut element
  // Tension over strain, times EA over its slope at zero; null: linear. Damping stays that of EA.
  const StiffnessTable* tension = nullptr;
  double free_strain = 0;  // at which there is no tension: thermal expansion

  // Tension [N] of a strain, its slope and its energy a unit of length.
  StiffnessTable::Value axial(double strain) const {
    if (!tension) return {EA * strain, EA, 0.5 * EA * strain * strain};
    const double share = EA / tension->initial();
    const StiffnessTable::Value v = tension->at(strain);
    return {share * v.force, share * v.slope, share * v.energy};
  }
};

// Where the nodes are: nothing is copied. m, m/s.
struct CableEnds {
  const Vec3 &x1, &x2, &v1, &v2;
};

// What one end feels and minus what the other does, N, and its derivatives by x2 - x1 and v2 - v1.
struct CablePull {
  Vec3 force;
  Mat3 k, c;  // c is zero unless it is damped
};

struct CableStress {
  double tension = 0;        // N, never negative
  double strain_energy = 0;  // J
  double dissipation = 0;    // W
};

// T = EA max(0, e + beta e'), e = l/L - 1 - free strain, for e > 0. The force on the first end is -force, on
// the second force: residuals. `convex` keeps the axial stiffness of a slack element, so that statics far
// from the solution has something to pull with.
Vec3 cable_pull(const CableSection& s, const CableEnds& e);
void cable_pull(const CableSection& s, const CableEnds& e, bool convex, CablePull& out);

CableStress cable_stress(const CableSection& s, const CableEnds& e);

}  // namespace hawser
