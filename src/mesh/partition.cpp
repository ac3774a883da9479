#include "hawser/mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace hawser {
namespace {

// Relative cost of a node in an implicit step (docs/performance.md): kernels, assembly and factorisation.
constexpr idx_t kBeamWork = 5, kCableWork = 1;
// What is cut with an edge: a chain, or one of the four edges of two elements that are near, of which a node
// has several.
constexpr idx_t kChainEdge = 100, kNearEdge = 10;

struct Edge {
  int from, to;
  idx_t weight;
};

// Both ways, sorted, edges between the same nodes as one.
std::vector<Edge> edges(const Mesh& mesh, std::span<const std::pair<int, int>> near) {
  std::vector<Edge> all;
  const auto add = [&](int a, int b, idx_t w) {
    if (a != b) all.push_back({a, b, w}), all.push_back({b, a, w});
  };
  for (const Element& e : mesh.elements) add(e.first, e.second, kChainEdge);
  for (size_t n = 0; n < mesh.nodes.size(); ++n)
    for (const int other : {mesh.nodes[n].pinned_to, mesh.nodes[n].tied_to})
      if (other >= 0) add(static_cast<int>(n), other, kChainEdge);
  for (const auto& [a, b] : near) {
    const Element &p = mesh.elements[static_cast<size_t>(a)], &q = mesh.elements[static_cast<size_t>(b)];
    for (int m : {p.first, p.second})
      for (int n : {q.first, q.second}) add(m, n, kNearEdge);
  }
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

}  // namespace

namespace {

std::vector<int> cut_graph(const Mesh& mesh, int ranks, const std::vector<Edge>& all) {
  std::vector<idx_t> start, next, edge, weight;
  for (const Node& n : mesh.nodes) weight.push_back(n.rotates ? kBeamWork : kCableWork);
  start.assign(weight.size(), 0);
  start.push_back(0);
  for (const Edge& e : all) {
    ++start[static_cast<size_t>(e.from) + 1];
    next.push_back(e.to), edge.push_back(e.weight);
  }
  for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  idx_t vertices = static_cast<idx_t>(weight.size()), constraints = 1, parts = ranks, cut = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // every rank computes the same cut
  std::vector<idx_t> part = weight;
  const int status =
      METIS_PartGraphRecursive(&vertices, &constraints, start.data(), next.data(), weight.data(), nullptr,
                               edge.data(), &parts, nullptr, nullptr, options, &cut, part.data());
  if (status != METIS_OK) throw std::runtime_error("METIS could not cut the lines into parts");
  std::vector<int> owner(part.begin(), part.end());
  for (size_t n = 0; n < owner.size(); ++n)  // one position has one owner
    for (const int other : {mesh.nodes[n].pinned_to, mesh.nodes[n].tied_to})
      if (other >= 0) owner[n] = owner[static_cast<size_t>(other)];
  return owner;
}

// Nodes that other ranks see, once for each rank that does.
size_t shared_nodes(const std::vector<Edge>& all, const std::vector<int>& owner) {
  std::vector<std::pair<int, int>> seen;
  for (const Edge& e : all)
    if (const int rank = owner[static_cast<size_t>(e.to)]; rank != owner[static_cast<size_t>(e.from)])
      seen.emplace_back(e.from, rank);
  std::sort(seen.begin(), seen.end());
  return static_cast<size_t>(std::unique(seen.begin(), seen.end()) - seen.begin());
}

}  // namespace

std::vector<int> partition(const Mesh& mesh, int ranks, std::span<const std::pair<int, int>> near) {
  if (ranks == 1) return std::vector<int>(mesh.nodes.size(), 0);
  std::vector<int> plain = cut_graph(mesh, ranks, edges(mesh, {}));
  if (near.empty()) return plain;
  // METIS looks for few cut edges; what costs is the nodes at them. A coil is better cut across its line.
  const std::vector<Edge> all = edges(mesh, near);
  std::vector<int> weighed = cut_graph(mesh, ranks, all);
  return shared_nodes(all, weighed) < shared_nodes(all, plain) ? weighed : plain;
}

namespace {

// Local blocks of a node whose first one of the parallel numbering is `first`.
int add_blocks(LocalMesh& l, int first, int width) {
  const int at = l.blocks();
  for (int k = 0; k < width; ++k) l.global_block.push_back(first + k);
  return at;
}

// The block of a node that has another's position is that one's, or where that is no local node the one that
// has come for the same joint already.
void pin(LocalMesh& l, int local) {
  const int g = l.global[static_cast<size_t>(local)], other = l.mesh->nodes[static_cast<size_t>(g)].pinned_to;
  if (other < 0) return;
  int& block = l.block[static_cast<size_t>(local)];
  const int first = l.first_block[static_cast<size_t>(g)];
  if (const int here = l.find(other); here >= 0) {
    block = l.block[static_cast<size_t>(here)];
    return;
  }
  const auto known = std::find(l.global_block.begin(), l.global_block.end(), first);
  block = known != l.global_block.end() ? static_cast<int>(known - l.global_block.begin())
                                        : add_blocks(l, first, 1);
}

}  // namespace

LocalMesh local_mesh(const Mesh& mesh, const std::vector<int>& owner, int rank, int ranks) {
  LocalMesh l;
  l.mesh = &mesh;
  // Parallel numbering: rank by rank, in file order within a rank.
  std::vector<int> count(static_cast<size_t>(ranks) + 1, 0);
  auto width = [&](size_t n) { return mesh.nodes[n].pinned_to >= 0 ? 0 : mesh.nodes[n].rotates ? 2 : 1; };
  for (size_t n = 0; n < owner.size(); ++n) count[static_cast<size_t>(owner[n]) + 1] += width(n);
  for (size_t r = 0; r < static_cast<size_t>(ranks); ++r) count[r + 1] += count[r];
  std::vector<int> first_block(owner.size());
  for (size_t n = 0; n < owner.size(); ++n) {
    int& next = count[static_cast<size_t>(owner[n])];
    first_block[n] = next;
    next += width(n);
  }
  for (size_t n = 0; n < owner.size(); ++n)
    if (const int other = mesh.nodes[n].pinned_to; other >= 0)
      first_block[n] = first_block[static_cast<size_t>(other)];

  std::vector<int> ghosts;
  for (size_t n = 0; n < owner.size(); ++n)
    if (owner[n] == rank) l.global.push_back(static_cast<int>(n));
  l.owned = static_cast<int>(l.global.size());
  for (const Element& e : mesh.elements) {
    const bool a = owner[static_cast<size_t>(e.first)] == rank,
               b = owner[static_cast<size_t>(e.second)] == rank;
    if (a && !b) ghosts.push_back(e.second);
    if (b && !a) ghosts.push_back(e.first);
    if (a == b) continue;
    for (const int n : {e.first, e.second})  // with the frames that carry them
      if (const int frame = mesh.nodes[static_cast<size_t>(n)].tied_to;
          frame >= 0 && owner[static_cast<size_t>(frame)] != rank)
        ghosts.push_back(frame);
  }
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  l.global.insert(l.global.end(), ghosts.begin(), ghosts.end());

  std::unordered_map<int, int> local;
  for (int i = 0; i < l.nodes(); ++i) {
    const size_t n = static_cast<size_t>(l.global[static_cast<size_t>(i)]);
    local[static_cast<int>(n)] = i;
    l.block.push_back(add_blocks(l, first_block[n], width(n)));
    if (i + 1 == l.owned) l.owned_blocks = l.blocks();
  }
  l.chain = l.nodes();
  l.owner = owner;
  l.first_block = std::move(first_block);
  for (int n = 0; n < l.nodes(); ++n) pin(l, n);
  l.chain_blocks = l.blocks();
  for (size_t i = 0; i < mesh.elements.size(); ++i) {
    const Element& e = mesh.elements[i];
    const bool a = owner[static_cast<size_t>(e.first)] == rank,
               b = owner[static_cast<size_t>(e.second)] == rank;
    if (a || b) l.elements.push_back({local.at(e.first), local.at(e.second), static_cast<int>(i), a});
  }
  return l;
}

void set_coupling_ghosts(LocalMesh& l, std::span<const int> nodes) {
  const size_t chain = static_cast<size_t>(l.chain);
  if (l.chain_blocks > 0) l.global_block.resize(static_cast<size_t>(l.chain_blocks));
  l.global.resize(chain), l.block.resize(chain);
  std::vector<int> more;
  for (int n : nodes)
    if (l.find(n) < 0) more.push_back(n);
  for (int n : more) {
    const Node& node = l.mesh->nodes[static_cast<size_t>(n)];
    l.global.push_back(n);
    const int width = node.pinned_to >= 0 ? 0 : node.rotates ? 2 : 1;
    l.block.push_back(add_blocks(l, l.first_block[static_cast<size_t>(n)], width));
  }
  for (int n = l.chain; n < l.nodes(); ++n) pin(l, n);
}

int cut_elements(const Mesh& mesh, const std::vector<int>& owner) {
  return static_cast<int>(std::count_if(mesh.elements.begin(), mesh.elements.end(), [&](const Element& e) {
    return owner[static_cast<size_t>(e.first)] != owner[static_cast<size_t>(e.second)];
  }));
}

}  // namespace hawser
