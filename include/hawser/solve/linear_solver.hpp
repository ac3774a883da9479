// The linear solver of a Newton step, always direct. One rank uses LU. Several ranks use LU for their own
// rows and exact dense systems for the unknowns at the cuts (substructure.hpp), or MUMPS if one of these
// systems is so large (kMaxShared) that MUMPS is faster. PETSc options with the prefix override this.
#pragma once

#include <petscksp.h>

#include "hawser/solve/lu.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

using KspHandle = Handle<KSP, KSPDestroy>;

MatrixPattern pattern_of(const System& system);

// Sets type, preconditioner and options prefix ("statics_", "dynamics_") of a KSP for tangents of `system`.
void configure_linear_solver(KSP ksp, const System& system, const char* prefix);

}  // namespace hawser
