// One rank's part of the mesh: owned nodes first, then ghosts of its elements, then ghosts of couplings.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/mesh/node_ranks.hpp"

namespace hawser {

struct LocalElement {
  int first = 0, second = 0;  // local nodes
  int global = 0;             // index into Mesh::elements
  bool counted = false;       // this rank counts it in sums (it owns the first node)
  int copy = 0;               // index into LocalMesh::element_copies

  // Local node towards an end of the line.
  int node_at(LineEnd end) const { return end == LineEnd::B ? second : first; }
};

// Consecutive nodes with as many 3-blocks each; the first one has the given block.
struct BlockRun {
  int first_node = 0, block = 0, width = 0;
};

struct LocalMesh {
  const Mesh* mesh = nullptr;
  // Local nodes: [0, owned) are owned, in file order, [owned, element_ghosts_end) ghosts of elements, and the
  // rest ghosts of couplings.
  int owned = 0, element_ghosts_end = 0;
  std::vector<int> global;              // local node -> node
  std::vector<int> block;               // local node -> its first local 3-block (position; +1: rotation)
  int element_ghost_blocks_end = 0;     // local blocks before it are those of nodes [0, element_ghosts_end)
  int owned_blocks = 0;                 // local blocks [0, owned_blocks) are rows of this rank
  std::vector<int> global_block;        // local block -> block of the parallel numbering
  std::vector<LocalElement> elements;   // every element that touches an owned node
  NodeRanks owner;                      // of every node of the mesh
  std::vector<BlockRun> block_runs;     // of all nodes of the mesh, in the parallel numbering
  std::vector<Node> node_copies;        // of the local nodes
  std::vector<Element> element_copies;  // of the local elements

  int nodes() const { return static_cast<int>(global.size()); }
  bool owns(int local) const { return local >= 0 && local < owned; }
  int blocks() const { return static_cast<int>(global_block.size()); }
  // Node or element of the whole mesh for a local one.
  template <class Index>
  const Node& node(Index local) const {
    return node_copies[local];
  }
  const Element& element(const LocalElement& e) const { return element_copies[e.copy]; }
  // First block of a node of the mesh in the parallel numbering.
  int first_block(int node) const;
  // Copies what is local from the mesh, which node() and element() then return.
  void copy_local();
  bool rotates(int local) const { return node(local).rotates; }
  // Local node of the frame that a local node is tied to (Node::tied_to); -1: none.
  int frame_of(int local) const {
    const int frame = node(local).tied_to;
    return frame < 0 ? -1 : find(frame);
  }
  // Local node of a mesh node; -1: not on this rank. Each of the three ranges is sorted.
  int find(int node) const {
    const auto begin = global.begin();
    const int ends[] = {0, owned, element_ghosts_end, nodes()};
    for (int r = 0; r < 3; ++r) {
      const auto last = begin + ends[r + 1];
      const auto at = std::lower_bound(begin + ends[r], last, node);
      if (at != last && *at == node) return static_cast<int>(at - begin);
    }
    return -1;
  }
  bool owns_node(int node) const { return owns(find(node)); }  // node of the mesh
};

// Lines by the ranks that own their nodes, ascending.
struct LineOwners {
  std::vector<int> cut;    // several ranks own nodes of it; the same on all ranks
  std::vector<int> uncut;  // this rank owns all nodes
  std::vector<int> local;  // this rank owns nodes
};
LineOwners line_owners(const LocalMesh& mesh);
// True if this rank owns the first node of a line.
bool owns_line(const LocalMesh& mesh, int line);

// Unstretched arc length from end A, m; xi in [0, 1] along the element.
inline double arc_at(const LocalMesh& mesh, const LocalElement& e, double xi) {
  const double a = mesh.node(e.first).arc;
  const double b = mesh.node(e.second).arc;
  return a + xi * (b - a);
}

// Data that a term keeps for an element, or null; `kept` is sorted as LocalMesh::elements, each with its
// LocalElement as `element`.
template <class Kept>
const Kept* of_element(const std::vector<Kept>& kept, const LocalElement& e) {
  const auto at = std::lower_bound(kept.begin(), kept.end(), e.global,
                                   [](const Kept& k, int global) { return k.element.global < global; });
  return at != kept.end() && at->element.global == e.global ? &*at : nullptr;
}

// Adds the residual of a beam (x1, theta1, x2, theta2) or a cable (x1, x2) to f, with a beam's layout.
inline void add_ends(const Vec12& ends, Vec12& f) { f += ends; }
inline void add_ends(const Vec6& ends, Vec12& f) {
  f.head<3>() += ends.head<3>();
  f.segment<3>(6) += ends.tail<3>();
}

// The part of a rank: owned nodes, and ghosts of the elements that it shares. owner: from partition().
LocalMesh local_mesh(const Mesh& mesh, const NodeRanks& owner, int rank, int ranks);

// Sets the coupling ghosts to those of `nodes` (mesh nodes, sorted) that are not yet local. Local nodes and
// blocks before them keep their numbers.
void set_coupling_ghosts(LocalMesh& mesh, std::span<const int> nodes);

}  // namespace hawser
