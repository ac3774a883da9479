// Exact direct solver for chains cut between ranks.
//
// With Ad the rows and columns of this rank (chains: no fill), and Ao their coupling to the unknowns x_g of
// other ranks:
//   x = Ad^-1 b - Z x_g,  Z = Ad^-1 Ao  (a few columns for each cut).
// The unknowns G that are ghosts on some rank satisfy the small system (I + Z_G) x_G = (Ad^-1 b)_G. It
// separates into the parts of the interface (interface_parts.hpp), each solved by one rank for the ranks that
// share it. If no line is cut, G is empty and nothing is communicated. (Substructuring: Przemieniecki 1963,
// AIAA J. 1(1).)
#pragma once

#include <petscksp.h>

#include "hawser/solve/lu.hpp"

namespace hawser {

// Largest number of unknowns of a part of the interface for which its dense system is used.
inline constexpr int kMaxShared = 400;

// Makes `pc` the substructuring solver (on more than one rank, for MPIBAIJ matrices of a symmetric pattern).
// If a part of the interface has more than `max_unknowns` unknowns, MUMPS solves the whole matrix. pattern:
// that of a rank's own part. Collective.
void use_substructuring(PC pc, MatrixPattern pattern, int max_unknowns = kMaxShared);

}  // namespace hawser
