// Eigenvalues and eigenvectors of small symmetric matrices.
#include "hawser/math/symmetric.hpp"

#include <Eigen/Eigenvalues>

namespace hawser {

Eigenpairs eigenpairs(const SmallMatrix& A) {
  const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace hawser
