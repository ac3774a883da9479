// Distribution of the nodes among the ranks.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"

namespace hawser {

// Owner of every node. Elements, joints, bodies and `coupled` (pairs of nodes with forces between them or
// between their elements) connect nodes to components. Components in file order are cut into parts of
// equal work; a rank may get up to 1.07 times the mean to avoid cutting a component, and cuts between lines
// are preferred. METIS cuts a component if it cuts fewer or lighter edges for the same work; edges along a
// chain are heavier than those of `coupled`. `uncut`: lines that are not cut. The result is the same on every
// rank.
NodeRanks partition(const Mesh& mesh, int ranks, std::span<const std::pair<int, int>> coupled = {},
                    std::span<const int> uncut = {});

struct Balance {
  double imbalance = 1;  // largest work of a rank divided by the mean
  int cut_lines = 0;     // lines with nodes of several ranks
  int cut_elements = 0;  // see cut_elements()
};
Balance balance(const Mesh& mesh, const NodeRanks& owner, int ranks);

// Elements whose nodes belong to different ranks.
int cut_elements(const Mesh& mesh, const NodeRanks& owner);

}  // namespace hawser
