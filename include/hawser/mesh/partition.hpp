// Which rank owns which node.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"

namespace hawser {

// Owner of every node. What elements, joints, bodies and `coupled` (pairs of nodes with forces between them
// or between their elements) join is a component. Components in the order of the file are cut into stretches
// of equal work of their nodes; up to 1.07 times the mean of a rank rather than a component is cut, and then
// rather between its lines. METIS cuts a component where that cuts fewer or lighter edges for the same work;
// edges along a chain are heavier than those of `coupled`. `whole`: lines that are not cut. Same answer on
// every rank.
std::vector<int> partition(const Mesh& mesh, int ranks, std::span<const std::pair<int, int>> coupled = {},
                           std::span<const int> whole = {});

// This rank's part. `owner` has one rank a node.
LocalMesh local_mesh(const Mesh& mesh, const std::vector<int>& owner, int rank, int ranks);

struct Balance {
  double imbalance = 1;  // work of the rank with most over the mean
  int cut_lines = 0;     // lines with nodes of several ranks
  int cut_elements = 0;  // as cut_elements()
};
Balance balance(const Mesh& mesh, const std::vector<int>& owner, int ranks);

// Elements whose nodes belong to different ranks.
int cut_elements(const Mesh& mesh, const std::vector<int>& owner);

}  // namespace hawser
