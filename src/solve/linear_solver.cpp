// Choice of the direct solver for a Newton step.
#include "hawser/solve/linear_solver.hpp"

#include "hawser/base/gather.hpp"
#include "hawser/solve/lu.hpp"
#include "hawser/solve/substructure.hpp"

namespace hawser {
namespace {

// Number of unknowns that are ghosts on some rank, counted once for each such rank.
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
  if (size == 1) {
    use_lu(pc, system.coupled());
  } else if (shared_unknowns(system) <= kMaxShared) {
    use_substructuring(pc, system.coupled());
  } else {
    check(PCSetType(pc, PCLU));
    check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  }
  check(KSPSetFromOptions(ksp));
}

}  // namespace hawser
