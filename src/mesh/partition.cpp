// Partition of the mesh: the graph of nodes, elements and couplings with its weights, lines that must not be
// cut, and the division of the graph among the ranks, into stretches in file order or by METIS.
#include "hawser/mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "hawser/mesh/stretches.hpp"

namespace hawser {
namespace {

// Relative cost of a node in an implicit step (docs/performance.md): kernels, assembly and factorisation.
constexpr idx_t kBeamWork = 5, kCableWork = 1;
// Weights of cut edges: of a chain, and of a coupling, of which a node in contact has several.
constexpr idx_t kChainEdge = 100, kCoupledEdge = 10;
constexpr double kMostLoad = 1.07;  // largest load over the mean accepted to avoid cuts

idx_t work_of(const Node& n) { return n.rotates ? kBeamWork : kCableWork; }

struct Edge {
  int from, to;
  idx_t weight;
};

// Sorted, with duplicate edges merged.
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

// Edges between nodes, in both directions.
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

// Part of each vertex of a weighted graph, for parts of the given shares, by METIS. `all`: sorted, both
// directions.
std::vector<idx_t> cut_into_parts(std::span<const double> weight, const std::vector<Edge>& all,
                                  const std::vector<double>& share) {
  std::vector<idx_t> start(weight.size() + 1, 0), next, edge, part(weight.size(), 0);
  std::vector<idx_t> weights(weight.begin(), weight.end());
  for (const Edge& e : all) {
    ++start[e.from + 1];
    next.push_back(e.to);
    edge.push_back(e.weight);
  }
  for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  const double sum = std::accumulate(share.begin(), share.end(), 0.0);
  std::vector<real_t> shares;
  for (const double s : share) shares.push_back(static_cast<real_t>(s / sum));
  auto vertices = static_cast<idx_t>(weight.size()), parts = static_cast<idx_t>(share.size());
  idx_t constraints = 1, cut = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // every rank computes the same cut
  const int status =
      METIS_PartGraphRecursive(&vertices, &constraints, start.data(), next.data(), weights.data(), nullptr,
                               edge.data(), &parts, shares.data(), nullptr, options, &cut, part.data());
  if (status != METIS_OK)
    throw std::runtime_error("METIS_PartGraphRecursive returns " + std::to_string(status));
  return part;
}

// Node that determines the owner of node n: the node of its position, the frame that carries it, or itself.
int carrier(const Mesh& mesh, int n) {
  while (mesh.nodes[n].tied_to >= 0 || mesh.nodes[n].pinned_to >= 0)
    n = mesh.nodes[n].tied_to >= 0 ? mesh.nodes[n].tied_to : mesh.nodes[n].pinned_to;
  return n;
}

// Vertices to distribute: nodes, and lines that must not be cut as one vertex each.
struct Shares {
  std::vector<int> owner;     // by node; -1: not yet assigned
  std::vector<int> vertex;    // by node; -1: already assigned
  std::vector<idx_t> weight;  // of each vertex
  std::vector<int> at;        // by vertex: its first node
  int first = 0;              // rank of the first part

  void add(idx_t work, int node) {
    weight.push_back(work);
    at.push_back(node);
  }
};

// A line that must not be cut, with more work than a rank's fair share of the rest, gets a rank of its own.
Shares share_lines(const Mesh& mesh, int ranks, std::span<const int> whole) {
  Shares s;
  s.owner.assign(mesh.nodes.size(), -1);
  s.vertex = s.owner;
  const auto work = [&](size_t n) { return work_of(mesh.nodes[n]); };
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
  std::sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
    return std::pair(-a.first, a.second) < std::pair(-b.first, b.second);
  });
  for (const auto& [weight, line] : lines) {
    const bool alone = s.first + 1 < ranks && weight * (ranks - s.first) >= left;
    std::vector<int>& share = alone ? s.owner : s.vertex;
    const int number = alone ? s.first : static_cast<int>(s.weight.size());
    each_node(line, [&](size_t n) { share[n] = number; });
    if (alone) {
      left -= weight;
      ++s.first;
    } else
      s.add(weight, mesh.lines[line].first_node);
  }
  const int nodes = static_cast<int>(mesh.nodes.size());
  std::vector<char> in_line(mesh.nodes.size());
  for (int n = 0; n < nodes; ++n) {
    in_line[n] = s.owner[n] >= 0 || s.vertex[n] >= 0;
    if (in_line[n] || carrier(mesh, n) != n) continue;
    s.vertex[n] = static_cast<int>(s.weight.size());
    s.add(work(n), n);
  }
  for (int n = 0; n < nodes; ++n) {
    const int with = carrier(mesh, n);
    if (with == n) continue;
    if (in_line[n]) {
      if (s.vertex[n] >= 0) s.weight[s.vertex[n]] -= work(n);
    } else {
      s.vertex[n] = s.vertex[with];
      s.owner[n] = s.owner[with];
    }
    if (s.vertex[with] >= 0) s.weight[s.vertex[with]] += work(n);
  }
  return s;
}

// Vertices in the order in which they are assigned to ranks: by connected component, each ordered by its
// first node in the file. Within a component lines are in file order, with a body next to the middle one of
// its lines, so that a cut on either side separates few lines from it.
struct Row {
  std::vector<int> vertices, component;
  std::vector<double> weight;
  std::vector<CutKind> before;
  std::vector<Edge> edges;  // between places in the row, sorted
};

// Index of the component of each vertex.
std::vector<int> components(size_t vertices, const std::vector<Edge>& between) {
  std::vector<int> of(vertices);
  std::iota(of.begin(), of.end(), 0);
  const auto first = [&of](int v) {
    while (of[v] != v) v = of[v] = of[of[v]];
    return v;
  };
  for (const Edge& e : between) of[first(e.from)] = first(e.to);
  for (size_t v = 0; v < vertices; ++v) of[v] = first(static_cast<int>(v));
  return of;
}

// By body: the middle one of the line nodes that edges connect to it, or its own node.
std::vector<int> places_of_bodies(const Mesh& mesh, const std::vector<Edge>& all) {
  const int first = mesh.line_nodes();
  std::vector<std::vector<int>> joined(mesh.nodes.size() - static_cast<size_t>(first));
  for (const Edge& e : all)
    if (e.from >= first && e.to < first) joined[e.from - first].push_back(e.to);
  std::vector<int> out;
  for (std::vector<int>& nodes : joined) {
    std::sort(nodes.begin(), nodes.end());
    out.push_back(nodes.empty() ? first + static_cast<int>(out.size()) : nodes[(nodes.size() - 1) / 2]);
  }
  return out;
}

// True if n is the first node of a line that belongs to the line's rank.
bool begins_line(const Mesh& mesh, int n) {
  if (n >= mesh.line_nodes()) return false;
  const int first = mesh.lines[mesh.nodes[n].line].first_node;
  return n == first || (n == first + 1 && carrier(mesh, first) != first);
}

Row row_of(const Mesh& mesh, const Shares& s, const std::vector<Edge>& all) {
  struct Place {
    int component, node, vertex;
    bool body;
    CutKind before;
  };
  std::vector<Edge> between;
  for (const Edge& e : all) {
    const int a = s.vertex[e.from], b = s.vertex[e.to];
    if (a >= 0 && b >= 0 && a != b) between.push_back({a, b, e.weight});
  }
  const std::vector<int> of = components(s.weight.size(), between), bodies = places_of_bodies(mesh, all);
  std::vector<Place> places;
  std::vector<int> begin(s.weight.size(), static_cast<int>(mesh.nodes.size()));  // first node, by component
  for (size_t v = 0; v < of.size(); ++v) begin[of[v]] = std::min(begin[of[v]], s.at[v]);
  for (int v = 0; v < static_cast<int>(of.size()); ++v) {
    const int n = s.at[v];
    const bool body = n >= mesh.line_nodes();
    places.push_back({begin[of[v]], body ? bodies[n - mesh.line_nodes()] : n, v, body,
                      begins_line(mesh, n) ? CutKind::little : CutKind::much});
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tie(a.component, a.node, a.body, a.vertex) < std::tie(b.component, b.node, b.body, b.vertex);
  });
  Row row;
  std::vector<int> place(s.weight.size());
  for (const Place& p : places) {
    const bool begins = row.component.empty() || row.component.back() != p.component;
    place[p.vertex] = static_cast<int>(row.vertices.size());
    row.vertices.push_back(p.vertex);
    row.component.push_back(p.component);
    row.weight.push_back(static_cast<double>(s.weight[p.vertex]));
    row.before.push_back(begins ? CutKind::nothing : p.before);
  }
  for (Edge& e : between) e = {place[e.from], place[e.to], e.weight};
  row.edges = merged(std::move(between));
  return row;
}

idx_t weight_of_cut(std::span<const Edge> edges, const auto& part) {
  idx_t cut = 0;
  for (const Edge& e : edges)
    if (part(e.from) != part(e.to)) cut += e.weight;
  return cut;
}

// Divides one component, the places [begin, end) of the row, again by METIS into parts of the same weights.
// The new division is used if its cut edges weigh less and no part gets more work than `most`.
void cut_again(const Row& row, int begin, int end, double most, std::vector<double>& load,
               std::vector<int>& part) {
  const int first = part[begin], parts = part[end - 1] - first + 1;
  if (parts < 2 || end - begin <= parts) return;
  const auto place_before = [](const Edge& e, int place) { return e.from < place; };
  const auto from = std::lower_bound(row.edges.begin(), row.edges.end(), begin, place_before);
  const auto to = std::lower_bound(from, row.edges.end(), end, place_before);
  std::vector<Edge> inside;
  for (auto e = from; e != to; ++e) inside.push_back({e->from - begin, e->to - begin, e->weight});
  const std::span weight(row.weight.data() + begin, static_cast<size_t>(end - begin));
  std::vector<double> share(static_cast<size_t>(parts), 0);
  for (int i = begin; i < end; ++i) share[part[i] - first] += row.weight[i];
  if (*std::min_element(share.begin(), share.end()) <= 0) return;
  const std::vector<idx_t> other = cut_into_parts(weight, inside, share);
  if (weight_of_cut(inside, [&](int i) { return other[i]; }) >=
      weight_of_cut(inside, [&](int i) { return part[begin + i]; }))
    return;
  std::vector<double> with(load.begin() + first, load.begin() + first + parts);
  for (int p = 0; p < parts; ++p) with[p] -= share[p];
  for (int i = begin; i < end; ++i) with[other[i - begin]] += row.weight[i];
  if (*std::max_element(with.begin(), with.end()) > most) return;
  std::copy(with.begin(), with.end(), load.begin() + first);
  for (int i = begin; i < end; ++i) part[i] = first + static_cast<int>(other[i - begin]);
}

// Part of each place in the row.
std::vector<int> share_out(const Row& row, int parts) {
  const std::vector<int> first = cut_into_stretches(row.weight, row.before, parts, kMostLoad);
  const int places = static_cast<int>(row.vertices.size());
  std::vector<int> part(row.vertices.size(), 0);
  std::vector<double> load(static_cast<size_t>(parts), 0);
  for (int p = 0; p < parts; ++p)
    for (int i = first[p]; i < first[p + 1]; ++i) {
      part[i] = p;
      load[p] += row.weight[i];
    }
  const double mean = std::accumulate(load.begin(), load.end(), 0.0) / parts;
  const double most = std::max(*std::max_element(load.begin(), load.end()), kMostLoad * mean);
  for (int begin = 0, end = 0; begin < places; begin = end) {
    while (end < places && row.component[end] == row.component[begin]) ++end;
    cut_again(row, begin, end, most, load, part);
  }
  return part;
}

std::vector<int> owners(const Mesh& mesh, int ranks, std::span<const int> whole,
                        const std::vector<Edge>& all) {
  const Shares s = share_lines(mesh, ranks, whole);
  const Row row = row_of(mesh, s, all);
  const std::vector<int> part = share_out(row, ranks - s.first);
  std::vector<int> of_vertex(s.weight.size());
  for (size_t i = 0; i < part.size(); ++i) of_vertex[row.vertices[i]] = s.first + part[i];
  std::vector<int> owner = s.owner;
  for (size_t n = 0; n < owner.size(); ++n)
    if (owner[n] < 0) owner[n] = of_vertex[s.vertex[n]];
  for (size_t n = 0; n < owner.size(); ++n) owner[n] = owner[carrier(mesh, static_cast<int>(n))];
  return owner;
}

// Number of ghost nodes over all ranks.
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
  std::vector<int> plain = owners(mesh, ranks, whole, edges(mesh, {}));
  if (coupled.empty()) return plain;
  // METIS minimises cut edges; the cost is that of the nodes at them.
  const std::vector<Edge> all = edges(mesh, coupled);
  std::vector<int> weighed = owners(mesh, ranks, whole, all);
  return shared_nodes(all, weighed) < shared_nodes(all, plain) ? weighed : plain;
}

Balance balance(const Mesh& mesh, const std::vector<int>& owner, int ranks) {
  Balance out;
  std::vector<double> load(static_cast<size_t>(ranks), 0);
  for (size_t n = 0; n < mesh.nodes.size(); ++n)
    load[owner[n]] += static_cast<double>(work_of(mesh.nodes[n]));
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
