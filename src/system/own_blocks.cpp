// The class OwnBlocks: obtains the stored blocks of a rank's diagonal part of the tangent from PETSc and
// returns them after assembly.
#include "hawser/system/own_blocks.hpp"

#include "hawser/base/handle.hpp"

namespace hawser {

OwnBlocks::OwnBlocks(Mat J) {
  PetscBool shared = PETSC_FALSE;
  check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(J), MATMPIBAIJ, &shared));
  own_ = J;
  if (shared) check(MatMPIBAIJGetSeqBAIJ(J, &own_, nullptr, nullptr));
  PetscBool known = PETSC_FALSE;
  check(MatGetRowIJ(own_, 0, PETSC_FALSE, PETSC_TRUE, &rows_, &starts_, &columns_, &known));
  if (!known) throw PetscFailure("a matrix without rows of blocks");
  check(MatSeqBAIJGetArray(own_, &values_));
}

// Restoring the array reports to PETSc that values have changed.
OwnBlocks::~OwnBlocks() {
  if (!own_) return;
  PetscBool known = PETSC_FALSE;
  (void)MatSeqBAIJRestoreArray(own_, &values_);
  (void)MatRestoreRowIJ(own_, 0, PETSC_FALSE, PETSC_TRUE, &rows_, &starts_, &columns_, &known);
}

}  // namespace hawser
