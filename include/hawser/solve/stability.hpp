// Stability of an equilibrium: it does not diverge if the symmetric part of its tangent has no negative
// eigenvalue. If forces have no potential, the reverse need not hold (docs/theory/statics.md, "Stability").
#pragma once

#include "hawser/solve/lu.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// (J + J')/2 in the format and with the pattern of J; the pattern must be symmetric. Collective.
MatHandle symmetric_blocks(Mat J);

// The same in PETSc's format of single rows (AIJ). Collective.
MatHandle symmetric_part(Mat J);

// Number of negative eigenvalues of a symmetric matrix in PETSc's format of single rows (AIJ), by Sylvester's
// law of inertia from a factorisation by MUMPS, which takes more memory than everything else in statics.
// Collective. -1: the factorisation failed.
int negative_pivots(Mat a);

// The same for the symmetric part of a tangent. If it is that of chains, of which none is cut between ranks,
// and no lines meet at a joint (which causes fill), Cholesky's factorisation of a copy can show that there
// are none without MUMPS. Collective.
int negative_eigenvalues(Mat J, MatrixPattern pattern = MatrixPattern::coupled);

struct Stability {
  // Number of negative eigenvalues of the symmetric part of the tangent. If everything else is stable while
  // the bodies, at most 50, are held: number of real negative eigenvalues of M^-1 K, with the mass M of the
  // bodies and their stiffness K by static condensation, which need not be symmetric; if none is negative but
  // one is complex, again that of the symmetric part. -1: not known.
  int negative = 0;
  bool by_bodies = false;  // everything else is stable while the bodies are held
  // The motion of these bodies that diverges fastest, with everything else in equilibrium, of any size. Of
  // several equally fast ones it is one that does not depend on rounding. Null on all ranks: none is known.
  VecHandle motion;
};

// Stability of an equilibrium with the tangent J. Collective.
Stability stability(System& system, const Kinematics& state, Mat J);

}  // namespace hawser
