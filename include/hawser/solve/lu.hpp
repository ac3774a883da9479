// LU of the rows and columns of a tangent that belong to one rank.
#pragma once

#include <petscpc.h>

namespace hawser {

// Pattern of a tangent. chains: it contains only pairs of nodes that are adjacent along a line, which causes
// no fill in their own order; coupled: other pairs too.
enum class MatrixPattern { chains, coupled };

// Makes `pc` an LU for matrices in blocks of 3 on one rank. Of a coupled matrix only nonzero blocks are
// eliminated, in the order of minimum degree. Collective on one rank.
void use_lu(PC pc, MatrixPattern pattern);

}  // namespace hawser
