// LU of the rows and columns that one rank has of a tangent.
#pragma once

#include <petscpc.h>

namespace hawser {

// Makes `pc`, of matrices in blocks of 3 on one rank, LU. coupled: blocks are eliminated in the order of
// minimum degree, and only those that are not zero, since pairs of nodes are in the matrix's pattern that do
// not touch. Otherwise the matrix is that of chains, which in their own order have no fill. Collective on one
// rank.
void use_lu(PC pc, bool coupled);

}  // namespace hawser
