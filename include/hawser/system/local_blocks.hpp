// Direct access to the values of this rank's diagonal part of a BAIJ matrix in blocks of 3, which avoids
// PETSc's search, copies and stash.
#pragma once

#include <petscmat.h>

#include <algorithm>
#include <span>

namespace hawser {

class LocalBlocks {
 public:
  LocalBlocks() = default;
  // J must have been assembled once, so that its pattern is known.
  explicit LocalBlocks(Mat J);
  LocalBlocks(const LocalBlocks&) = delete;
  LocalBlocks& operator=(const LocalBlocks&) = delete;
  ~LocalBlocks();

  int rows() const { return rows_; }
  // Columns of the blocks in a row, from the column `first`.
  std::span<const PetscInt> columns_from(int row, int first) const {
    const PetscInt* end = columns_ + starts_[row + 1];
    return {std::lower_bound(columns_ + starts_[row], end, first), end};
  }
  // Values of a block: 3x3, column-major. Rows and columns count from the first one of this rank. Null: the
  // block is not in the pattern. `before`: the block found last in this row, or null; its successor is tried
  // first.
  double* at(int row, int column, const double* before = nullptr) const {
    const PetscInt* from = columns_ + starts_[row];
    const PetscInt* to = columns_ + starts_[row + 1];
    if (before) {
      const PetscInt* next = columns_ + (before - values_) / 9 + 1;
      if (next < to && *next == column) return values_ + 9 * (next - columns_);
    }
    while (to - from > 8) {
      const PetscInt* middle = from + (to - from) / 2;
      (column < *middle ? to : from) = middle;
    }
    for (; from < to; ++from)
      if (*from == column) return values_ + 9 * (from - columns_);
    return nullptr;
  }

 private:
  Mat matrix_ = nullptr;
  PetscInt rows_ = 0;
  const PetscInt *starts_ = nullptr, *columns_ = nullptr;
  double* values_ = nullptr;
};

}  // namespace hawser
