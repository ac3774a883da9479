// The values of this rank's diagonal part of a BAIJ matrix in blocks of 3, to add to without PETSc's search,
// copies and stash.
#pragma once

#include <petscmat.h>

#include <algorithm>
#include <span>

namespace hawser {

class OwnBlocks {
 public:
  OwnBlocks() = default;
  // Of a matrix whose pattern is known: assembled once.
  explicit OwnBlocks(Mat J);
  OwnBlocks(const OwnBlocks&) = delete;
  OwnBlocks& operator=(const OwnBlocks&) = delete;
  ~OwnBlocks();

  int rows() const { return rows_; }
  // The columns of the blocks that a row has, from the column `first` on.
  std::span<const PetscInt> columns_from(int row, int first) const {
    const PetscInt* end = columns_ + starts_[row + 1];
    return {std::lower_bound(columns_ + starts_[row], end, first), end};
  }
  // 3x3, column-major; rows and columns counted from the first of this rank. Null: not in the pattern.
  // `before`: what was last found in this row, or null; the block after it is looked at first.
  double* at(int row, int column, const double* before = nullptr) const {
    const PetscInt *from = columns_ + starts_[row], *to = columns_ + starts_[row + 1];
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
  Mat own_ = nullptr;
  PetscInt rows_ = 0;
  const PetscInt *starts_ = nullptr, *columns_ = nullptr;
  double* values_ = nullptr;
};

}  // namespace hawser
