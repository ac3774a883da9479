// Stability of an equilibrium: number of negative eigenvalues of its tangent by a factorisation; those of
// bodies without the assumption that the tangent is symmetric.
#include "hawser/solve/stability.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <complex>
#include <optional>

#include "condensation.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/types.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/system/local_blocks.hpp"

namespace hawser {

namespace {

auto as_block(double* values) { return Eigen::Map<Mat3>(values); }

// The blocks in this rank's rows and in columns of other ranks; null on one rank. columns: global numbers of
// the block columns.
struct OtherColumns {
  explicit OtherColumns(Mat J) {
    PetscBool shared = PETSC_FALSE;
    check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(J), MATMPIBAIJ, &shared));
    if (shared) check(MatMPIBAIJGetSeqBAIJ(J, nullptr, &blocks, &columns));
  }
  Mat blocks = nullptr;
  const PetscInt* columns = nullptr;
};

// True if the part of a symmetric matrix in a rank's own rows and columns is positive definite, by Cholesky's
// factorisation, which overwrites it. Chains have no fill in their own order. If there is fill, the result is
// false as well.
bool positive_definite(Mat a) {
  const LocalBlocks blocks(a);
  for (int i = 0; i < blocks.rows(); ++i) {
    const Eigen::LLT<Mat3> pivot(as_block(blocks.at(i, i)));
    if (pivot.info() != Eigen::Success) return false;
    const auto columns = blocks.columns_from(i, i + 1);
    for (size_t j = 0; j < columns.size(); ++j) {
      const Mat3 x = pivot.solve(as_block(blocks.at(i, columns[j])));
      for (const int k : columns.subspan(j)) {
        double* to = blocks.at(columns[j], k);
        if (!to) return false;
        as_block(to) -= x.transpose() * as_block(blocks.at(i, k));
      }
    }
  }
  return true;
}

// True if the symmetric part of a tangent is positive definite; false also if a chain is cut between ranks.
// Collective.
bool positive_definite_chains(Mat J) {
  const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(J));
  PetscInt others = 0;
  if (const OtherColumns other(J); other.blocks) check(MatGetSize(other.blocks, nullptr, &others));
  if (on_any_rank(comm, others > 0)) return false;
  return !on_any_rank(comm, !positive_definite(symmetric_blocks(J).get()));
}

// Largest imaginary part over the real one, and largest relative difference, of equal real eigenvalues.
constexpr double kReal = 1e-3;

// The eigenvector of a real eigenvalue. If others are equal to it, their eigenvectors depend on rounding, but
// the space of all does not: of the projections of unit vectors onto it the result is the longest, the first
// if several are equally long. This determines its sign as well.
Eigen::VectorXd eigenvector(const Eigen::EigenSolver<Eigen::MatrixXd>& modes, double eigenvalue) {
  const Eigen::Index n = modes.eigenvalues().size();
  const Eigen::MatrixXcd all = modes.eigenvectors();
  Eigen::MatrixXd equal = Eigen::MatrixXd::Zero(n, 2 * n);
  for (Eigen::Index k = 0; k < n; ++k)
    if (std::abs(modes.eigenvalues()[k] - eigenvalue) <= kReal * std::abs(eigenvalue)) {
      equal.col(k) = all.col(k).real();
      equal.col(n + k) = all.col(k).imag();
    }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(equal);
  qr.setThreshold(kReal);
  const Eigen::MatrixXd basis = qr.householderQ() * Eigen::MatrixXd::Identity(n, qr.rank());
  const Eigen::VectorXd lengths = basis.rowwise().norm();
  Eigen::Index longest = 0;
  while (lengths[longest] < (1 - kReal) * lengths.maxCoeff()) ++longest;
  return basis * basis.row(longest).transpose();
}

}  // namespace

MatHandle symmetric_blocks(Mat J) {
  MatHandle s;
  check(MatDuplicate(J, MAT_COPY_VALUES, s.out()));
  check(MatScale(s.get(), 0.5));
  {
    const LocalBlocks blocks(s.get());
    for (int row = 0; row < blocks.rows(); ++row)
      for (const int column : blocks.columns_from(row, row)) {
        auto above = as_block(blocks.at(row, column));
        auto below = as_block(blocks.at(column, row));
        const Mat3 sum = above + below.transpose();
        above = sum;
        below = sum.transpose();
      }
  }
  // The transposed half of each block in a column of another rank belongs to a row of that rank.
  check(MatSetOption(s.get(), MAT_NO_OFF_PROC_ENTRIES, PETSC_FALSE));
  if (const OtherColumns others(s.get()); others.blocks) {
    PetscInt first = 0;
    check(MatGetOwnershipRange(s.get(), &first, nullptr));
    const LocalBlocks other(others.blocks);
    for (PetscInt row = 0; row < other.rows(); ++row)
      for (const PetscInt column : other.columns_from(row, 0)) {
        const PetscInt to = others.columns[column];
        const PetscInt from = first / 3 + row;
        // PETSc stores a block by columns, and this call reads it by rows, which transposes it.
        check(MatSetValuesBlocked(s.get(), 1, &to, 1, &from, other.at(row, column), ADD_VALUES));
      }
  }
  check(MatAssemblyBegin(s.get(), MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(s.get(), MAT_FINAL_ASSEMBLY));
  return s;
}

MatHandle symmetric_part(Mat J) {
  MatHandle a;
  check(MatConvert(symmetric_blocks(J).get(), MATAIJ, MAT_INITIAL_MATRIX, a.out()));
  check(MatSetOption(a.get(), MAT_SYMMETRIC, PETSC_TRUE));
  return a;
}

int negative_pivots(Mat a) {
  MatHandle factor;
  if (MatGetFactor(a, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor.out())) return -1;
  check(MatMumpsSetIcntl(factor.get(), 24, 1));  // PETSc requires this before it returns the inertia
  check(MatMumpsSetIcntl(factor.get(), 13, 1));
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info));
  if (MatCholeskyFactorSymbolic(factor.get(), a, nullptr, &info)) return -1;
  if (MatCholeskyFactorNumeric(factor.get(), a, &info)) return -1;
  PetscInt negative = 0, zero = 0, positive = 0;
  if (MatGetInertia(factor.get(), &negative, &zero, &positive)) return -1;
  return static_cast<int>(negative);
}

int negative_eigenvalues(Mat J, MatrixPattern pattern) {
  if (pattern == MatrixPattern::chains && positive_definite_chains(J)) return 0;
  return negative_pivots(symmetric_part(J).get());
}

Stability stability(System& system, const Kinematics& state, Mat J) {
  constexpr double kRounding = 1e-11;  // of the largest eigenvalue
  Stability out;
  out.negative = negative_eigenvalues(J, pattern_of(system));
  if (out.negative <= 0) return out;
  const BodyRows bodies = rows_of_bodies(system);
  if (bodies.count() == 0 || bodies.count() > kMostDense) return out;
  MatHandle held;
  check(MatDuplicate(J, MAT_COPY_VALUES, held.out()));
  bodies.hold(held.get());
  if (negative_eigenvalues(held.get()) != 0) return out;
  out.by_bodies = true;
  const MatHandle mass = system.create_matrix();
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  system.tangent(state, {0, 0, 1}, zero, false, mass.get());
  const Eigen::LLT<Eigen::MatrixXd> M(bodies.block(system, mass.get()));
  KspHandle solver_of_held;
  check(KSPCreate(system.comm(), solver_of_held.out()));
  configure_linear_solver(solver_of_held.get(), system, "statics_");
  check(KSPSetOperators(solver_of_held.get(), held.get(), held.get()));
  const std::optional<Eigen::MatrixXd> K = condensed(bodies, system, J, solver_of_held.get());
  if (M.info() != Eigen::Success || !K || !K->allFinite()) return out;
  // L^-1 K L^-T with M = L L^T, whose eigenvectors are y = L^T x
  const Eigen::MatrixXd half = M.matrixL().solve(*K);
  const Eigen::EigenSolver<Eigen::MatrixXd> modes(M.matrixL().solve(half.transpose()).transpose());
  if (modes.info() != Eigen::Success) return out;
  // Damping decides about complex eigenvalues.
  const Eigen::ArrayXcd squared = modes.eigenvalues().array();
  const Eigen::Array<bool, Eigen::Dynamic, 1> real = squared.imag().abs() <= kReal * squared.real().abs();
  // Only eigenvalues that are positive beyond rounding show that the symmetric part is misleading.
  const double rounding = kRounding * squared.abs().maxCoeff();
  if ((real && squared.real() > rounding).all()) {
    out.negative = 0;
    return out;
  }
  const double least = real.select(squared.real(), 0).minCoeff();
  if (least >= -rounding) return out;
  out.negative = static_cast<int>((real && squared.real() < -rounding).count());
  const Eigen::VectorXd x = M.matrixU().solve(eigenvector(modes, least));
  out.motion = system.create_vector();
  move_in_equilibrium(bodies, system, J, solver_of_held.get(), x, out.motion.get());
  return out;
}

}  // namespace hawser
