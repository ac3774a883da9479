// LU of the rows and columns of a tangent that belong to one rank.
#pragma once

#include <petscpc.h>

namespace hawser {

// Makes `pc` an LU for matrices in blocks of 3 on one rank. coupled: the matrix's pattern contains pairs of
// nodes that are not adjacent, so only nonzero blocks are eliminated, in the order of minimum degree.
// Otherwise the matrix is that of chains, which have no fill in their own order. Collective on one rank.
void use_lu(PC pc, bool coupled);

}  // namespace hawser
