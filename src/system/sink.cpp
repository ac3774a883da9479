#include "hawser/system/sink.hpp"

#include <algorithm>
#include <cassert>

#include "hawser/base/handle.hpp"

namespace hawser {
namespace {

// Three columns of a row-major matrix with m rows and columns, times T.
void turn_columns(const Mat3& T, int m, double* p) {
  for (int r = 0; r < m; ++r, p += m) {
    const double a0 = p[0], a1 = p[1], a2 = p[2];
    for (int c = 0; c < 3; ++c) p[c] = a0 * T(0, c) + a1 * T(1, c) + a2 * T(2, c);
  }
}

}  // namespace

void Sink::add(std::span<const int> blocks, const double* f, const double* K, const double* C,
               const double* M) {
  const int n = static_cast<int>(blocks.size());
  assert(n <= kMaxBlocks);
  if (force_ && f) {
    double* out = force_->data();
    for (int i = 0; i < n; ++i) {
      const int b = blocks[static_cast<size_t>(i)];
      if (b >= owned_blocks_) continue;
      double square = 0;
      for (int c = 0; c < 3; ++c) {
        out[3 * b + c] += f[3 * i + c];
        square += f[3 * i + c] * f[3 * i + c];
      }
      (*squares_)[static_cast<size_t>((*square_of_block_)[static_cast<size_t>(b)])] += square;
    }
  }
  if (!matrix_) return;

  const int m = 3 * n;
  double J[9 * kMaxBlocks * kMaxBlocks];
  PetscInt rows[kMaxBlocks], columns[kMaxBlocks];
  const double wC = C ? weights_.C : 0, wM = M ? weights_.M : 0;
  if (K && weights_.K != 0) {
    for (int i = 0; i < m * m; ++i) J[i] = weights_.K * K[i];
    if (!retraction_->empty())
      for (int j = 0; j < n; ++j) {
        const size_t b = static_cast<size_t>(blocks[static_cast<size_t>(j)]);
        if ((*is_rotation_)[b]) turn_columns((*retraction_)[b], m, J + 3 * j);
      }
  } else {
    std::fill(J, J + m * m, 0.0);
  }
  if (wC != 0 && wM != 0)
    for (int i = 0; i < m * m; ++i) J[i] += wC * C[i] + wM * M[i];
  else if (wC != 0)
    for (int i = 0; i < m * m; ++i) J[i] += wC * C[i];
  else if (wM != 0)
    for (int i = 0; i < m * m; ++i) J[i] += wM * M[i];

  bool any_held = false;
  for (int i = 0; i < n; ++i) {
    const int b = blocks[static_cast<size_t>(i)];
    const size_t s = static_cast<size_t>(b);
    columns[i] = (*global_block_)[s];
    rows[i] = b < owned_blocks_ ? columns[i] : -1;  // negative rows are skipped: another rank computes them
    any_held |= !held_->empty() && (*held_)[s];
  }
  if (any_held)
    for (int i = 0; i < n; ++i)
      for (int c = 0; c < 3; ++c)
        if ((*held_)[static_cast<size_t>(blocks[static_cast<size_t>(i)])] >> c & 1)
          for (int k = 0; k < m; ++k) J[(3 * i + c) * m + k] = J[k * m + 3 * i + c] = 0;
  check(MatSetValuesBlocked(matrix_, n, rows, n, columns, J, ADD_VALUES));
}

}  // namespace hawser
