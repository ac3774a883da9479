// Statics with contact as an exact complementarity problem: gaps are not negative, forces don't pull, and one
// of the two is zero. Newton on the reduced space of constraints that are active (Benson & Munson 2006,
// Optim. Methods Softw. 21), PETSc's SNESVI `vinewtonrsls`, with an l2 line search.
#pragma once

#include "hawser/solve/statics.hpp"

namespace hawser {

struct UnilateralReport {
  int iterations = 0;
  int constraints = 0, active = 0;  // over all ranks
  double deepest = 0;               // m, largest penetration that is left
  ResidualNorms norms;
};

// From the equilibrium with springs that solve_statics() found. The contacts are without friction; the
// multipliers stay with the terms. Throws SolveError when it does not converge.
UnilateralReport solve_unilateral(System& system, const StaticsSettings& settings, State& state);

}  // namespace hawser
