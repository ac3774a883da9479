// Eigenvalues of small symmetric matrices.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Matrix of up to 12 rows without heap allocation.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 12, 12>;

struct Eigenpairs {
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 12, 1> values;  // ascending
  SmallMatrix vectors;                                        // columns of unit length
};

// Eigenpairs of a symmetric matrix, from its lower triangle. Not inline, because an Eigen decomposition takes
// longer to compile than all the rest of a file.
Eigenpairs eigenpairs(const SmallMatrix& A);

}  // namespace hawser
