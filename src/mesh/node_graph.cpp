// Edges and vertices of the graph that is partitioned, and their sequence.
#include "node_graph.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>

#include "hawser/math/disjoint_sets.hpp"
#include "hawser/math/last_not_after.hpp"

namespace hawser {
namespace {

// Newton iterations cost 1.37 to 1.46 µs per node of a beam, 0.29 to 0.30 of a cable (docs/performance.md).
constexpr int kBeamWork = 5;
constexpr int kCableWork = 1;
// A tenth of kChainCost. A node has twelve couplings to a parallel line with equal elements (four for each of
// three pairs of near elements): separating it from that line costs about as much as cutting its own.
constexpr int kCouplingCost = 10;

struct UncutLine {
  std::int64_t work;
  int line;
};

// Heaviest first; of equal work in the order of the file.
std::vector<UncutLine> sorted_by_work(std::span<const std::int64_t> line_work, std::span<const int> uncut) {
  std::vector<UncutLine> lines;
  for (const int l : uncut) lines.push_back({line_work[l], l});
  std::sort(lines.begin(), lines.end(), [](const UncutLine& a, const UncutLine& b) {
    return std::tuple(-a.work, a.line) < std::tuple(-b.work, b.line);
  });
  return lines;
}

class Builder {
 public:
  Builder(const Mesh& mesh, int ranks, std::span<const int> uncut, const std::vector<GraphEdge>& joins)
      : mesh_(mesh), joins_(joins), runs_(node_runs(mesh)), kind_(mesh.lines.size(), kCut) {
    for (const NodeRun& r : runs_)
      if (r.special)
        if (const int with = carrier(mesh, r.first); with != r.first)
          out_.carried.emplace_back(r.first, with);
    find_places_of_bodies();
    place_uncut_lines(ranks, uncut);
    add_vertex_runs();
    move_work_of_carried();
    add_edges();
    arrange();
  }
  GraphSequence take() { return std::move(out_); }

 private:
  static constexpr int kCut = -1, kDedicatedRank = -2;  // otherwise: work of an uncut line that is a vertex

  const Mesh& mesh_;
  const std::vector<GraphEdge>& joins_;
  std::vector<NodeRun> runs_;
  std::vector<std::int64_t> kind_;  // of each line
  std::map<int, int> beside_;  // for each body's node: the middle one of the nodes of lines it is joined to
  std::vector<std::pair<int, int>> chain_;  // nodes that an element joins, not of one run
  GraphSequence out_;

  std::int64_t kind_of(int n) const { return n < mesh_.line_nodes() ? kind_[line_of(n)] : kCut; }
  int line_of(int n) const {
    return static_cast<int>(last_not_after(mesh_.lines, n, &LineSpan::first_node) - mesh_.lines.begin());
  }
  // Carrier of a node; -1: none.
  int carrier_of(int n) const {
    const auto at = std::lower_bound(out_.carried.begin(), out_.carried.end(), std::pair(n, -1));
    return at != out_.carried.end() && at->first == n ? at->second : -1;
  }

  void find_places_of_bodies() {
    const int first = mesh_.line_nodes();
    std::map<int, std::vector<int>> joined;
    for (const GraphEdge& e : joins_)
      if (e.from >= first && e.to < first) joined[e.from].push_back(e.to);
    for (auto& [body, nodes] : joined) {
      std::sort(nodes.begin(), nodes.end());
      beside_[body] = nodes[(nodes.size() - 1) / 2];
    }
  }

  // Separate vertices or ranks for uncut lines.
  void place_uncut_lines(int ranks, std::span<const int> uncut) {
    std::vector<std::int64_t> work(mesh_.lines.size(), 0);
    std::int64_t remaining_work = 0;
    for (const NodeRun& r : runs_) {
      const std::int64_t run_work = static_cast<std::int64_t>(r.nodes) * work_of(r.rotates);
      remaining_work += run_work;
      if (r.first < mesh_.line_nodes()) work[line_of(r.first)] += run_work;
    }
    int rank = 0;
    for (const auto& [line_work, line] : sorted_by_work(work, uncut)) {
      const int free_ranks = ranks - rank;
      if (free_ranks > 1 && line_work * free_ranks >= remaining_work) {
        out_.dedicated_ranks.emplace_back(line, rank++);
        kind_[line] = kDedicatedRank;
        remaining_work -= line_work;
      } else {
        kind_[line] = line_work;
      }
    }
  }

  // Runs in the order of the file. Carriers, and nodes that have a body beside them, end a run.
  void add_vertex_runs() {
    std::set<int> alone, last;
    for (const auto& [n, with] : out_.carried) alone.insert(with);
    for (const auto& [body, n] : beside_) last.insert(n);
    int line = -1;
    for (const NodeRun& r : runs_) {
      const bool on_line = r.first < mesh_.line_nodes();
      const bool begins = on_line && line_of(r.first) != line;
      if (on_line) line = line_of(r.first);
      if (on_line && kind_[line] != kCut) {
        if (begins && kind_[line] != kDedicatedRank)
          out_.vertex_runs.push_back(
              {.first_node = r.first, .work = static_cast<int>(kind_[line]), .uncut = line});
        continue;
      }
      if (on_line && !begins) chain_.emplace_back(r.first - 1, r.first);
      if (carrier_of(r.first) >= 0) continue;
      for (int n = r.first, end = r.first + r.nodes; n < end;) {
        int to = end;
        if (alone.contains(n)) {
          to = n + 1;
        } else {
          if (const auto next = alone.upper_bound(n); next != alone.end()) to = std::min(to, *next);
          if (const auto next = last.lower_bound(n); next != last.end()) to = std::min(to, *next + 1);
        }
        if (n > r.first) chain_.emplace_back(n - 1, n);
        out_.vertex_runs.push_back({.first_node = n, .vertices = to - n, .work = work_of(r.rotates)});
        n = to;
      }
    }
  }

  // Vertex run and vertex in it of a node; {-1, 0}: its line has a rank.
  std::pair<int, int> vertex_of(int n) const {
    if (const int with = carrier_of(n); with >= 0 && kind_of(n) == kCut) n = with;
    if (kind_of(n) == kDedicatedRank) return {-1, 0};
    const bool whole = kind_of(n) != kCut;
    const int at = whole ? mesh_.lines[line_of(n)].first_node : n;
    const auto run = last_not_after(out_.vertex_runs, at, &VertexRun::first_node);
    return {static_cast<int>(run - out_.vertex_runs.begin()), whole ? 0 : n - run->first_node};
  }

  void move_work_of_carried() {
    for (const auto& [n, with] : out_.carried) {
      const int work = work_of(mesh_.node(n).rotates);
      if (kind_of(n) >= 0) out_.vertex_runs[vertex_of(n).first].work -= work;
      if (const int to = vertex_of(with).first; to >= 0) out_.vertex_runs[to].work += work;
    }
  }

  // Between vertices (run, vertex in it), as numbers in the order of the file.
  void add_edges() {
    std::vector<int> before{0};
    for (const VertexRun& p : out_.vertex_runs) before.push_back(before.back() + p.vertices);
    for (size_t i = 0; i < out_.vertex_runs.size(); ++i) out_.vertex_runs[i].position = before[i];
    const auto add = [&](int a, int b, int cost) {
      const auto [p, i] = vertex_of(a);
      const auto [q, j] = vertex_of(b);
      if (p < 0 || q < 0 || (p == q && i == j)) return;
      out_.edges.push_back({before[p] + i, before[q] + j, cost});
    };
    for (const auto& [a, b] : chain_) {
      add(a, b, kChainCost);
      add(b, a, kChainCost);
    }
    for (const GraphEdge& e : joins_) add(e.from, e.to, e.cost);
  }

  // True if a run begins with the first node of a line that is not carried by another node.
  bool begins_line(const VertexRun& p) const {
    if (p.first_node >= mesh_.line_nodes()) return false;
    const int first = mesh_.lines[line_of(p.first_node)].first_node;
    return p.first_node == first || (p.first_node == first + 1 && carrier_of(first) >= 0);
  }

  // Brings the runs into the order of the sequence, with their components.
  void arrange() {
    std::vector<VertexRun>& vertex_runs = out_.vertex_runs;
    std::vector<int> first_vertex;
    for (const VertexRun& p : vertex_runs) first_vertex.push_back(p.position);
    const auto run_at = [&](int vertex) {
      return static_cast<int>(last_not_after(first_vertex, vertex) - first_vertex.begin());
    };
    DisjointSets joined(vertex_runs.size());
    for (const GraphEdge& e : out_.edges) joined.unite(run_at(e.from), run_at(e.to));
    // Runs are in the order of their first nodes.
    const std::vector<int> smallest = joined.smallest_of_all();
    for (size_t i = 0; i < vertex_runs.size(); ++i)
      vertex_runs[i].component = vertex_runs[smallest[i]].first_node;
    const auto key = [&](int i) {
      const VertexRun& p = vertex_runs[i];
      const bool body = p.first_node >= mesh_.line_nodes();
      const auto at = beside_.find(p.first_node);
      return std::tuple(p.component, body && at != beside_.end() ? at->second : p.first_node, body,
                        p.first_node);
    };
    std::vector<int> order;
    for (int i = 0; i < std::ssize(vertex_runs); ++i) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    std::vector<VertexRun> arranged;
    std::vector<int> position(vertex_runs.size());
    int next = 0;
    for (const int i : order) {
      VertexRun p = vertex_runs[i];
      p.before = arranged.empty() || arranged.back().component != p.component ? CutKind::between_components
                 : begins_line(p)                                             ? CutKind::between_lines
                                                                              : CutKind::within_line;
      p.position = position[i] = next;
      next += p.vertices;
      arranged.push_back(p);
    }
    const auto moved = [&](int vertex) {
      const int i = run_at(vertex);
      return position[i] + vertex - first_vertex[i];
    };
    for (GraphEdge& e : out_.edges) e = {moved(e.from), moved(e.to), e.cost};
    out_.edges = merged(std::move(out_.edges));
    vertex_runs = std::move(arranged);
  }
};

}  // namespace

int work_of(bool rotates) { return rotates ? kBeamWork : kCableWork; }

int carrier(const Mesh& mesh, int n) {
  for (Node node = mesh.node(n); node.tied_to >= 0 || node.pinned_to >= 0; node = mesh.node(n))
    n = node.tied_to >= 0 ? node.tied_to : node.pinned_to;
  return n;
}

std::vector<GraphEdge> joins(const Mesh& mesh, std::span<const std::pair<int, int>> coupled) {
  std::vector<GraphEdge> edges;
  const auto add = [&edges](int a, int b, int cost) {
    if (a == b) return;
    edges.push_back({a, b, cost});
    edges.push_back({b, a, cost});
  };
  for (const auto& [n, node] : mesh.special_nodes())
    for (const int other : {node.pinned_to, node.tied_to})
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

GraphSequence graph_sequence(const Mesh& mesh, int ranks, std::span<const int> uncut,
                             const std::vector<GraphEdge>& joins) {
  return Builder(mesh, ranks, uncut, joins).take();
}

}  // namespace hawser
