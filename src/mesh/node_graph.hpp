// The graph that is partitioned: nodes, and uncut lines as one vertex each, with the work of each vertex and
// the cost of cutting each edge. Consecutive nodes with the same work are kept together.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/mesh/even_parts.hpp"
#include "node_runs.hpp"

namespace hawser {

// Cost of cutting an element, a joint or a tie; that of a coupling is kCouplingCost in node_graph.cpp.
constexpr int kChainCost = 100;

struct GraphEdge {
  int from, to;
  int cost;  // of a cut, relative
};

// Relative cost of a node in an implicit step: kernels, assembly and factorisation (docs/performance.md).
int work_of(bool rotates);

// The node whose rank also owns node `n`: that of its position, or of the frame that carries it, or `n`.
int carrier(const Mesh& mesh, int n);

// Edges between nodes that are not those of elements, each in both directions: joints and ties, and the pairs
// of `coupled`.
std::vector<GraphEdge> joins(const Mesh& mesh, std::span<const std::pair<int, int>> coupled);

// Edges sorted by their ends; those between the same two vertices become one.
std::vector<GraphEdge> merged(std::vector<GraphEdge> edges);

// Consecutive vertices in the sequence in which ranks get them; elements join each one to the next.
struct VertexRun {
  int first_node = 0;
  int vertices = 1;
  int work = 0;                                  // of each vertex
  int uncut = -1;                                // line that is the vertex; -1: each vertex is a node
  int component = 0;                             // its first node
  int position = 0;                              // of the first vertex in the sequence
  CutKind before = CutKind::between_components;  // cost of a cut before the first vertex
};

// The sequence: component by component, each by its first node in the file; inside a component lines in the
// order of the file, and a body beside the middle one of its lines, so that a cut on either side of it
// separates few of them from it. A line of `uncut` is one vertex; if its work exceeds the mean of the
// remaining ranks, it has a separate rank. Other nodes are a vertex each; carried nodes belong to the vertex
// or rank of their carrier.
struct GraphSequence {
  std::vector<VertexRun> vertex_runs;  // in the order of the sequence
  std::vector<GraphEdge> edges;  // between positions, those inside of runs excepted; sorted, both directions
  std::vector<std::pair<int, int>> dedicated_ranks;  // uncut lines with a separate rank, and that rank
  std::vector<std::pair<int, int>> carried;          // nodes, and their carriers, by node
};

GraphSequence graph_sequence(const Mesh& mesh, int ranks, std::span<const int> uncut,
                             const std::vector<GraphEdge>& joins);

}  // namespace hawser
