// Cuts the graph of nodes and couplings into one part for each rank: runs of the file, or METIS inside a
// component where that cuts less.
#include "hawser/mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "hawser/mesh/even_parts.hpp"
#include "node_graph.hpp"

namespace hawser {
namespace {

constexpr double kMostLoad = 1.07;  // of a rank, over its share, rather than cut more

// Part of each vertex by METIS, with work in the ratio of `shares`. `edges`: sorted, in both directions.
std::vector<int> metis_parts(std::span<const double> work, const std::vector<GraphEdge>& edges,
                             const std::vector<double>& shares) {
  std::vector<idx_t> first_edge(work.size() + 1, 0);
  std::vector<idx_t> neighbours;
  std::vector<idx_t> costs;
  std::vector<idx_t> part(work.size(), 0);
  std::vector<idx_t> weights(work.begin(), work.end());
  for (const GraphEdge& e : edges) {
    ++first_edge[e.from + 1];
    neighbours.push_back(e.to);
    costs.push_back(e.cost);
  }
  std::partial_sum(first_edge.begin(), first_edge.end(), first_edge.begin());
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::vector<real_t> targets;
  for (const double s : shares) targets.push_back(static_cast<real_t>(s / sum));
  auto vertices = static_cast<idx_t>(work.size());
  auto parts = static_cast<idx_t>(shares.size());
  idx_t constraints = 1;
  idx_t cut = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // every rank computes the same cut
  const int status = METIS_PartGraphRecursive(&vertices, &constraints, first_edge.data(), neighbours.data(),
                                              weights.data(), nullptr, costs.data(), &parts, targets.data(),
                                              nullptr, options, &cut, part.data());
  if (status != METIS_OK)
    throw std::runtime_error("METIS_PartGraphRecursive returns " + std::to_string(status));
  return {part.begin(), part.end()};
}

// Vertices in the order in which ranks get them: component by component, each by its first node in the file;
// inside a component lines in the order of the file, and a body beside the middle one of its lines, so that a
// cut on either side of it separates few of them from it.
struct VertexSequence {
  std::vector<int> vertices;
  std::vector<int> component;
  std::vector<double> work;
  std::vector<CutKind> cut_before;
  std::vector<GraphEdge> edges;  // between positions in the sequence, sorted
};

// For each body: the middle one of the nodes of lines that edges join it to, or its own.
std::vector<int> line_nodes_of_bodies(const Mesh& mesh, const std::vector<GraphEdge>& edges) {
  const int first = mesh.line_nodes();
  std::vector<std::vector<int>> joined(mesh.nodes.size() - static_cast<size_t>(first));
  for (const GraphEdge& e : edges)
    if (e.from >= first && e.to < first) joined[e.from - first].push_back(e.to);
  std::vector<int> out;
  for (std::vector<int>& nodes : joined) {
    std::sort(nodes.begin(), nodes.end());
    out.push_back(nodes.empty() ? first + static_cast<int>(out.size()) : nodes[(nodes.size() - 1) / 2]);
  }
  return out;
}

// True if `n` is the first node of a line that is not carried by another node.
bool begins_line(const Mesh& mesh, int n) {
  if (n >= mesh.line_nodes()) return false;
  const int first = mesh.lines[mesh.nodes[n].line].first_node;
  return n == first || (n == first + 1 && carrier(mesh, first) != first);
}

struct VertexKey {
  int component;  // its first node
  int node;
  bool body;
  int vertex;
};

// Keys of the vertices, in the order of the sequence.
std::vector<VertexKey> sorted_keys(const Mesh& mesh, const GraphVertices& v,
                                   const std::vector<int>& component,
                                   const std::vector<GraphEdge>& node_edges) {
  const std::vector<int> beside = line_nodes_of_bodies(mesh, node_edges);
  std::vector<int> first_node(v.work.size(), static_cast<int>(mesh.nodes.size()));  // of each component
  for (size_t i = 0; i < component.size(); ++i)
    first_node[component[i]] = std::min(first_node[component[i]], v.first_node[i]);
  std::vector<VertexKey> keys;
  for (int i = 0; i < std::ssize(component); ++i) {
    const int n = v.first_node[i];
    const bool body = n >= mesh.line_nodes();
    keys.push_back({first_node[component[i]], body ? beside[n - mesh.line_nodes()] : n, body, i});
  }
  std::sort(keys.begin(), keys.end(), [](const VertexKey& a, const VertexKey& b) {
    return std::tie(a.component, a.node, a.body, a.vertex) < std::tie(b.component, b.node, b.body, b.vertex);
  });
  return keys;
}

VertexSequence sequence_of(const Mesh& mesh, const GraphVertices& v,
                           const std::vector<GraphEdge>& node_edges) {
  std::vector<GraphEdge> edges;
  for (const GraphEdge& e : node_edges) {
    const int a = v.vertex_of_node[e.from];
    const int b = v.vertex_of_node[e.to];
    if (a >= 0 && b >= 0 && a != b) edges.push_back({a, b, e.cost});
  }
  const std::vector<int> component = components(v.work.size(), edges);
  VertexSequence out;
  std::vector<int> position(v.work.size());
  for (const VertexKey& key : sorted_keys(mesh, v, component, node_edges)) {
    const bool begins_component = out.component.empty() || out.component.back() != key.component;
    position[key.vertex] = static_cast<int>(out.vertices.size());
    out.vertices.push_back(key.vertex);
    out.component.push_back(key.component);
    out.work.push_back(v.work[key.vertex]);
    out.cut_before.push_back(begins_component                              ? CutKind::nothing
                             : begins_line(mesh, v.first_node[key.vertex]) ? CutKind::little
                                                                           : CutKind::much);
  }
  for (GraphEdge& e : edges) e = {position[e.from], position[e.to], e.cost};
  out.edges = merged(std::move(edges));
  return out;
}

long cost_of_cut(std::span<const GraphEdge> edges, const auto& part) {
  long cut = 0;
  for (const GraphEdge& e : edges)
    if (part(e.from) != part(e.to)) cut += e.cost;
  return cut;
}

// Cuts one component, the positions [begin, end) of the sequence, again by METIS into parts of the same
// weights. The new cut replaces that of the sequence if its edges cost less and no part gets more work than
// `most`.
void cut_component_again(const VertexSequence& sequence, int begin, int end, double most,
                         std::vector<double>& load, std::vector<int>& part) {
  const int first = part[begin];
  const int parts = part[end - 1] - first + 1;
  if (parts < 2 || end - begin <= parts) return;
  const auto begins_before = [](const GraphEdge& e, int position) { return e.from < position; };
  const auto from = std::lower_bound(sequence.edges.begin(), sequence.edges.end(), begin, begins_before);
  const auto to = std::lower_bound(from, sequence.edges.end(), end, begins_before);
  std::vector<GraphEdge> inside;
  for (auto e = from; e != to; ++e) inside.push_back({e->from - begin, e->to - begin, e->cost});
  const std::span work(sequence.work.data() + begin, static_cast<size_t>(end - begin));
  std::vector<double> share(static_cast<size_t>(parts), 0);
  for (int i = begin; i < end; ++i) share[part[i] - first] += sequence.work[i];
  if (*std::min_element(share.begin(), share.end()) <= 0) return;
  const std::vector<int> other = metis_parts(work, inside, share);
  if (cost_of_cut(inside, [&](int i) { return other[i]; }) >=
      cost_of_cut(inside, [&](int i) { return part[begin + i]; }))
    return;
  std::vector<double> with(load.begin() + first, load.begin() + first + parts);
  for (int p = 0; p < parts; ++p) with[p] -= share[p];
  for (int i = begin; i < end; ++i) with[other[i - begin]] += sequence.work[i];
  if (*std::max_element(with.begin(), with.end()) > most) return;
  std::copy(with.begin(), with.end(), load.begin() + first);
  for (int i = begin; i < end; ++i) part[i] = first + other[i - begin];
}

// Part of each position in the sequence.
std::vector<int> assign_parts(const VertexSequence& sequence, int parts) {
  const std::vector<int> first = cut_into_even_parts(sequence.work, sequence.cut_before, parts, kMostLoad);
  const int places = static_cast<int>(sequence.vertices.size());
  std::vector<int> part(sequence.vertices.size(), 0);
  std::vector<double> load(static_cast<size_t>(parts), 0);
  for (int p = 0; p < parts; ++p)
    for (int i = first[p]; i < first[p + 1]; ++i) {
      part[i] = p;
      load[p] += sequence.work[i];
    }
  const double mean = std::accumulate(load.begin(), load.end(), 0.0) / parts;
  const double most = std::max(*std::max_element(load.begin(), load.end()), kMostLoad * mean);
  for (int begin = 0, end = 0; begin < places; begin = end) {
    while (end < places && sequence.component[end] == sequence.component[begin]) ++end;
    cut_component_again(sequence, begin, end, most, load, part);
  }
  return part;
}

std::vector<int> owners(const Mesh& mesh, int ranks, std::span<const int> uncut,
                        const std::vector<GraphEdge>& all) {
  const GraphVertices v = graph_vertices(mesh, ranks, uncut);
  const VertexSequence sequence = sequence_of(mesh, v, all);
  const std::vector<int> part = assign_parts(sequence, ranks - v.first_free_rank);
  std::vector<int> of_vertex(v.work.size());
  for (size_t i = 0; i < part.size(); ++i) of_vertex[sequence.vertices[i]] = v.first_free_rank + part[i];
  std::vector<int> owner = v.rank_of_node;
  for (size_t n = 0; n < owner.size(); ++n)
    if (owner[n] < 0) owner[n] = of_vertex[v.vertex_of_node[n]];
  for (size_t n = 0; n < owner.size(); ++n) owner[n] = owner[carrier(mesh, static_cast<int>(n))];
  return owner;
}

// Nodes that other ranks see, once for each rank that does.
size_t shared_nodes(const std::vector<GraphEdge>& all, const std::vector<int>& owner) {
  std::vector<std::pair<int, int>> pairs;
  for (const GraphEdge& e : all)
    if (const int rank = owner[e.to]; rank != owner[e.from]) pairs.emplace_back(e.from, rank);
  std::sort(pairs.begin(), pairs.end());
  return static_cast<size_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

}  // namespace

std::vector<int> partition(const Mesh& mesh, int ranks, std::span<const std::pair<int, int>> coupled,
                           std::span<const int> uncut) {
  if (ranks == 1) return std::vector<int>(mesh.nodes.size(), 0);
  std::vector<int> plain = owners(mesh, ranks, uncut, node_edges(mesh, {}));
  if (coupled.empty()) return plain;
  // METIS looks for few cut edges; what costs is the nodes at them.
  const std::vector<GraphEdge> all = node_edges(mesh, coupled);
  std::vector<int> weighed = owners(mesh, ranks, uncut, all);
  return shared_nodes(all, weighed) < shared_nodes(all, plain) ? weighed : plain;
}

Balance balance(const Mesh& mesh, const std::vector<int>& owner, int ranks) {
  Balance out;
  std::vector<double> load(static_cast<size_t>(ranks), 0);
  for (size_t n = 0; n < mesh.nodes.size(); ++n) load[owner[n]] += work_of(mesh.nodes[n]);
  const double sum = std::accumulate(load.begin(), load.end(), 0.0);
  if (sum > 0) out.imbalance = *std::max_element(load.begin(), load.end()) * ranks / sum;
  for (const LineSpan& l : mesh.lines) {
    const auto first = owner.begin() + l.first_node, last = first + l.nodes;
    out.cut_lines += std::any_of(first, last, [&](int rank) { return rank != *first; });
  }
  out.cut_elements = cut_elements(mesh, owner);
  return out;
}

int cut_elements(const Mesh& mesh, const std::vector<int>& owner) {
  return static_cast<int>(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                        [&](const Element& e) { return owner[e.first] != owner[e.second]; }));
}

}  // namespace hawser
