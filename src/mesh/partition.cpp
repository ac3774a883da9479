// Cuts the graph of nodes and couplings (node_graph.hpp) into one part for each rank: consecutive vertices of
// its sequence (even_parts.hpp), or METIS inside a component where that cuts less. Its input from the case:
// run/node_owners.cpp.
#include "hawser/mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "hawser/math/last_not_after.hpp"
#include "hawser/mesh/even_parts.hpp"
#include "node_graph.hpp"

namespace hawser {
namespace {

// Work of a part over its fair share (the mean) that is accepted to avoid further cuts: the smallest for
// which a farm of 300 equal lines has no cut line on 4 to 64 ranks, 5/(300/64) = 1.067
// (docs/performance.md#farms).
constexpr double kMaxImbalance = 1.07;

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

// Calls visit(second node) for the elements whose nodes belong to different ranks.
template <class Visit>
void for_cut_elements(const Mesh& mesh, const NodeRanks& owner, const Visit& visit) {
  for (const EvenPart& part : mesh.parts()) {
    const int last_node = part.first_node + part.elements;
    for (size_t r = owner.run_of(part.first_node) + 1; r < owner.runs().size(); ++r) {
      if (owner.runs()[r].first > last_node) break;
      visit(owner.runs()[r].first);
    }
  }
}

long cost_of_cut(std::span<const GraphEdge> edges, const auto& part) {
  long cut = 0;
  for (const GraphEdge& e : edges)
    if (part(e.from) != part(e.to)) cut += e.cost;
  return cut;
}

// A component, positions [begin, end) of the sequence, with its parts one by one.
struct Component {
  int begin = 0, end = 0;
  std::vector<double> work;
  std::vector<int> part;
  std::vector<GraphEdge> edges;  // between places in the component, sorted
};

// The cut of the sequence: parts are runs of positions.
struct SequenceCut {
  std::vector<int> first;         // position of each part, and the number of positions
  std::vector<double> part_work;  // of each part
  double allowed_work = 0;        // of a part

  int part_of(int position) const {
    return static_cast<int>(last_not_after(first, position) - first.begin());
  }
};

// Calls visit(first vertex in the run, vertices, part) for the stretches of a run that have the same part.
template <class Visit>
void for_parts_of(const VertexRun& p, const SequenceCut& cut, const Visit& visit) {
  for (int i = 0; i < p.vertices;) {
    const int part = cut.part_of(p.position + i);
    const int end = std::min(p.vertices, cut.first[part + 1] - p.position);
    visit(i, end - i, part);
    i = end;
  }
}

SequenceCut cut_sequence(const GraphSequence& sequence, int parts) {
  std::vector<EqualItems> row;
  for (const VertexRun& p : sequence.vertex_runs)
    row.push_back({p.vertices, static_cast<double>(p.work), p.before});
  SequenceCut cut{cut_into_even_parts(row, parts, kMaxImbalance),
                  std::vector<double>(static_cast<size_t>(parts), 0)};
  for (const VertexRun& p : sequence.vertex_runs)
    for_parts_of(p, cut, [&](int, int vertices, int part) {
      cut.part_work[part] += static_cast<double>(vertices) * p.work;
    });
  const double mean = std::accumulate(cut.part_work.begin(), cut.part_work.end(), 0.0) / parts;
  cut.allowed_work =
      std::max(*std::max_element(cut.part_work.begin(), cut.part_work.end()), kMaxImbalance * mean);
  return cut;
}

Component component_of(const GraphSequence& sequence, std::span<const VertexRun> vertex_runs,
                       const SequenceCut& cut) {
  Component out;
  out.begin = vertex_runs.front().position;
  out.end = vertex_runs.back().position + vertex_runs.back().vertices;
  for (const VertexRun& p : vertex_runs) {
    out.work.insert(out.work.end(), static_cast<size_t>(p.vertices), p.work);
    for_parts_of(p, cut, [&](int, int vertices, int part) {
      out.part.insert(out.part.end(), static_cast<size_t>(vertices), part);
    });
    for (int i = p.position - out.begin, end = i + p.vertices; i + 1 < end; ++i) {
      out.edges.push_back({i, i + 1, kChainCost});
      out.edges.push_back({i + 1, i, kChainCost});
    }
  }
  const auto begins_before = [](const GraphEdge& e, int position) { return e.from < position; };
  const auto from = std::lower_bound(sequence.edges.begin(), sequence.edges.end(), out.begin, begins_before);
  const auto to = std::lower_bound(from, sequence.edges.end(), out.end, begins_before);
  for (auto e = from; e != to; ++e) out.edges.push_back({e->from - out.begin, e->to - out.begin, e->cost});
  out.edges = merged(std::move(out.edges));
  return out;
}

// Cuts a component again by METIS into parts of the same work. The new cut replaces that of the sequence
// if its edges cost less and no part gets more work than allowed; returns true then.
bool cut_again(Component& c, SequenceCut& cut) {
  const int first = c.part.front();
  const int parts = c.part.back() - first + 1;
  // Work of the component in each part.
  std::vector<double> shares(static_cast<size_t>(parts), 0);
  for (size_t i = 0; i < c.part.size(); ++i) shares[c.part[i] - first] += c.work[i];
  if (*std::min_element(shares.begin(), shares.end()) <= 0) return false;
  const std::vector<int> other = metis_parts(c.work, c.edges, shares);
  if (cost_of_cut(c.edges, [&](int i) { return other[i]; }) >=
      cost_of_cut(c.edges, [&](int i) { return c.part[i]; }))
    return false;
  std::vector<double> new_work(cut.part_work.begin() + first, cut.part_work.begin() + first + parts);
  for (int p = 0; p < parts; ++p) new_work[p] -= shares[p];
  for (size_t i = 0; i < c.part.size(); ++i) new_work[other[i]] += c.work[i];
  if (*std::max_element(new_work.begin(), new_work.end()) > cut.allowed_work) return false;
  std::copy(new_work.begin(), new_work.end(), cut.part_work.begin() + first);
  for (size_t i = 0; i < c.part.size(); ++i) c.part[i] = first + other[i];
  return true;
}

// Consecutive nodes with the same owner.
struct OwnedRun {
  int first = 0, nodes = 0, rank = 0;
};

// Owners of the nodes of a component, except those that are carried.
void assign(const Mesh& mesh, const GraphSequence& sequence, std::span<const VertexRun> vertex_runs,
            int first_rank, SequenceCut& cut, std::vector<OwnedRun>& out) {
  const int begin = vertex_runs.front().position;
  const int end = vertex_runs.back().position + vertex_runs.back().vertices;
  const auto set_owner = [&](const VertexRun& p, int vertex, int vertices, int part) {
    if (p.uncut >= 0)
      out.push_back({p.first_node, mesh.lines[p.uncut].nodes, first_rank + part});
    else
      out.push_back({p.first_node + vertex, vertices, first_rank + part});
  };
  const int parts = cut.part_of(end - 1) - cut.part_of(begin) + 1;
  if (parts > 1 && end - begin > parts)
    if (Component c = component_of(sequence, vertex_runs, cut); cut_again(c, cut)) {
      for (const VertexRun& p : vertex_runs)
        for (int i = 0; i < p.vertices; ++i) set_owner(p, i, 1, c.part[p.position + i - begin]);
      return;
    }
  for (const VertexRun& p : vertex_runs)
    for_parts_of(p, cut, [&](int vertex, int vertices, int part) { set_owner(p, vertex, vertices, part); });
}

NodeRanks owners(const Mesh& mesh, int ranks, std::span<const int> uncut,
                 const std::vector<GraphEdge>& joined) {
  const GraphSequence sequence = graph_sequence(mesh, ranks, uncut, joined);
  const int first_rank = static_cast<int>(sequence.dedicated_ranks.size());
  SequenceCut cut = cut_sequence(sequence, ranks - first_rank);
  std::vector<OwnedRun> runs;
  for (const auto& [line, rank] : sequence.dedicated_ranks)
    runs.push_back({mesh.lines[line].first_node, mesh.lines[line].nodes, rank});
  const std::span<const VertexRun> vertex_runs = sequence.vertex_runs;
  for (size_t begin = 0, end = 0; begin < vertex_runs.size(); begin = end) {
    while (end < vertex_runs.size() && vertex_runs[end].component == vertex_runs[begin].component) ++end;
    assign(mesh, sequence, vertex_runs.subspan(begin, end - begin), first_rank, cut, runs);
  }
  std::sort(runs.begin(), runs.end(), [](const OwnedRun& a, const OwnedRun& b) { return a.first < b.first; });
  const auto owner_of = [&](int n) { return last_not_after(runs, n, &OwnedRun::first)->rank; };
  // Carried nodes are in runs of uncut lines, or between runs.
  NodeRanks out;
  size_t run = 0;
  const auto fill_to = [&](int end) {
    while (out.size() < end) {
      const int run_end = runs[run].first + runs[run].nodes;
      if (run_end > out.size()) out.append(std::min(run_end, end) - out.size(), runs[run].rank);
      if (run_end <= end) ++run;
    }
  };
  for (const auto& [n, with] : sequence.carried) {
    fill_to(n);
    out.append(1, owner_of(with));
  }
  fill_to(mesh.nodes());
  return out;
}

// Nodes that are ghosts on other ranks, once for each of these ranks.
size_t shared_nodes(const Mesh& mesh, const std::vector<GraphEdge>& joined, const NodeRanks& owner) {
  std::vector<std::pair<int, int>> pairs;
  const auto add = [&](int a, int b) {
    if (const int rank = owner[b]; rank != owner[a]) pairs.emplace_back(a, rank);
  };
  for_cut_elements(mesh, owner, [&](int second) {
    add(second - 1, second);
    add(second, second - 1);
  });
  for (const GraphEdge& e : joined) add(e.from, e.to);
  std::sort(pairs.begin(), pairs.end());
  return static_cast<size_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

}  // namespace

NodeRanks partition(const Mesh& mesh, int ranks, std::span<const std::pair<int, int>> coupled,
                    std::span<const int> uncut) {
  if (ranks == 1) return NodeRanks::all_of(mesh.nodes());
  NodeRanks uncoupled = owners(mesh, ranks, uncut, joins(mesh, {}));
  if (coupled.empty()) return uncoupled;
  // METIS minimises the cost of cut edges, but the size of messages is the number of shared nodes: the
  // partition with fewer of these is taken.
  const std::vector<GraphEdge> all = joins(mesh, coupled);
  NodeRanks with_couplings = owners(mesh, ranks, uncut, all);
  return shared_nodes(mesh, all, with_couplings) < shared_nodes(mesh, all, uncoupled) ? with_couplings
                                                                                      : uncoupled;
}

Balance balance(const Mesh& mesh, const NodeRanks& owner, int ranks) {
  Balance out;
  std::vector<double> load(static_cast<size_t>(ranks), 0);
  for (const NodeRun& nodes : node_runs(mesh)) {
    const int end = nodes.first + nodes.nodes;
    for (size_t r = owner.run_of(nodes.first); r < owner.runs().size() && owner.runs()[r].first < end; ++r) {
      const int nodes_of_rank = std::min(end, owner.end(r)) - std::max(nodes.first, owner.runs()[r].first);
      load[owner.runs()[r].rank] += static_cast<double>(nodes_of_rank) * work_of(nodes.rotates);
    }
  }
  const double sum = std::accumulate(load.begin(), load.end(), 0.0);
  if (sum > 0) out.imbalance = *std::max_element(load.begin(), load.end()) * ranks / sum;
  for (const LineSpan& l : mesh.lines) out.cut_lines += !owner.whole(l.first_node, l.nodes);
  out.cut_elements = cut_elements(mesh, owner);
  return out;
}

int cut_elements(const Mesh& mesh, const NodeRanks& owner) {
  int cut = 0;
  for_cut_elements(mesh, owner, [&](int) { ++cut; });
  return cut;
}

}  // namespace hawser
