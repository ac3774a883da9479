// In which order LU eliminates the blocks of a tangent.
//
// Chains in their own order have no fill. Where lines touch (or a line itself, turn by turn on a drum) that
// order can cost tens of times what others do.
#pragma once

#include <petscmat.h>

#include <vector>

namespace hawser {

// Who is coupled with whom: row by row, both ways, without the diagonal.
struct BlockGraph {
  std::vector<int> start, next;
  int size() const { return static_cast<int>(start.size()) - 1; }
};

// Multiplications of blocks in the LU factorisation of a matrix of symmetric pattern, order[k] eliminated as
// k-th (George & Liu 1981, Computer Solution of Large Sparse Positive Definite Systems, ch. 5).
double factorisation_work(const BlockGraph& graph, const std::vector<int>& order);

// Blocks of L, with the diagonal.
double factor_blocks(const BlockGraph& graph, const std::vector<int>& order);

// The cheapest of: the order as it is, approximate minimum degree (Amestoy, Davis & Duff 1996), reverse
// Cuthill-McKee. The others are tried only where the first has fill.
std::vector<int> cheapest_order(const BlockGraph& graph);

// The name under which PETSc knows cheapest_order(), for sequential matrices of blocks (registers it once).
MatOrderingType cheapest_ordering();

}  // namespace hawser
