// Stability of an equilibrium: it is stable where the symmetric part of its tangent has no negative
// eigenvalue.
#pragma once

#include "hawser/system/system.hpp"

namespace hawser {

// (J + J')/2 in the format and the pattern of J, which couples both ways whatever it couples. Collective.
MatHandle symmetric_blocks(Mat J);

// The same in PETSc's format of single rows (AIJ). Collective.
MatHandle symmetric_part(Mat J);

// Number of negative eigenvalues of a symmetric matrix in PETSc's format of single rows, by Sylvester's law
// of inertia of a factorisation by MUMPS, which takes more room than all else in statics. Collective. -1 when
// the factorisation fails.
int negative_pivots(Mat a);

// The same of the symmetric part of a tangent. chains: nothing couples its lines; where no line is cut
// between ranks, Cholesky's factorisation, which overwrites a copy of that part, then shows whether there are
// any, but not where lines meet at a joint, since that makes fill. Collective.
int negative_eigenvalues(Mat J, bool chains = false);

}  // namespace hawser
