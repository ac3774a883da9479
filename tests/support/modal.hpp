// Small vibrations about a state: K, C and M of a system as dense matrices without the held components, and
// their frequencies. On one rank.
#pragma once

#include <petscksp.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "hawser/solve/linear_solver.hpp"
#include "hawser/system/system.hpp"

namespace hawser::test {

struct ModalMatrices {
  Eigen::MatrixXd K, C, M;
  std::vector<int> dof;  // 3 * local block + component of each row

  // Row of a component of a local block; -1 if it is held.
  int row(int block, int component) const {
    const auto it = std::find(dof.begin(), dof.end(), 3 * block + component);
    return it == dof.end() ? -1 : static_cast<int>(it - dof.begin());
  }
};

inline Eigen::MatrixXd dense_tangent(System& system, const Kinematics& state, const Weights& weights,
                                     const std::vector<int>& dof) {
  MatHandle J = system.create_matrix();
  MatHandle D;
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  system.tangent(state, weights, zero, false, J.get());
  check(MatConvert(J.get(), MATDENSE, MAT_INITIAL_MATRIX, D.out()));
  const PetscScalar* p = nullptr;
  PetscInt ld = 0;
  check(MatDenseGetLDA(D.get(), &ld));
  check(MatDenseGetArrayRead(D.get(), &p));
  const auto n = static_cast<Eigen::Index>(dof.size());
  Eigen::MatrixXd out(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i)
      out(i, j) = p[dof[static_cast<size_t>(i)] + ld * dof[static_cast<size_t>(j)]];
  check(MatDenseRestoreArrayRead(D.get(), &p));
  return out;
}

// The matrices of the motion linearised about `state`.
inline ModalMatrices modal_matrices(System& system, const Kinematics& state) {
  ModalMatrices m;
  const auto& held = system.tied_nodes().held();
  for (int b = 0; b < system.mesh().owned_blocks; ++b)
    for (int c = 0; c < 3; ++c)
      if (!(held[static_cast<size_t>(b)] >> c & 1)) m.dof.push_back(3 * b + c);
  m.K = dense_tangent(system, state, {1, 0, 0}, m.dof);
  m.C = dense_tangent(system, state, {0, 1, 0}, m.dof);
  m.M = dense_tangent(system, state, {0, 0, 1}, m.dof);
  return m;
}

// B' K B, for motions in the span of the columns of B (for example of a symmetry or a plane).
inline Eigen::MatrixXd restricted(const Eigen::MatrixXd& K, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd KB = Eigen::MatrixXd::Zero(K.rows(), B.cols());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(B.cols(), B.cols());
  for (Eigen::Index j = 0; j < B.cols(); ++j)
    for (Eigen::Index k = 0; k < B.rows(); ++k)
      if (B(k, j) != 0) KB.col(j) += B(k, j) * K.col(k);
  for (Eigen::Index i = 0; i < B.cols(); ++i)
    for (Eigen::Index k = 0; k < B.rows(); ++k)
      if (B(k, i) != 0) out.row(i) += B(k, i) * KB.row(k);
  return out;
}

// Columns of the identity for the components that keep(block, component) selects.
template <class Keep>
Eigen::MatrixXd components(const ModalMatrices& m, Keep keep) {
  std::vector<Eigen::Index> rows;
  for (size_t i = 0; i < m.dof.size(); ++i)
    if (keep(m.dof[i] / 3, m.dof[i] % 3)) rows.push_back(static_cast<Eigen::Index>(i));
  Eigen::MatrixXd B =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(m.dof.size()), static_cast<Eigen::Index>(rows.size()));
  for (size_t j = 0; j < rows.size(); ++j) B(rows[j], static_cast<Eigen::Index>(j)) = 1;
  return B;
}

inline MatHandle petsc_dense(const Eigen::MatrixXd& A) {
  const auto n = static_cast<PetscInt>(A.rows());
  const auto m = static_cast<PetscInt>(A.cols());
  MatHandle out;
  check(MatCreateSeqDense(PETSC_COMM_SELF, n, m, nullptr, out.out()));
  PetscScalar* p = nullptr;
  check(MatDenseGetArray(out.get(), &p));
  std::copy(A.data(), A.data() + A.size(), p);
  check(MatDenseRestoreArray(out.get(), &p));
  check(MatAssemblyBegin(out.get(), MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(out.get(), MAT_FINAL_ASSEMBLY));
  return out;
}

// Eigenvalues of B^-1 A, from LAPACK through PETSc.
inline std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  const MatHandle a = petsc_dense(A);
  const MatHandle b = petsc_dense(B);
  KspHandle ksp;
  check(KSPCreate(PETSC_COMM_SELF, ksp.out()));
  check(KSPSetOperators(ksp.get(), a.get(), b.get()));
  check(KSPSetType(ksp.get(), KSPGMRES));
  PC pc = nullptr;
  check(KSPGetPC(ksp.get(), &pc));
  check(PCSetType(pc, PCLU));
  check(KSPSetUp(ksp.get()));
  const size_t n = static_cast<size_t>(A.rows());
  std::vector<PetscReal> re(n);
  std::vector<PetscReal> im(n);
  check(KSPComputeEigenvaluesExplicitly(ksp.get(), static_cast<PetscInt>(n), re.data(), im.data()));
  std::vector<std::complex<double>> out;
  for (size_t i = 0; i < n; ++i) out.emplace_back(re[i], im[i]);
  return out;
}

// Angular frequencies, rad/s, ascending, of M x'' + K x = 0.
inline std::vector<double> natural_frequencies(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M) {
  std::vector<double> omega;
  for (const std::complex<double>& l : eigenvalues(K, M)) omega.push_back(std::sqrt(l).real());
  std::sort(omega.begin(), omega.end());
  return omega;
}

// Exponents s, 1/s, of the oscillating solutions exp(s t) of M x'' + C x' + K x = 0 with Im s > 0, in
// ascending order of Im s, from the companion form.
inline std::vector<std::complex<double>> oscillations(const Eigen::MatrixXd& K, const Eigen::MatrixXd& C,
                                                      const Eigen::MatrixXd& M) {
  const Eigen::Index n = K.rows();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  Eigen::MatrixXd B = Eigen::MatrixXd::Identity(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = -K;
  A.bottomRightCorner(n, n) = -C;
  B.bottomRightCorner(n, n) = M;
  std::vector<std::complex<double>> out;
  for (const std::complex<double>& s : eigenvalues(A, B))
    if (s.imag() > 1e-9 * std::abs(s)) out.push_back(s);
  std::sort(out.begin(), out.end(), [](auto a, auto b) { return a.imag() < b.imag(); });
  return out;
}

}  // namespace hawser::test
