// One rank's part of the mesh: owned nodes first, then the ghosts its elements touch.
#pragma once

#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct LocalElement {
  int first = 0, second = 0;  // local nodes
  int global = 0;             // index into Mesh::elements
  bool counted = false;       // this rank counts it in sums (it owns the first node)
};

struct LocalMesh {
  const Mesh* mesh = nullptr;
  int owned = 0;                       // owned nodes; local nodes [0, owned) in file order
  std::vector<int> global;             // local node -> node
  std::vector<int> block;              // local node -> its first local 3-block (position; +1: rotation)
  int owned_blocks = 0;                // local blocks [0, owned_blocks) are rows of this rank
  std::vector<int> global_block;       // local block -> block of the parallel numbering
  std::vector<LocalElement> elements;  // every element that touches an owned node

  int nodes() const { return static_cast<int>(global.size()); }
  int blocks() const { return static_cast<int>(global_block.size()); }
  bool rotates(int local) const {
    return mesh->nodes[static_cast<size_t>(global[static_cast<size_t>(local)])].rotates;
  }
};

}  // namespace hawser
