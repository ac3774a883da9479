// Which rank owns each node of a case.
#pragma once

#include <mpi.h>

#include <utility>
#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser::run {

// Pairs of Mesh::nodes with forces between them, beside those of elements and ties: bodies that radiate on
// each other, ends of links, nodes of elements of two lines that may touch in the start shape (a line that
// may touch itself is not cut). Each rank of `comm` searches for its share of the lines. The same on all
// ranks. Collective.
std::vector<std::pair<int, int>> coupled_nodes(MPI_Comm comm, const model::Case& c, const Mesh& mesh,
                                               const Bodies& bodies);

// Lines that may touch themselves, in order. Cut in two, such a line, once it is wound on itself, would share
// about every node that lies on another turn, and the tangent would cost several times what it costs on one
// rank.
std::vector<int> uncut_lines(const model::Case& c);

// Owner of every node among so many ranks, by partition(): coupled_nodes() rather land on one rank,
// uncut_lines() are not cut. The same on all ranks of `comm`, of which there may be another number.
// Collective.
std::vector<int> node_owners(MPI_Comm comm, const model::Case& c, const Mesh& mesh, const Bodies& bodies,
                             int ranks);

}  // namespace hawser::run
