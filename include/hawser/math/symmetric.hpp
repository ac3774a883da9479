// Eigenvalues of small symmetric matrices.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Of up to 12 rows, without memory of the heap.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 12, 12>;

struct Eigenpairs {
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 12, 1> values;  // ascending
  SmallMatrix vectors;                                        // of length 1, in columns
};

// Of a symmetric matrix, of which the lower triangle is read. Not inline: a decomposition of Eigen's takes
// longer to compile than all the rest of the file that asks for it.
Eigenpairs eigenpairs(const SmallMatrix& A);

}  // namespace hawser
