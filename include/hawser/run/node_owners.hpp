// Distribution of the nodes of a case over the ranks.
#pragma once

#include <mpi.h>

#include <utility>
#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser::run {

// Pairs of Mesh::nodes coupled by forces other than those of elements and ties: bodies that interact by
// radiation, ends of links, nodes of elements of two lines that may touch in the start shape (lines with
// self-contact are not cut). Each rank of `comm` searches its share of the lines. The same on all ranks.
// Collective.
std::vector<std::pair<int, int>> coupled_nodes(MPI_Comm comm, const model::Case& c, const Mesh& mesh,
                                               const Bodies& bodies);

// Lines with possible self-contact, in order. If such a line were cut, it would share most nodes once wound
// on itself, and the tangent would cost several times that on one rank.
std::vector<int> uncut_lines(const model::Case& c);

// Owner of every node among `ranks` ranks, by partition(): coupled_nodes() are preferably on one rank,
// uncut_lines() are not cut. The same on all ranks of `comm`, whose number may differ. Collective.
NodeRanks node_owners(MPI_Comm comm, const model::Case& c, const Mesh& mesh, const Bodies& bodies, int ranks);

}  // namespace hawser::run
