// The linear solver of a Newton step, always direct. On one rank: LU. On several: a rank's own rows by LU and
// the unknowns at the cuts by an exact dense system (substructure.hpp), or MUMPS where these are so many
// (kMaxShared) that it is the faster of the two. PETSc options under the prefix override.
#pragma once

#include <petscksp.h>

#include "hawser/system/system.hpp"

namespace hawser {

using KspHandle = Handle<KSP, KSPDestroy>;

// Sets type, preconditioner and options prefix ("statics_", "dynamics_") of a KSP for tangents of `system`.
void configure_linear_solver(KSP ksp, const System& system, const char* prefix);

// (J + J')/2, in PETSc's format of single rows (AIJ). Collective.
MatHandle symmetric_part(Mat J);

// Number of negative eigenvalues of the symmetric part of J (Sylvester's inertia of a factorisation by MUMPS,
// which takes more room than all else in statics). chains: nothing couples its lines; on one rank Cholesky's
// factors, small and quick, then tell whether there are any. Collective. -1 when the factorisation fails.
int negative_eigenvalues(Mat J, bool chains = false);

}  // namespace hawser
