// The class Assembler: it adds forces and weighted derivatives of a term to residual and tangent, and takes
// account of rotation increments, held components, ties to frames and rows of other ranks.
#include "hawser/system/assembler.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cstring>

#include "hawser/base/handle.hpp"
#include "hawser/math/wide3.hpp"

namespace hawser {
namespace {

// Multiplies three columns of a row-major matrix with m rows by T from the right.
void turn_columns(const Mat3& T, int m, double* p) {
  for (int r = 0; r < m; ++r, p += m) {
    const double a0 = p[0], a1 = p[1], a2 = p[2];
    for (int c = 0; c < 3; ++c) p[c] = a0 * T(0, c) + a1 * T(1, c) + a2 * T(2, c);
  }
}

using wide::Row;

inline Row load4(const double* p) {
  Row r;
  std::memcpy(&r, p, sizeof r);
  return r;
}
inline void add4(double* p, Row a) {
  a += load4(p);
  std::memcpy(p, &a, sizeof a);
}

// Adds three rows of a row-major matrix of m columns to a column-major block. It reads one entry beyond.
inline void add_transposed(const double* J, int m, double* to) {
  const Row r0 = load4(J), r1 = load4(J + m), r2 = load4(J + 2 * m);
  const Row a = __builtin_shufflevector(r0, r1, 0, 4, 0, 1), b = __builtin_shufflevector(r1, r2, 1, 5, 1, 2);
  add4(to, __builtin_shufflevector(a, r2, 0, 1, 4, 3));
  add4(to + 4, __builtin_shufflevector(b, r0, 0, 1, 6, 3));
  to[8] += r2[2];
}

// J = w A or J += w A for n x n blocks. The usual numbers of blocks have loops of constant length.
template <bool first, int n>
void weigh(double w, const double* A, double* J) {
  for (int i = 0; i < 9 * n * n; ++i) J[i] = (first ? 0 : J[i]) + w * A[i];
}
template <bool first>
void weigh(int n, double w, const double* A, double* J) {
  if (n == 2) return weigh<first, 2>(w, A, J);
  if (n == 4) return weigh<first, 4>(w, A, J);
  for (int i = 0; i < 9 * n * n; ++i) J[i] = (first ? 0 : J[i]) + w * A[i];
}

}  // namespace

void Assembler::add_force(int b, double x, double y, double z) {
  if (b >= owned_blocks_ && !sending_) return;
  double* out = force_->data() + 3 * b;
  out[0] += x;
  out[1] += y;
  out[2] += z;
  (*squares_)[b] += x * x + y * y + z * z;
}

void Assembler::add(std::span<const int> blocks, const double* f, const double* K, const double* C,
                    const double* M) {
  const int n = static_cast<int>(blocks.size());
  assert(n <= kMaxBlocks);
  const int* block = blocks.data();
  if (force_ && f)
    for (int i = 0; i < n; ++i) add_force(block[i], f[3 * i], f[3 * i + 1], f[3 * i + 2]);
  if (!matrix_) return;
  if (std::any_of(blocks.begin(), blocks.end(), [this](int b) { return tied(b); }))
    return add_tied(blocks, K, C, M);

  const int m = 3 * n;
  double J[9 * kMaxBlocks * kMaxBlocks + 1];
  if (K && weights_.K != 0) {
    weigh<true>(n, weights_.K, K, J);
    for (int j = 0; j < n; ++j)
      if (const int turn = (*turn_of_)[block[j]]; turn >= 0) turn_columns((*retraction_)[turn], m, J + 3 * j);
  } else {
    std::fill(J, J + m * m, 0.0);
  }
  if (C && weights_.C != 0) weigh<false>(n, weights_.C, C, J);
  if (M && weights_.M != 0) weigh<false>(n, weights_.M, M, J);
  put(block, n, J);
}

// Derivatives by the unknowns of the frames (TiedNodeForces). The stiffness from the rotation of the forces'
// arms is added by TiedNodeForces::add_geometric_stiffness.
void Assembler::add_tied(std::span<const int> blocks, const double* K, const double* C, const double* M) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Index m = 3 * static_cast<Eigen::Index>(blocks.size());
  const auto of = [m](const double* A) { return Eigen::Map<const Matrix>(A, m, m); };
  const auto [to, P, V] = ties_->unknowns(blocks);
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(to.size());
  Matrix k = Matrix::Zero(m, size);
  if (K) k += of(K) * P;
  if (C) k += of(C) * V;
  if (M) k += ties_->director_weight() * of(M) * V;
  Matrix J = weights_.K * P.transpose() * k;
  for (Eigen::Index j = 0; j < size; j += 3)
    if (const int turn = (*turn_of_)[to[j / 3]]; turn >= 0)
      J.middleCols<3>(j) = (J.middleCols<3>(j) * (*retraction_)[turn]).eval();
  if (C) J += weights_.C * P.transpose() * of(C) * P;
  if (M) J += weights_.M * P.transpose() * of(M) * P;
  std::vector<double> own(J.data(), J.data() + J.size());
  own.push_back(0);
  put(to.data(), static_cast<int>(to.size()), own.data());
}

// Adds J to the matrix, without rows and columns of held components. J has one entry more than its n x n
// blocks.
void Assembler::put(const int* block, int n, double* J) {
  const int m = 3 * n;
  for (int i = 0; i < n; ++i) {
    const unsigned char held = (*held_)[block[i]];
    if (!held) continue;
    for (int c = 0; c < 3; ++c)
      if (held >> c & 1)
        for (int k = 0; k < m; ++k) J[(3 * i + c) * m + k] = J[k * m + 3 * i + c] = 0;
  }
  for (int i = 0; i < n; ++i) {
    const int row = block[i];
    if (row >= owned_blocks_) {  // its rank computes it, or gets it from here while sending_
      const bool none = !sending_ || std::all_of(J + 3 * i * m, J + 3 * (i + 1) * m,
                                                 [](double entry) { return entry == 0; });
      for (int j = 0; j < n && !none; ++j) add_elsewhere(row, block[j], J + 3 * i * m + 3 * j, m);
      continue;
    }
    double* to = nullptr;
    for (int j = 0; j < n; ++j) {
      const double* from = J + 3 * i * m + 3 * j;
      to = block[j] < owned_blocks_ ? own_->at(row, block[j], to) : nullptr;
      if (to)
        add_transposed(from, m, to);
      else
        add_elsewhere(row, block[j], from, m);
    }
  }
}

// Adds a block in a row or a column of another rank.
void Assembler::add_elsewhere(int row, int column, const double* J, int m) {
  double block[9];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) block[3 * r + c] = J[r * m + c];
  const PetscInt r = (*global_block_)[row], c = (*global_block_)[column];
  check(MatSetValuesBlocked(matrix_, 1, &r, 1, &c, block, ADD_VALUES));
}

void Assembler::add_between(int a, int b, const Vec3& f, const Mat3* k, const Mat3* c) {
  if (force_) {
    add_force(a, -f[0], -f[1], -f[2]);
    add_force(b, f[0], f[1], f[2]);
  }
  if (!matrix_) return;
  const int blocks[2] = {a, b};
  if (tied(a) || tied(b)) {
    double K[36], C[36];
    for (const auto& [from, to] : {std::pair(k, K), std::pair(c, C)})
      for (int i = 0; i < 36; ++i)
        to[i] = from ? ((i / 18 == i % 6 / 3) ? 1 : -1) * (*from)(i / 6 % 3, i % 3) : 0;
    return add_tied(blocks, K, C, nullptr);
  }
  double J[37];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double s = (k ? weights_.K * (*k)(i, j) : 0) + (c ? weights_.C * (*c)(i, j) : 0);
      J[6 * i + j] = J[6 * i + 21 + j] = s;
      J[6 * i + 3 + j] = J[6 * i + 18 + j] = -s;
    }
  put(blocks, 2, J);
}

void Assembler::add_mean_between(int a, int b, const Vec3& f, const Mat3* k) {
  const Vec3 counted = mean_weight_ * f;
  if (mean_)
    for (const int end : {a, b})
      if (end < owned_blocks_) Eigen::Map<Vec3>(mean_->data() + 3 * end) += end == a ? Vec3(-f) : f;
  if (!k) return add_between(a, b, counted, nullptr, nullptr);
  const Mat3 stiffness = mean_weight_ * *k;
  add_between(a, b, counted, &stiffness, nullptr);
}

void Assembler::add_weighted(int a, int b, const double* f, const double* J) {
  if (force_) {
    add_force(a, f[0], f[1], f[2]);
    add_force(b, f[3], f[4], f[5]);
  }
  if (!matrix_) return;
  const int blocks[2] = {a, b};
  double own[37];
  std::copy(J, J + 36, own);
  put(blocks, 2, own);
}

void Assembler::add_masses(int a, int b, const double* f, double own, double shared) {
  if (force_) {
    add_force(a, f[0], f[1], f[2]);
    add_force(b, f[3], f[4], f[5]);
  }
  const int blocks[2] = {a, b};
  const bool frames = tied(a) || tied(b);
  if (!matrix_ || (weights_.M == 0 && !frames)) return;
  const double weight = frames ? 1 : weights_.M;
  double J[37] = {};
  for (int i = 0; i < 6; ++i) {
    J[7 * i] = weight * own;
    J[6 * i + (i + 3) % 6] = weight * shared;
  }
  if (frames) return add_tied(blocks, nullptr, nullptr, J);
  put(blocks, 2, J);
}

}  // namespace hawser
