// The linear solver of a Newton step: direct on one rank; on several, chains by LU a rank and the cuts by an
// exact small system (substructure.hpp), or, where the cuts are long, the whole on every rank
// (gathered_solver.hpp) or MUMPS, whichever is estimated cheapest. Small models that are cut are gathered.
// PETSc options under the prefix override.
#pragma once

#include <petscksp.h>

#include "hawser/system/system.hpp"

namespace hawser {

using KspHandle = Handle<KSP, KSPDestroy>;

// Sets type, preconditioner and options prefix ("statics_", "dynamics_") of a KSP for tangents of `system`.
void configure_linear_solver(KSP ksp, const System& system, const char* prefix);

// Number of negative eigenvalues of the symmetric part of J (Sylvester's inertia of a factorisation).
// Collective. -1 when the factorisation fails.
int negative_eigenvalues(Mat J);

}  // namespace hawser
