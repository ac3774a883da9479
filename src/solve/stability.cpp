// Whether an equilibrium is stable: the negative eigenvalues of its tangent, counted by a factorisation.
#include "hawser/solve/stability.hpp"

#include <Eigen/Cholesky>

#include "hawser/base/gather.hpp"
#include "hawser/math/types.hpp"
#include "hawser/system/own_blocks.hpp"

namespace hawser {

namespace {

// In the format of J.
MatHandle symmetric_blocks(Mat J) {
  MatHandle t;
  check(MatTranspose(J, MAT_INITIAL_MATRIX, t.out()));
  check(MatAXPY(t.get(), 1, J, UNKNOWN_NONZERO_PATTERN));  // where it is the same it takes no room
  check(MatScale(t.get(), 0.5));
  return t;
}

// Whether a symmetric matrix on one rank is positive definite, by Cholesky's factorisation, which overwrites
// it. Chains have no fill in their own order. Of a matrix that has fill the answer is false as well.
bool positive_definite(Mat a) {
  const OwnBlocks own(a);
  const auto block = [](double* of) { return Eigen::Map<Mat3>(of); };
  for (int i = 0; i < own.rows(); ++i) {
    const Eigen::LLT<Mat3> pivot(block(own.at(i, i)));
    if (pivot.info() != Eigen::Success) return false;
    const auto columns = own.columns_from(i, i + 1);
    for (size_t j = 0; j < columns.size(); ++j) {
      const Mat3 x = pivot.solve(block(own.at(i, columns[j])));
      for (const int k : columns.subspan(j)) {
        double* to = own.at(columns[j], k);
        if (!to) return false;
        block(to) -= x.transpose() * block(own.at(i, k));
      }
    }
  }
  return true;
}

}  // namespace

MatHandle symmetric_part(Mat J) {
  MatHandle a;
  check(MatConvert(symmetric_blocks(J).get(), MATAIJ, MAT_INITIAL_MATRIX, a.out()));
  check(MatSetOption(a.get(), MAT_SYMMETRIC, PETSC_TRUE));
  return a;
}

int negative_eigenvalues(Mat J, bool chains) {
  const int size = ranks_of(PetscObjectComm(reinterpret_cast<PetscObject>(J)));
  if (chains && size == 1 && positive_definite(symmetric_blocks(J).get())) return 0;
  const MatHandle a = symmetric_part(J);
  MatHandle factor;
  if (MatGetFactor(a.get(), MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor.out())) return -1;
  check(MatMumpsSetIcntl(factor.get(), 24, 1));  // what PETSc asks for before it tells the inertia
  check(MatMumpsSetIcntl(factor.get(), 13, 1));
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info));
  if (MatCholeskyFactorSymbolic(factor.get(), a.get(), nullptr, &info)) return -1;
  if (MatCholeskyFactorNumeric(factor.get(), a.get(), &info)) return -1;
  PetscInt negative = 0, zero = 0, positive = 0;
  if (MatGetInertia(factor.get(), &negative, &zero, &positive)) return -1;
  return static_cast<int>(negative);
}

}  // namespace hawser
