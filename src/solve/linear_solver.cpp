// Choice of the direct solver for a Newton step, and the number of negative eigenvalues of a tangent, which
// shows whether an equilibrium is stable.
#include "hawser/solve/linear_solver.hpp"

#include "hawser/base/gather.hpp"
#include "hawser/solve/lu.hpp"
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

MatHandle symmetric_part(Mat J) {
  MatHandle a, t;
  check(MatTranspose(J, MAT_INITIAL_MATRIX, t.out()));
  check(MatAXPY(t.get(), 1, J, UNKNOWN_NONZERO_PATTERN));  // where it is the same it takes no room
  check(MatScale(t.get(), 0.5));
  check(MatConvert(t.get(), MATAIJ, MAT_INITIAL_MATRIX, a.out()));
  check(MatSetOption(a.get(), MAT_SYMMETRIC, PETSC_TRUE));
  return a;
}

namespace {

// Whether a matrix on one rank is positive definite, by Cholesky's factors in its own order, in which chains
// have no fill.
bool positive_definite(Mat a) {
  MatHandle factor;
  IS rows = nullptr, columns = nullptr;
  MatFactorInfo info;
  PetscInt negative = 0, zero = 0, positive = 0;
  check(MatFactorInfoInitialize(&info));
  check(MatGetFactor(a, MATSOLVERPETSC, MAT_FACTOR_CHOLESKY, factor.out()));
  check(MatGetOrdering(a, MATORDERINGNATURAL, &rows, &columns));
  check(MatCholeskyFactorSymbolic(factor.get(), a, rows, &info));
  check(MatCholeskyFactorNumeric(factor.get(), a, &info));
  check(ISDestroy(&rows));
  check(ISDestroy(&columns));
  MatFactorError error = MAT_FACTOR_NOERROR;
  check(MatFactorGetError(factor.get(), &error));
  if (error != MAT_FACTOR_NOERROR) return false;
  check(MatGetInertia(factor.get(), &negative, &zero, &positive));
  return negative == 0 && zero == 0;
}

}  // namespace

int negative_eigenvalues(Mat J, bool chains) {
  const MatHandle a = symmetric_part(J);
  const int size = ranks_of(PetscObjectComm(reinterpret_cast<PetscObject>(J)));
  if (chains && size == 1 && positive_definite(a.get())) return 0;
  MatHandle factor;
  if (MatGetFactor(a.get(), MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor.out())) return -1;
  check(MatMumpsSetIcntl(factor.get(), 24, 1));  // what PETSc asks for before it tells the inertia
  check(MatMumpsSetIcntl(factor.get(), 13, 1));
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info));
  if (MatCholeskyFactorSymbolic(factor.get(), a.get(), nullptr, &info)) return -1;
  if (MatCholeskyFactorNumeric(factor.get(), a.get(), &info)) return -1;
  PetscInt negative = 0, zero = 0, positive = 0;
  if (MatGetInertia(factor.get(), &negative, &zero, &positive)) return -1;
  return static_cast<int>(negative);
}

}  // namespace hawser
