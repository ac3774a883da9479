// The class Assembler: adds forces and weighted derivatives of a term to residual and tangent, with rotation
// increments, held components, ties to frames and rows of other ranks.
#include "hawser/system/assembler.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstring>

#include "hawser/base/handle.hpp"
#include "hawser/math/wide3.hpp"

namespace hawser {
namespace {

// Multiplies three columns of a row-major matrix with `rows` rows of m entries by T from the right.
void turn_columns(const Mat3& T, int rows, int m, double* p) {
  for (int r = 0; r < rows; ++r, p += m) {
    const double a0 = p[0];
    const double a1 = p[1];
    const double a2 = p[2];
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

// Adds three rows of a row-major matrix of m columns to a column-major block. The last row is read with the
// entry before it, so that no entry after the matrix is read.
inline void add_transposed(const double* J, int m, double* to) {
  const Row r0 = load4(J);
  const Row r1 = load4(J + m);
  const Row r2 = load4(J + 2 * m - 1);
  const Row a = __builtin_shufflevector(r0, r1, 0, 4, 0, 1);
  const Row b = __builtin_shufflevector(r1, r2, 1, 6, 1, 2);
  add4(to, __builtin_shufflevector(a, r2, 0, 1, 5, 3));
  add4(to + 4, __builtin_shufflevector(b, r0, 0, 1, 6, 3));
  to[8] += r2[3];
}

// J = w A or J += w A. The usual sizes, of 2 x 2 and 4 x 4 blocks, have loops of constant length.
template <bool first>
void weigh(int entries, double w, const double* A, double* J) {
  const auto all = [=](int count) {
    for (int i = 0; i < count; ++i) J[i] = (first ? 0 : J[i]) + w * A[i];
  };
  if (entries == 36) return all(36);
  if (entries == 144) return all(144);
  all(entries);
}

}  // namespace

Assembler Assembler::for_residual(const LocalMesh& mesh, const TiedNodeForces& ties, double mean_weight,
                                  const Residual& to) {
  Assembler a;
  a.owned_blocks_ = mesh.owned_blocks;
  a.ties_ = &ties;
  a.mean_weight_ = mean_weight;
  a.force_ = &to.force;
  a.mean_ = &to.mean;
  a.squares_ = &to.squares;
  return a;
}

Assembler Assembler::for_tangent(const LocalMesh& mesh, const TiedNodeForces& ties, double mean_weight,
                                 const Weights& weights, bool convex, const Tangent& to) {
  Assembler a;
  a.owned_blocks_ = mesh.owned_blocks;
  a.global_block_ = &mesh.global_block;
  a.ties_ = &ties;
  a.mean_weight_ = mean_weight;
  a.weights_ = weights;
  a.convex_ = convex;
  a.matrix_ = to.matrix;
  a.blocks_ = &to.blocks;
  a.retraction_ = &to.retraction;
  a.turn_of_ = &to.turn_of;
  a.held_ = &to.held;
  return a;
}

void Assembler::add_force(int b, double x, double y, double z) {
  if (b >= owned_blocks_ && !sending_) return;
  double* out = force_->data() + 3 * b;
  out[0] += x;
  out[1] += y;
  out[2] += z;
  (*squares_)[b] += x * x + y * y + z * z;
}

void Assembler::add(std::span<const int> rows, std::span<const int> columns, ForceView force,
                    DerivativeView K, DerivativeView C, DerivativeView M) {
  const int n = 3 * static_cast<int>(rows.size());
  const int m = 3 * static_cast<int>(columns.size());
  const int entries = n * m;
  assert(!force.data() || force.size() == n);
  assert(K.none_or_sized(n, m) && C.none_or_sized(n, m) && M.none_or_sized(n, m));
  if (const double* f = force.data(); force_ && f)
    for (size_t i = 0; i < rows.size(); ++i) add_force(rows[i], f[3 * i], f[3 * i + 1], f[3 * i + 2]);
  if (!matrix_) return;
  const auto is_tied = [this](int b) { return tied(b); };
  if (std::any_of(columns.begin(), columns.end(), is_tied) || std::any_of(rows.begin(), rows.end(), is_tied))
    return add_tied(rows, columns, K, C, M);

  constexpr int kFew = 576;
  double few[kFew];
  std::vector<double> many(entries > kFew ? static_cast<size_t>(entries) : 0);
  double* J = entries > kFew ? many.data() : few;
  if (K.data() && weights_.K != 0) {
    weigh<true>(entries, weights_.K, K.data(), J);
    for (size_t j = 0; j < columns.size(); ++j)
      if (const int turn = (*turn_of_)[columns[j]]; turn >= 0)
        turn_columns((*retraction_)[turn], n, m, J + 3 * j);
  } else {
    std::fill(J, J + entries, 0.0);
  }
  if (C.data() && weights_.C != 0) weigh<false>(entries, weights_.C, C.data(), J);
  if (M.data() && weights_.M != 0) weigh<false>(entries, weights_.M, M.data(), J);
  put(rows, columns, J);
}

// Derivatives by the unknowns of the frames (TiedNodeForces). The stiffness from the rotation of the forces'
// arms is added by TiedNodeForces::add_geometric_stiffness.
void Assembler::add_tied(std::span<const int> rows, std::span<const int> columns, DerivativeView K,
                         DerivativeView C, DerivativeView M) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Index n = 3 * static_cast<Eigen::Index>(rows.size());
  const Eigen::Index m = 3 * static_cast<Eigen::Index>(columns.size());
  const auto matrix_of = [n, m](DerivativeView A) { return Eigen::Map<const Matrix>(A.data(), n, m); };
  const TiedNodeForces::Unknowns row_unknowns = ties_->unknowns(rows);
  const auto [to, P, V] = ties_->unknowns(columns);
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(to.size());
  Matrix k = Matrix::Zero(n, size);
  if (K.data()) k += matrix_of(K) * P;
  if (C.data()) k += matrix_of(C) * V;
  if (M.data()) k += ties_->director_weight() * matrix_of(M) * V;
  k *= weights_.K;
  for (Eigen::Index j = 0; j < size; j += 3)
    if (const int turn = (*turn_of_)[to[j / 3]]; turn >= 0)
      k.middleCols<3>(j) = (k.middleCols<3>(j) * (*retraction_)[turn]).eval();
  if (C.data()) k += weights_.C * matrix_of(C) * P;
  if (M.data()) k += weights_.M * matrix_of(M) * P;
  Matrix J = row_unknowns.P.transpose() * k;
  put(row_unknowns.to, to, J.data());
}

// Adds J to the matrix, without rows and columns of held components, which it sets to zero in J.
void Assembler::put(std::span<const int> rows, std::span<const int> columns, double* J) {
  const size_t n = rows.size();
  const size_t m = 3 * columns.size();
  for (size_t i = 0; i < n; ++i)
    if (const unsigned char held = (*held_)[rows[i]])
      for (size_t c = 0; c < 3; ++c)
        if (held >> c & 1) std::fill_n(J + (3 * i + c) * m, m, 0.0);
  for (size_t j = 0; j < columns.size(); ++j)
    if (const unsigned char held = (*held_)[columns[j]])
      for (size_t c = 0; c < 3; ++c)
        if (held >> c & 1)
          for (size_t k = 0; k < 3 * n; ++k) J[k * m + 3 * j + c] = 0;
  const int stride = static_cast<int>(m);
  for (size_t i = 0; i < n; ++i) {
    const int row = rows[i];
    if (row >= owned_blocks_) {  // the row's owner computes it, or receives it from here while sending_
      const bool none = !sending_ || std::all_of(J + 3 * i * m, J + 3 * (i + 1) * m,
                                                 [](double entry) { return entry == 0; });
      for (size_t j = 0; j < columns.size() && !none; ++j)
        add_nonlocal(row, columns[j], J + 3 * i * m + 3 * j, stride);
      continue;
    }
    double* to = nullptr;
    for (size_t j = 0; j < columns.size(); ++j) {
      const double* from = J + 3 * i * m + 3 * j;
      to = columns[j] < owned_blocks_ ? blocks_->at(row, columns[j], to) : nullptr;
      if (to)
        add_transposed(from, stride, to);
      else
        add_nonlocal(row, columns[j], from, stride);
    }
  }
}

// Adds a block in a row or a column of another rank.
void Assembler::add_nonlocal(int row, int column, const double* J, int m) {
  double block[9];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) block[3 * r + c] = J[r * m + c];
  const PetscInt r = (*global_block_)[row];
  const PetscInt c = (*global_block_)[column];
  check(MatSetValuesBlocked(matrix_, 1, &r, 1, &c, block, ADD_VALUES));
}

void Assembler::add(int block, const Vec3& f, const Mat3* K, const Mat3* C, const Mat3* M) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  RowMajor k, c, m;
  if (K) k = *K;
  if (C) c = *C;
  if (M) m = *M;
  const auto view = [](const Mat3* given, const RowMajor& A) {
    return given ? DerivativeView(A) : DerivativeView();
  };
  add({&block, 1}, f, view(K, k), view(C, c), view(M, m));
}

void Assembler::add_between(int a, int b, const Vec3& f, const Mat3* k, const Mat3* c) {
  if (force_) {
    add_force(a, -f[0], -f[1], -f[2]);
    add_force(b, f[0], f[1], f[2]);
  }
  if (!matrix_) return;
  const int blocks[2] = {a, b};
  if (tied(a) || tied(b)) {
    Mat6 K = Mat6::Zero(), C = Mat6::Zero();
    if (k) K << *k, -*k, -*k, *k;
    if (c) C << *c, -*c, -*c, *c;
    return add_tied(blocks, blocks, K, C, {});
  }
  double J[36];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double s = (k ? weights_.K * (*k)(i, j) : 0) + (c ? weights_.C * (*c)(i, j) : 0);
      J[6 * i + j] = J[6 * i + 21 + j] = s;
      J[6 * i + 3 + j] = J[6 * i + 18 + j] = -s;
    }
  put(blocks, blocks, J);
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

bool Assembler::add_weighted(int a, int b, const Vec6& f, const Mat6& J) {
  if (tied(a) || tied(b)) return false;
  if (force_) {
    add_force(a, f[0], f[1], f[2]);
    add_force(b, f[3], f[4], f[5]);
  }
  if (!matrix_) return true;
  const int blocks[2] = {a, b};
  Mat6 entries = J;
  put(blocks, blocks, entries.data());
  return true;
}

void Assembler::add_masses(int a, int b, const Vec6& f, double diagonal, double shared) {
  if (force_) {
    add_force(a, f[0], f[1], f[2]);
    add_force(b, f[3], f[4], f[5]);
  }
  const int blocks[2] = {a, b};
  const bool frames = tied(a) || tied(b);
  if (!matrix_ || (weights_.M == 0 && !frames)) return;
  if (frames) {
    Mat6 M = diagonal * Mat6::Identity();
    M.topRightCorner<3, 3>() = M.bottomLeftCorner<3, 3>() = shared * Mat3::Identity();
    return add_tied(blocks, blocks, {}, {}, M);
  }
  double J[36] = {};
  for (int i = 0; i < 6; ++i) {
    J[7 * i] = weights_.M * diagonal;
    J[6 * i + (i + 3) % 6] = weights_.M * shared;
  }
  put(blocks, blocks, J);
}

}  // namespace hawser
