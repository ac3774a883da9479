// Stability of an equilibrium: number of negative eigenvalues of its tangent by a factorisation; those of
// bodies without the assumption that the tangent is symmetric.
#include "hawser/solve/stability.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
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

// Rows of the unknowns of all bodies.
BodyRows rows_of_bodies(const System& system) {
  std::vector<int> nodes;
  for (int n = 0; n < system.mesh().owned; ++n)
    if (system.mesh().node(n).body >= 0) nodes.push_back(n);
  return {system, nodes};
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
        auto above = as_block(blocks.at(row, column)), below = as_block(blocks.at(column, row));
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
        const PetscInt to = others.columns[column], from = first / 3 + row;
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

int negative_eigenvalues(Mat J, bool chains) {
  if (chains && positive_definite_chains(J)) return 0;
  return negative_pivots(symmetric_part(J).get());
}

int unstable_directions(System& system, const Kinematics& state, Mat J) {
  // Most unknowns of bodies for which the dense eigenvalues, of cubic cost, take no longer than statics.
  constexpr Eigen::Index kMostUnknowns = 300;
  constexpr double kRounding = 1e-11;  // of the largest eigenvalue
  constexpr double kReal = 1e-3;       // largest imaginary part over the real one of two equal eigenvalues
  const int negative = negative_eigenvalues(J, !system.coupled());
  if (negative <= 0) return negative;
  const BodyRows bodies = rows_of_bodies(system);
  if (bodies.count() == 0 || bodies.count() > kMostUnknowns) return negative;
  MatHandle held;
  check(MatDuplicate(J, MAT_COPY_VALUES, held.out()));
  bodies.hold(held.get());
  if (negative_eigenvalues(held.get()) != 0) return negative;
  const MatHandle mass = system.create_matrix();
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  system.tangent(state, {0, 0, 1}, zero, false, mass.get());
  const Eigen::LLT<Eigen::MatrixXd> M(bodies.block(system, mass.get()));
  KspHandle solver_of_held;
  check(KSPCreate(system.comm(), solver_of_held.out()));
  configure_linear_solver(solver_of_held.get(), system, "statics_");
  check(KSPSetOperators(solver_of_held.get(), held.get(), held.get()));
  const std::optional<Eigen::MatrixXd> K = condensed(bodies, system, J, solver_of_held.get());
  if (M.info() != Eigen::Success || !K || !K->allFinite()) return negative;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(M.solve(*K), false);
  if (solver.info() != Eigen::Success) return negative;
  const Eigen::ArrayXcd squared = solver.eigenvalues().array();
  // Only eigenvalues that are positive beyond rounding show that the symmetric part is misleading. Damping
  // decides about complex ones.
  const double rounding = kRounding * squared.abs().maxCoeff();
  const bool stable = (squared.real() > rounding && squared.imag().abs() <= kReal * squared.real()).all();
  return stable ? 0 : negative;
}

}  // namespace hawser
