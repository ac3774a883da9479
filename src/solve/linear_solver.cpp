// Choice of the direct solver and of the elimination order for a Newton step.
#include "hawser/solve/linear_solver.hpp"

#include "hawser/base/gather.hpp"
#include "hawser/solve/substructure.hpp"

namespace hawser {
namespace {

// Unknowns that some rank sees as ghosts, once for each rank that does.
long shared_unknowns(const System& system) {
  long shared = 3L * (system.mesh().blocks() - system.mesh().owned_blocks);
  MPI_Allreduce(MPI_IN_PLACE, &shared, 1, MPI_LONG, MPI_SUM, system.comm());
  return shared;
}

}  // namespace

void configure_linear_solver(KSP ksp, const System& system, const char* prefix) {
  const int size = ranks_of(system.comm());
  check(KSPSetOptionsPrefix(ksp, prefix));
  check(KSPSetType(ksp, KSPPREONLY));
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  // Chains in their own order have no fill; turn by turn on a drum that order costs tens of times what
  // minimum degree does.
  const MatOrderingType order = system.coupled() ? MATORDERINGQMD : MATORDERINGNATURAL;
  if (size > 1 && shared_unknowns(system) <= kMaxShared) {
    use_substructuring(pc, order);
  } else {
    check(PCSetType(pc, PCLU));
    if (size > 1)
      check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
    else
      check(PCFactorSetMatOrderingType(pc, order));
  }
  check(KSPSetFromOptions(ksp));
}

}  // namespace hawser
