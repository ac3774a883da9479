// The graph that is partitioned: nodes, and uncut lines as one vertex each, with the work of each vertex and
// the cost of cutting each edge.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct GraphEdge {
  int from, to;
  int cost;  // of a cut, relative
};

// Relative cost of a node in an implicit step: kernels, assembly and factorisation (docs/performance.md).
int work_of(const Node& n);

// The node whose rank also owns node `n`: that of its position, or of the frame that carries it, or `n`.
int carrier(const Mesh& mesh, int n);

// Edges between nodes, each in both directions: elements, joints and ties, and the pairs of `coupled`.
std::vector<GraphEdge> node_edges(const Mesh& mesh, std::span<const std::pair<int, int>> coupled);

// Edges sorted by their ends; those between the same two vertices become one.
std::vector<GraphEdge> merged(std::vector<GraphEdge> edges);

// Each node either has a rank from the start or belongs to a vertex.
struct GraphVertices {
  std::vector<int> rank_of_node;    // -1: the node belongs to a vertex
  std::vector<int> vertex_of_node;  // -1: the node has a rank
  std::vector<int> work;            // of each vertex
  std::vector<int> first_node;      // of each vertex
  int first_free_rank = 0;          // the ranks before it have one uncut line each
};

// A line of `uncut` is one vertex; if its work exceeds a rank's fair share of what is left, it gets a rank of
// its own. Other nodes are a vertex each; carried nodes belong to the vertex or rank of their carrier.
GraphVertices graph_vertices(const Mesh& mesh, int ranks, std::span<const int> uncut);

// Component of each vertex, as the number of one of its vertices.
std::vector<int> components(size_t vertices, std::span<const GraphEdge> edges);

}  // namespace hawser
