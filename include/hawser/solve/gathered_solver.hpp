// Direct solver for tangents whose cut would be as long as the whole, such as that of one line wound on
// itself: every rank gathers all of it and factorises it as one rank would, in the same order, so that the
// answer differs from that of one rank by the rounding of the sums in the matrix only.
#pragma once

#include <petscksp.h>

#include <vector>

#include "hawser/solve/elimination_order.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// Who is coupled with whom among all blocks of 3 of the system, numbered as on one rank (in file order). The
// same on every rank. Collective.
BlockGraph gather_graph(const System& system);

// Makes `pc` (on more than one rank, for MPIBAIJ matrices in blocks of 3 of this mesh) the gathered solver;
// order[k]: the block, numbered as on one rank, that is eliminated as k-th. Collective.
void use_gathered(PC pc, const LocalMesh& mesh, const std::vector<int>& order);

}  // namespace hawser
