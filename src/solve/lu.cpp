// LU on one rank: for chains PETSc's LU; where lines may touch, a preconditioner around PETSc's LU of the
// nonzero blocks.
#include "hawser/solve/lu.hpp"

#include <petscksp.h>

#include <algorithm>
#include <vector>

#include "pc_shell.hpp"

namespace hawser {
namespace {

constexpr int kRows = 3, kSize = kRows * kRows;  // of a block

// Fill, and with it the cost of LU, grows steeply with the pairs of nodes in the pattern: for two layers on a
// drum, LU with all candidates costs five times as much as with those that touch.
struct NonzeroBlocks {
  Mat source = nullptr;  // matrix from which the pattern was taken, and the state of its pattern then
  PetscObjectState pattern = 0;
  std::vector<char> used;          // for each of its blocks: whether it has ever been nonzero
  Handle<Mat, MatDestroy> matrix;  // of the used blocks alone
  Handle<PC, PCDestroy> lu;
};

// A matrix in blocks as PETSc stores it: number of rows, starts of rows, columns.
struct Stored {
  PetscInt rows = 0;
  const PetscInt *starts = nullptr, *columns = nullptr;
  PetscScalar* values = nullptr;
};

// Marks blocks that are nonzero. Returns whether any of them was unused before. A used block remains used,
// because otherwise contact that comes and goes would need a new elimination order each time.
bool find_used(const Stored& m, std::vector<char>& used) {
  bool more = false;
  for (PetscInt row = 0; row < m.rows; ++row)
    for (PetscInt k = m.starts[row]; k < m.starts[row + 1]; ++k) {
      const PetscScalar* block = m.values + kSize * k;
      if (used[k] || (m.columns[k] != row &&
                      std::all_of(block, block + kSize, [](PetscScalar entry) { return entry == 0; })))
        continue;
      used[k] = 1;
      more = true;
    }
  return more;
}

PetscErrorCode make_matrix(MPI_Comm comm, const Stored& m, NonzeroBlocks& s) {
  PetscFunctionBegin;
  std::vector<PetscInt> starts{0}, columns;
  for (PetscInt row = 0; row < m.rows; ++row) {
    for (PetscInt k = m.starts[row]; k < m.starts[row + 1]; ++k)
      if (s.used[k]) columns.push_back(m.columns[k]);
    starts.push_back(static_cast<PetscInt>(columns.size()));
  }
  const PetscInt n = kRows * m.rows;
  PetscCall(MatCreate(comm, s.matrix.out()));
  PetscCall(MatSetSizes(s.matrix.get(), n, n, n, n));
  PetscCall(MatSetType(s.matrix.get(), MATSEQBAIJ));
  PetscCall(MatSeqBAIJSetPreallocationCSR(s.matrix.get(), kRows, starts.data(), columns.data(), nullptr));
  PetscCall(PCReset(s.lu.get()));
  PetscCall(PCSetOperators(s.lu.get(), s.matrix.get(), s.matrix.get()));
  PetscFunctionReturn(0);
}

PetscErrorCode copy_nonzero_blocks(Mat A, NonzeroBlocks& s) {
  PetscFunctionBegin;
  PetscObjectState pattern = 0;
  PetscCall(MatGetNonzeroState(A, &pattern));
  Stored m;
  PetscBool known = PETSC_FALSE;
  PetscCall(MatGetRowIJ(A, 0, PETSC_FALSE, PETSC_TRUE, &m.rows, &m.starts, &m.columns, &known));
  if (!known) SETERRQ(PETSC_COMM_SELF, PETSC_ERR_SUP, "a matrix without rows of blocks");
  PetscCall(MatSeqBAIJGetArray(A, &m.values));
  const size_t blocks = m.starts[m.rows];
  if (A != s.source || pattern != s.pattern || s.used.size() != blocks) s.used.assign(blocks, 0);
  s.source = A;
  s.pattern = pattern;
  if (find_used(m, s.used) || !s.matrix)
    PetscCall(make_matrix(PetscObjectComm(reinterpret_cast<PetscObject>(A)), m, s));
  PetscScalar *first = nullptr, *to = nullptr;
  PetscCall(MatSeqBAIJGetArray(s.matrix.get(), &first));
  to = first;
  for (size_t k = 0; k < s.used.size(); ++k)
    if (s.used[k]) to = std::copy_n(m.values + kSize * k, kSize, to);
  PetscCall(MatSeqBAIJRestoreArray(s.matrix.get(), &first));
  // Reports to PETSc that the values have changed.
  PetscCall(MatAssemblyBegin(s.matrix.get(), MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(s.matrix.get(), MAT_FINAL_ASSEMBLY));
  PetscCall(MatSeqBAIJRestoreArray(A, &m.values));
  PetscCall(MatRestoreRowIJ(A, 0, PETSC_FALSE, PETSC_TRUE, &m.rows, &m.starts, &m.columns, &known));
  PetscFunctionReturn(0);
}

PetscErrorCode set_up_lu(PC pc) {
  PetscFunctionBegin;
  NonzeroBlocks* s = nullptr;
  PetscCall(PCShellGetContext(pc, &s));
  Mat A = nullptr;
  PetscCall(PCGetOperators(pc, nullptr, &A));
  if (!s->lu) {
    PetscCall(PCCreate(PetscObjectComm(reinterpret_cast<PetscObject>(pc)), s->lu.out()));
    PetscCall(PCSetType(s->lu.get(), PCLU));
    PetscCall(PCFactorSetMatOrderingType(s->lu.get(), MATORDERINGQMD));
    const char* prefix = nullptr;
    PetscCall(PCGetOptionsPrefix(pc, &prefix));
    PetscCall(PCSetOptionsPrefix(s->lu.get(), prefix));
    if (prefix) PetscCall(PCSetFromOptions(s->lu.get()));
  }
  PetscCall(copy_nonzero_blocks(A, *s));
  PetscCall(PCSetUp(s->lu.get()));
  PCFailedReason reason = PC_NOERROR;
  PetscCall(PCGetFailedReason(s->lu.get(), &reason));
  PetscCall(PCSetFailedReason(pc, reason));
  PetscFunctionReturn(0);
}

PetscErrorCode apply_lu(PC pc, Vec b, Vec x) {
  PetscFunctionBegin;
  NonzeroBlocks* s = nullptr;
  PetscCall(PCShellGetContext(pc, &s));
  PetscCall(PCApply(s->lu.get(), b, x));
  PetscFunctionReturn(0);
}

}  // namespace

void use_lu(PC pc, MatrixPattern pattern) {
  if (pattern == MatrixPattern::coupled)
    return use_shell(pc, "LU of nonzero blocks", std::make_unique<NonzeroBlocks>(), set_up_lu, apply_lu);
  check(PCSetType(pc, PCLU));
  check(PCFactorSetMatOrderingType(pc, MATORDERINGNATURAL));
}

}  // namespace hawser
