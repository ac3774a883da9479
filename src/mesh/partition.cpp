// The graph of nodes, elements and couplings with its weights, lines that stay whole, and the cut of that
// graph into one part for each rank.
#include "hawser/mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace hawser {
namespace {

// Relative cost of a node in an implicit step (docs/performance.md): kernels, assembly and factorisation.
constexpr idx_t kBeamWork = 5, kCableWork = 1;
// What is cut with an edge: a chain, or a coupling, of which a node of a line in contact has several.
constexpr idx_t kChainEdge = 100, kCoupledEdge = 10;
constexpr double kMostLoad = 1.05;  // of a rank, over its share, where lines need not be cut

struct Edge {
  int from, to;
  idx_t weight;
};

// Sorted, edges between the same two as one.
std::vector<Edge> merged(std::vector<Edge> all) {
  std::sort(all.begin(), all.end(),
            [](const Edge& a, const Edge& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
  size_t kept = 0;
  for (const Edge& e : all)
    if (kept > 0 && all[kept - 1].from == e.from && all[kept - 1].to == e.to)
      all[kept - 1].weight += e.weight;
    else
      all[kept++] = e;
  all.resize(kept);
  return all;
}

// Between nodes, both ways.
std::vector<Edge> edges(const Mesh& mesh, std::span<const std::pair<int, int>> coupled) {
  std::vector<Edge> all;
  const auto add = [&](int a, int b, idx_t w) {
    if (a != b) {
      all.push_back({a, b, w});
      all.push_back({b, a, w});
    }
  };
  for (const Element& e : mesh.elements) add(e.first, e.second, kChainEdge);
  for (size_t n = 0; n < mesh.nodes.size(); ++n)
    for (const int other : {mesh.nodes[n].pinned_to, mesh.nodes[n].tied_to})
      if (other >= 0) add(static_cast<int>(n), other, kChainEdge);
  for (const auto& [a, b] : coupled) add(a, b, kCoupledEdge);
  return all;
}

// The part of each vertex, by METIS. `all`: sorted by vertex, both ways.
std::vector<idx_t> cut_into_parts(std::vector<idx_t> weight, const std::vector<Edge>& all, idx_t parts) {
  std::vector<idx_t> start(weight.size() + 1, 0), next, edge, part(weight.size(), 0);
  if (weight.empty() || parts == 1) return part;
  for (const Edge& e : all) {
    ++start[e.from + 1];
    next.push_back(e.to);
    edge.push_back(e.weight);
  }
  for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  idx_t vertices = static_cast<idx_t>(weight.size()), constraints = 1, cut = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // every rank computes the same cut
  const int status =
      METIS_PartGraphRecursive(&vertices, &constraints, start.data(), next.data(), weight.data(), nullptr,
                               edge.data(), &parts, nullptr, nullptr, options, &cut, part.data());
  if (status != METIS_OK) throw std::runtime_error("METIS could not cut the lines into parts");
  return part;
}

// What METIS is to share out: nodes, and whole lines as one vertex each.
struct Shares {
  std::vector<int> owner;     // of each node; -1: METIS chooses
  std::vector<int> vertex;    // of each node; -1: it has an owner
  std::vector<idx_t> weight;  // of each vertex
  int first = 0;              // rank of the first part
};

// A whole line of more work than a rank's fair share of what is left gets a rank of its own.
Shares share_lines(const Mesh& mesh, int ranks, std::span<const int> whole) {
  Shares s;
  s.owner.assign(mesh.nodes.size(), -1);
  s.vertex = s.owner;
  const auto work = [&](size_t n) { return mesh.nodes[n].rotates ? kBeamWork : kCableWork; };
  const auto each_node = [&](int line, const auto& what) {
    const LineSpan& l = mesh.lines[line];
    for (int i = 0; i < l.nodes; ++i) what(static_cast<size_t>(l.first_node + i));
  };
  idx_t left = 0;
  for (size_t n = 0; n < mesh.nodes.size(); ++n) left += work(n);
  std::vector<std::pair<idx_t, int>> lines;
  for (const int l : whole) {
    lines.emplace_back(0, l);
    each_node(l, [&](size_t n) { lines.back().first += work(n); });
  }
  std::sort(lines.rbegin(), lines.rend());
  for (const auto& [weight, line] : lines) {
    const bool alone = s.first + 1 < ranks && weight * (ranks - s.first) >= left;
    std::vector<int>& share = alone ? s.owner : s.vertex;
    const int number = alone ? s.first : static_cast<int>(s.weight.size());
    each_node(line, [&](size_t n) { share[n] = number; });
    if (alone) {
      left -= weight;
      ++s.first;
    } else
      s.weight.push_back(weight);
  }
  for (size_t n = 0; n < mesh.nodes.size(); ++n)
    if (s.owner[n] < 0 && s.vertex[n] < 0) {
      s.vertex[n] = static_cast<int>(s.weight.size());
      s.weight.push_back(work(n));
    }
  return s;
}

// The part of each vertex where nothing needs to be cut: what edges join stays together, and parts are
// stretches of the file. Empty: a part would have more than kMostLoad of its share.
std::vector<idx_t> share_components(const Shares& s, const std::vector<Edge>& between, int parts) {
  std::vector<int> component(s.weight.size());
  std::iota(component.begin(), component.end(), 0);
  const auto first = [&](int v) {
    while (component[v] != v) v = component[v] = component[component[v]];
    return v;
  };
  for (const Edge& e : between) component[first(e.from)] = first(e.to);
  std::vector<double> weight(s.weight.size(), 0), load(static_cast<size_t>(parts), 0);
  double total = 0, before = 0;
  for (size_t v = 0; v < s.weight.size(); ++v) {
    weight[first(static_cast<int>(v))] += static_cast<double>(s.weight[v]);
    total += static_cast<double>(s.weight[v]);
  }
  std::vector<idx_t> part(s.weight.size(), -1);
  for (const int v : s.vertex) {
    if (v < 0) continue;
    const int c = first(v);
    if (part[c] < 0) {
      part[c] =
          static_cast<idx_t>(std::min(parts - 1.0, std::floor((before + 0.5 * weight[c]) / total * parts)));
      before += weight[c];
      load[part[c]] += weight[c];
    }
    part[v] = part[c];
  }
  const double most = load.empty() ? 0 : *std::max_element(load.begin(), load.end());
  return most * parts > kMostLoad * total ? std::vector<idx_t>() : part;
}

std::vector<int> cut_graph(const Mesh& mesh, int ranks, std::span<const int> whole,
                           const std::vector<Edge>& all) {
  const Shares s = share_lines(mesh, ranks, whole);
  std::vector<Edge> between;
  for (const Edge& e : all) {
    const int a = s.vertex[e.from], b = s.vertex[e.to];
    if (a >= 0 && b >= 0 && a != b) between.push_back({a, b, e.weight});
  }
  std::vector<idx_t> part = share_components(s, between, ranks - s.first);
  if (part.empty()) part = cut_into_parts(s.weight, merged(std::move(between)), ranks - s.first);
  std::vector<int> owner = s.owner;
  for (size_t n = 0; n < owner.size(); ++n)
    if (owner[n] < 0) owner[n] = s.first + static_cast<int>(part[s.vertex[n]]);
  for (size_t n = 0; n < owner.size(); ++n)  // one position has one owner
    for (const int other : {mesh.nodes[n].pinned_to, mesh.nodes[n].tied_to})
      if (other >= 0) owner[n] = owner[other];
  return owner;
}

// Nodes that other ranks see, once for each rank that does.
size_t shared_nodes(const std::vector<Edge>& all, const std::vector<int>& owner) {
  std::vector<std::pair<int, int>> pairs;
  for (const Edge& e : all)
    if (const int rank = owner[e.to]; rank != owner[e.from]) pairs.emplace_back(e.from, rank);
  std::sort(pairs.begin(), pairs.end());
  return static_cast<size_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

}  // namespace

std::vector<int> partition(const Mesh& mesh, int ranks, std::span<const std::pair<int, int>> coupled,
                           std::span<const int> whole) {
  if (ranks == 1) return std::vector<int>(mesh.nodes.size(), 0);
  std::vector<int> plain = cut_graph(mesh, ranks, whole, edges(mesh, {}));
  if (coupled.empty()) return plain;
  // METIS looks for few cut edges; what costs is the nodes at them.
  const std::vector<Edge> all = edges(mesh, coupled);
  std::vector<int> weighed = cut_graph(mesh, ranks, whole, all);
  return shared_nodes(all, weighed) < shared_nodes(all, plain) ? weighed : plain;
}

int cut_elements(const Mesh& mesh, const std::vector<int>& owner) {
  return static_cast<int>(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                        [&](const Element& e) { return owner[e.first] != owner[e.second]; }));
}

}  // namespace hawser
