// Which rank owns which node.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"

namespace hawser {

// Owner of every node: METIS recursive bisection of the graph of elements, vertices weighed by the work of a
// node, edges along a chain heavy so that lines are cut as seldom as balance allows. `coupled`: pairs of
// nodes with forces between them or between their elements, lighter edges, so that both land on one rank
// where that is cheap. `whole`: lines that are not cut. Same answer on every rank.
std::vector<int> partition(const Mesh& mesh, int ranks, std::span<const std::pair<int, int>> coupled = {},
                           std::span<const int> whole = {});

// This rank's part. `owner` has one rank a node.
LocalMesh local_mesh(const Mesh& mesh, const std::vector<int>& owner, int rank, int ranks);

// Elements whose nodes belong to different ranks.
int cut_elements(const Mesh& mesh, const std::vector<int>& owner);

}  // namespace hawser
