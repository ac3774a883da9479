// Consecutive nodes with as many unknowns each.
#pragma once

#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

// Nodes that follow from the elements beside them, or one with properties of its own.
struct NodeRun {
  int first = 0, nodes = 0;
  int line = 0;
  bool rotates = false;
  const Node* special = nullptr;
};

// All nodes of the mesh, in order; no run goes beyond its line. O(parts and nodes with properties of their
// own).
std::vector<NodeRun> node_runs(const Mesh& mesh);

}  // namespace hawser
