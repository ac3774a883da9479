// Choice of the direct solver for a Newton step.
#include "hawser/solve/linear_solver.hpp"

#include "hawser/base/mpi.hpp"
#include "hawser/solve/substructure.hpp"

namespace hawser {

MatrixPattern pattern_of(const System& system) {
  return system.coupled() ? MatrixPattern::coupled : MatrixPattern::chains;
}

void configure_linear_solver(KSP ksp, const System& system, const char* prefix) {
  check(KSPSetOptionsPrefix(ksp, prefix));
  check(KSPSetType(ksp, KSPPREONLY));
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  if (ranks_of(system.comm()) == 1)
    use_lu(pc, pattern_of(system));
  else
    use_substructuring(pc, pattern_of(system));
  check(KSPSetFromOptions(ksp));
}

}  // namespace hawser
