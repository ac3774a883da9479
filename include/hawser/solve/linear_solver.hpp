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

}  // namespace hawser
