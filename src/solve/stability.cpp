// Stability of an equilibrium: number of negative eigenvalues of its tangent by a factorisation; those of
// bodies without the assumption that the tangent is symmetric.
#include "hawser/solve/stability.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <optional>

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

// Rows of the unknowns of all bodies in the global vectors, the same on all ranks.
std::vector<int> rows_of_bodies(const System& system) {
  const LocalMesh& mesh = system.mesh();
  std::vector<int> own;
  for (int n = 0; n < mesh.owned; ++n) {
    if (mesh.node(n).body < 0) continue;
    for (int k = 0; k < 6; ++k) own.push_back(3 * mesh.global_block[mesh.block[n] + k / 3] + k % 3);
  }
  return gather_all(system.comm(), own);
}

// Access to these rows of distributed vectors and matrices. Each function is collective.
class BodyRows {
 public:
  BodyRows(const System& system, std::vector<int> rows)
      : rows_(std::move(rows)), unit_(system.create_vector()), product_(system.create_vector()) {
    check(VecGetOwnershipRange(unit_.get(), &first_, &end_));
  }
  Eigen::Index count() const { return std::ssize(rows_); }

  // Sets v to the unit vector of the k-th of these rows.
  void set_unit(Vec v, Eigen::Index k) const {
    check(VecSet(v, 0));
    if (owns(k)) check(VecSetValue(v, rows_[k], 1, INSERT_VALUES));
    check(VecAssemblyBegin(v));
    check(VecAssemblyEnd(v));
  }
  void clear(Vec v) const {
    for (Eigen::Index k = 0; k < count(); ++k)
      if (owns(k)) check(VecSetValue(v, rows_[k], 0, INSERT_VALUES));
    check(VecAssemblyBegin(v));
    check(VecAssemblyEnd(v));
  }
  // These rows of A v, on all ranks.
  Eigen::VectorXd product(Mat A, Vec v) const {
    check(MatMult(A, v, product_.get()));
    std::vector<double> x(rows_.size(), 0);
    for (Eigen::Index k = 0; k < count(); ++k)
      if (owns(k)) check(VecGetValues(product_.get(), 1, &rows_[k], &x[k]));
    all_reduce(PetscObjectComm(reinterpret_cast<PetscObject>(A)), MPI_SUM, x);
    return Eigen::Map<Eigen::VectorXd>(x.data(), count());
  }
  // These rows and columns of A.
  Eigen::MatrixXd block(Mat A) const {
    Eigen::MatrixXd out(count(), count());
    for (Eigen::Index k = 0; k < count(); ++k) {
      set_unit(unit_.get(), k);
      out.col(k) = product(A, unit_.get());
    }
    return out;
  }
  // Sets these rows and columns of A to those of the unit matrix.
  void hold(Mat A) const {
    std::vector<int> own;
    for (Eigen::Index k = 0; k < count(); ++k)
      if (owns(k)) own.push_back(rows_[k]);
    check(MatZeroRowsColumns(A, static_cast<PetscInt>(own.size()), own.data(), 1, nullptr, nullptr));
  }

 private:
  bool owns(Eigen::Index k) const { return rows_[k] >= first_ && rows_[k] < end_; }
  std::vector<int> rows_;
  VecHandle unit_, product_;
  PetscInt first_ = 0, end_ = 0;
};

// Stiffness of the bodies' unknowns b while everything else, l, remains in equilibrium:
//   J_ll x = -J_lb e, K e = J_bb e + J_bl x.
// held: J with the bodies held. nullopt on all ranks: it is singular.
std::optional<Eigen::MatrixXd> condensed(const BodyRows& bodies, const System& system, Mat J, Mat held) {
  KspHandle solver;
  check(KSPCreate(system.comm(), solver.out()));
  configure_linear_solver(solver.get(), system, "statics_");
  check(KSPSetOperators(solver.get(), held, held));
  const VecHandle total = system.create_vector(), push = system.create_vector(),
                  answer = system.create_vector();
  Eigen::MatrixXd K(bodies.count(), bodies.count());
  for (Eigen::Index k = 0; k < bodies.count(); ++k) {
    bodies.set_unit(total.get(), k);
    check(MatMult(J, total.get(), push.get()));
    bodies.clear(push.get());
    check(KSPSolve(solver.get(), push.get(), answer.get()));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    check(KSPGetConvergedReason(solver.get(), &reason));
    if (reason < 0) return std::nullopt;
    check(VecAXPY(total.get(), -1, answer.get()));
    K.col(k) = bodies.product(J, total.get());
  }
  return K;
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
  const BodyRows bodies(system, rows_of_bodies(system));
  if (bodies.count() == 0 || bodies.count() > kMostUnknowns) return negative;
  MatHandle held;
  check(MatDuplicate(J, MAT_COPY_VALUES, held.out()));
  bodies.hold(held.get());
  if (negative_eigenvalues(held.get()) != 0) return negative;
  const MatHandle mass = system.create_matrix();
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  system.tangent(state, {0, 0, 1}, zero, false, mass.get());
  const Eigen::LLT<Eigen::MatrixXd> M(bodies.block(mass.get()));
  const std::optional<Eigen::MatrixXd> K = condensed(bodies, system, J, held.get());
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
