// Edges and vertices of the graph that is partitioned, and its components.
#include "node_graph.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "hawser/math/disjoint_sets.hpp"

namespace hawser {
namespace {

constexpr int kBeamWork = 5;
constexpr int kCableWork = 1;
// A cut through a chain costs more than one through a coupling: a node of a line in contact has several.
constexpr int kChainCost = 100;
constexpr int kCouplingCost = 10;

struct UncutLine {
  std::int64_t work;
  int line;
};

// Heaviest first; of equal work in the order of the file.
std::vector<UncutLine> sorted_by_work(const Mesh& mesh, std::span<const int> uncut) {
  std::vector<UncutLine> lines;
  for (const int l : uncut) {
    std::int64_t work = 0;
    const LineSpan& line = mesh.lines[l];
    for (int i = 0; i < line.nodes; ++i) work += work_of(mesh.nodes[line.first_node + i]);
    lines.push_back({work, l});
  }
  std::sort(lines.begin(), lines.end(), [](const UncutLine& a, const UncutLine& b) {
    return std::tuple(-a.work, a.line) < std::tuple(-b.work, b.line);
  });
  return lines;
}

void add_vertex(GraphVertices& v, std::int64_t work, int first_node) {
  v.work.push_back(static_cast<int>(work));
  v.first_node.push_back(first_node);
}

// Vertices and ranks of their own for the lines that are not cut.
void add_uncut_lines(const Mesh& mesh, int ranks, std::span<const int> uncut, GraphVertices& v) {
  std::int64_t left = 0;
  for (const Node& n : mesh.nodes) left += work_of(n);
  for (const auto& [work, line] : sorted_by_work(mesh, uncut)) {
    const LineSpan& l = mesh.lines[line];
    const int free_ranks = ranks - v.first_free_rank;
    if (free_ranks > 1 && work * free_ranks >= left) {
      std::fill_n(v.rank_of_node.begin() + l.first_node, l.nodes, v.first_free_rank);
      left -= work;
      ++v.first_free_rank;
    } else {
      std::fill_n(v.vertex_of_node.begin() + l.first_node, l.nodes, static_cast<int>(v.work.size()));
      add_vertex(v, work, l.first_node);
    }
  }
}

// Gives carried nodes the vertex or rank of their carriers, and moves their work with them.
void join_carriers(const Mesh& mesh, const std::vector<char>& in_uncut_line, GraphVertices& v) {
  for (int n = 0; n < std::ssize(mesh.nodes); ++n) {
    const int with = carrier(mesh, n);
    if (with == n) continue;
    const int work = work_of(mesh.nodes[n]);
    if (in_uncut_line[n]) {
      if (v.vertex_of_node[n] >= 0) v.work[v.vertex_of_node[n]] -= work;
    } else {
      v.vertex_of_node[n] = v.vertex_of_node[with];
      v.rank_of_node[n] = v.rank_of_node[with];
    }
    if (v.vertex_of_node[with] >= 0) v.work[v.vertex_of_node[with]] += work;
  }
}

}  // namespace

int work_of(const Node& n) { return n.rotates ? kBeamWork : kCableWork; }

int carrier(const Mesh& mesh, int n) {
  while (mesh.nodes[n].tied_to >= 0 || mesh.nodes[n].pinned_to >= 0)
    n = mesh.nodes[n].tied_to >= 0 ? mesh.nodes[n].tied_to : mesh.nodes[n].pinned_to;
  return n;
}

std::vector<GraphEdge> node_edges(const Mesh& mesh, std::span<const std::pair<int, int>> coupled) {
  std::vector<GraphEdge> edges;
  const auto add = [&edges](int a, int b, int cost) {
    if (a == b) return;
    edges.push_back({a, b, cost});
    edges.push_back({b, a, cost});
  };
  for (const Element& e : mesh.elements) add(e.first, e.second, kChainCost);
  for (int n = 0; n < std::ssize(mesh.nodes); ++n)
    for (const int other : {mesh.nodes[n].pinned_to, mesh.nodes[n].tied_to})
      if (other >= 0) add(n, other, kChainCost);
  for (const auto& [a, b] : coupled) add(a, b, kCouplingCost);
  return edges;
}

std::vector<GraphEdge> merged(std::vector<GraphEdge> edges) {
  const auto ends = [](const GraphEdge& e) { return std::pair(e.from, e.to); };
  std::sort(edges.begin(), edges.end(),
            [&](const GraphEdge& a, const GraphEdge& b) { return ends(a) < ends(b); });
  size_t kept = 0;
  for (const GraphEdge& e : edges)
    if (kept > 0 && ends(edges[kept - 1]) == ends(e))
      edges[kept - 1].cost += e.cost;
    else
      edges[kept++] = e;
  edges.resize(kept);
  return edges;
}

GraphVertices graph_vertices(const Mesh& mesh, int ranks, std::span<const int> uncut) {
  GraphVertices v;
  v.rank_of_node.assign(mesh.nodes.size(), -1);
  v.vertex_of_node = v.rank_of_node;
  add_uncut_lines(mesh, ranks, uncut, v);
  std::vector<char> in_uncut_line(mesh.nodes.size());
  for (int n = 0; n < std::ssize(mesh.nodes); ++n) {
    in_uncut_line[n] = v.rank_of_node[n] >= 0 || v.vertex_of_node[n] >= 0;
    if (in_uncut_line[n] || carrier(mesh, n) != n) continue;
    v.vertex_of_node[n] = static_cast<int>(v.work.size());
    add_vertex(v, work_of(mesh.nodes[n]), n);
  }
  join_carriers(mesh, in_uncut_line, v);
  return v;
}

std::vector<int> components(size_t vertices, std::span<const GraphEdge> edges) {
  DisjointSets joined(vertices);
  for (const GraphEdge& e : edges) joined.unite(e.from, e.to);
  return joined.smallest_of_all();
}

}  // namespace hawser
