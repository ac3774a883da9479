// Cuts the graph of nodes and couplings into one part for each rank: runs of the file, or METIS inside a
// component where that cuts less.
#include "hawser/mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "hawser/math/last_not_after.hpp"
#include "hawser/mesh/even_parts.hpp"
#include "node_graph.hpp"

namespace hawser {
namespace {

constexpr double kMaxLoad = 1.07;  // work of a rank over the mean, accepted to avoid further cuts

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
    const int last_node = part.first_node + part.lengths.elements;
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
  std::vector<int> first;    // position of each part, and the number of positions
  std::vector<double> load;  // work of each part
  double max_load = 0;       // work that a part may have

  int part_of(int position) const {
    return static_cast<int>(last_not_after(first, position) - first.begin());
  }
};

// Calls visit(first vertex in the piece, vertices, part) for the runs of a piece that have the same part.
template <class Visit>
void for_parts_of(const Piece& p, const SequenceCut& cut, const Visit& visit) {
  for (int i = 0; i < p.vertices;) {
    const int part = cut.part_of(p.position + i);
    const int end = std::min(p.vertices, cut.first[part + 1] - p.position);
    visit(i, end - i, part);
    i = end;
  }
}

SequenceCut cut_sequence(const GraphSequence& sequence, int parts) {
  std::vector<EqualItems> row;
  for (const Piece& p : sequence.pieces) row.push_back({p.vertices, static_cast<double>(p.work), p.before});
  SequenceCut cut{cut_into_even_parts(row, parts, kMaxLoad),
                  std::vector<double>(static_cast<size_t>(parts), 0)};
  for (const Piece& p : sequence.pieces)
    for_parts_of(p, cut, [&](int, int vertices, int part) {
      cut.load[part] += static_cast<double>(vertices) * p.work;
    });
  const double mean = std::accumulate(cut.load.begin(), cut.load.end(), 0.0) / parts;
  cut.max_load = std::max(*std::max_element(cut.load.begin(), cut.load.end()), kMaxLoad * mean);
  return cut;
}

Component component_of(const GraphSequence& sequence, std::span<const Piece> pieces, const SequenceCut& cut) {
  Component out;
  out.begin = pieces.front().position;
  out.end = pieces.back().position + pieces.back().vertices;
  for (const Piece& p : pieces) {
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

// Cuts a component again by METIS into parts of the same weights. The new cut replaces that of the sequence
// if its edges cost less and no part gets more work than allowed; returns true then.
bool cut_again(Component& c, SequenceCut& cut) {
  const int first = c.part.front();
  const int parts = c.part.back() - first + 1;
  std::vector<double> part_work(static_cast<size_t>(parts), 0);
  for (size_t i = 0; i < c.part.size(); ++i) part_work[c.part[i] - first] += c.work[i];
  if (*std::min_element(part_work.begin(), part_work.end()) <= 0) return false;
  const std::vector<int> other = metis_parts(c.work, c.edges, part_work);
  if (cost_of_cut(c.edges, [&](int i) { return other[i]; }) >=
      cost_of_cut(c.edges, [&](int i) { return c.part[i]; }))
    return false;
  std::vector<double> with(cut.load.begin() + first, cut.load.begin() + first + parts);
  for (int p = 0; p < parts; ++p) with[p] -= part_work[p];
  for (size_t i = 0; i < c.part.size(); ++i) with[other[i]] += c.work[i];
  if (*std::max_element(with.begin(), with.end()) > cut.max_load) return false;
  std::copy(with.begin(), with.end(), cut.load.begin() + first);
  for (size_t i = 0; i < c.part.size(); ++i) c.part[i] = first + other[i];
  return true;
}

// Consecutive nodes with the same owner.
struct OwnedRun {
  int first = 0, nodes = 0, rank = 0;
};

// Owners of the nodes of a component, except those that are carried.
void assign(const Mesh& mesh, const GraphSequence& sequence, std::span<const Piece> pieces, int first_rank,
            SequenceCut& cut, std::vector<OwnedRun>& out) {
  const int begin = pieces.front().position, end = pieces.back().position + pieces.back().vertices;
  const auto set_owner = [&](const Piece& p, int vertex, int vertices, int part) {
    if (p.uncut >= 0)
      out.push_back({p.first_node, mesh.lines[p.uncut].nodes, first_rank + part});
    else
      out.push_back({p.first_node + vertex, vertices, first_rank + part});
  };
  const int parts = cut.part_of(end - 1) - cut.part_of(begin) + 1;
  if (parts > 1 && end - begin > parts)
    if (Component c = component_of(sequence, pieces, cut); cut_again(c, cut)) {
      for (const Piece& p : pieces)
        for (int i = 0; i < p.vertices; ++i) set_owner(p, i, 1, c.part[p.position + i - begin]);
      return;
    }
  for (const Piece& p : pieces)
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
  const std::span<const Piece> pieces = sequence.pieces;
  for (size_t begin = 0, end = 0; begin < pieces.size(); begin = end) {
    while (end < pieces.size() && pieces[end].component == pieces[begin].component) ++end;
    assign(mesh, sequence, pieces.subspan(begin, end - begin), first_rank, cut, runs);
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
  NodeRanks plain = owners(mesh, ranks, uncut, joins(mesh, {}));
  if (coupled.empty()) return plain;
  // METIS minimises cut edges; the cost is that of the nodes at them.
  const std::vector<GraphEdge> all = joins(mesh, coupled);
  NodeRanks weighed = owners(mesh, ranks, uncut, all);
  return shared_nodes(mesh, all, weighed) < shared_nodes(mesh, all, plain) ? weighed : plain;
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
