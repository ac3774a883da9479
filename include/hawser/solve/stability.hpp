// Stability of an equilibrium: it is stable where the symmetric part of its tangent has no negative
// eigenvalue.
#pragma once

#include "hawser/system/system.hpp"

namespace hawser {

// (J + J')/2, in PETSc's format of single rows (AIJ). Collective.
MatHandle symmetric_part(Mat J);

// Number of negative eigenvalues of the symmetric part of J (Sylvester's inertia of a factorisation by MUMPS,
// which takes more room than all else in statics). chains: nothing couples its lines; on one rank Cholesky's
// factorisation, which overwrites a copy of that part, then tells whether there are any, but not where lines
// meet at a joint, since that makes fill. Collective. -1 when the factorisation fails.
int negative_eigenvalues(Mat J, bool chains = false);

}  // namespace hawser
