// The class LocalBlocks: obtains the stored blocks of a rank's diagonal part of the tangent from PETSc and
// returns them after assembly.
#include "hawser/system/local_blocks.hpp"

#include "hawser/base/handle.hpp"

namespace hawser {

LocalBlocks::LocalBlocks(Mat J) {
  PetscBool shared = PETSC_FALSE;
  check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(J), MATMPIBAIJ, &shared));
  matrix_ = J;
  if (shared) check(MatMPIBAIJGetSeqBAIJ(J, &matrix_, nullptr, nullptr));
  PetscBool known = PETSC_FALSE;
  check(MatGetRowIJ(matrix_, 0, PETSC_FALSE, PETSC_TRUE, &rows_, &starts_, &columns_, &known));
  if (!known) throw PetscFailure("a matrix without rows of blocks");
  check(MatSeqBAIJGetArray(matrix_, &values_));
}

// Restoring the array reports to PETSc that values have changed.
LocalBlocks::~LocalBlocks() {
  if (!matrix_) return;
  PetscBool known = PETSC_FALSE;
  (void)MatSeqBAIJRestoreArray(matrix_, &values_);
  (void)MatRestoreRowIJ(matrix_, 0, PETSC_FALSE, PETSC_TRUE, &rows_, &starts_, &columns_, &known);
}

}  // namespace hawser
