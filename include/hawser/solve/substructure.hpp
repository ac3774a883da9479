// Exact direct solver for chains cut between ranks.
//
// With Ad the rows and columns of this rank (chains: no fill) and Ao what couples it to other ranks' unknowns
// g,
//   x = Ad^-1 b - Z x_g,  Z = Ad^-1 Ao  (a handful of columns a cut),
// so the unknowns G that some other rank sees satisfy the small system (I + Z_G) x_G = (Ad^-1 b)_G, which
// every rank solves. Whole lines on a rank leave G empty and no communication. (Substructuring: Przemieniecki
// 1963, AIAA J. 1(1).)
#pragma once

#include <petscksp.h>

namespace hawser {

// Makes `pc` (on more than one rank, for MPIBAIJ matrices) the substructuring solver. coupled: of
// use_lu() for a rank's own part. Collective.
void use_substructuring(PC pc, bool coupled);

// Largest number of shared unknowns for which the dense small system is a good idea.
inline constexpr int kMaxShared = 400;

}  // namespace hawser
