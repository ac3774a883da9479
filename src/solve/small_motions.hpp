// Matrices of small motions about a state at rest, for natural modes and responses to waves. Those of
// stiffness, mass and damping are in PETSc's format of single rows (AIJ) with the pattern of the tangent.
// Collective.
#pragma once

#include <petscksp.h>

#include "hawser/system/system.hpp"

namespace hawser {

// Tangent by the weights of displacement, velocity and acceleration, with 1 in the diagonal of held
// components, in the format of the system's matrices.
MatHandle tangent_at_rest(System& system, const Kinematics& state, const Weights& weights);

struct StiffnessAtRest {
  MatHandle matrix;
  bool is_symmetric = true;
};
// Symmetric part of the tangent, and in the unknowns of bodies the antisymmetric part as well, which forces
// without a potential cause. That of lines is due to sliding friction, which is excluded. Held components
// have the stiffness 1.
StiffnessAtRest stiffness_at_rest(System& system, const Kinematics& state);
// Symmetric part; held components have no mass.
MatHandle mass_at_rest(System& system, const Kinematics& state);
// The tangent itself; held components have no damping.
MatHandle damping_at_rest(System& system, const Kinematics& state);

// Sets up a direct solution with MUMPS.
void solve_directly(KSP ksp);

}  // namespace hawser
