// Construction of a rank's part of the mesh: block numbers over all ranks, ghost nodes of its elements,
// shared positions at joints, and further ghosts for couplings.
#include "hawser/mesh/local_mesh.hpp"

#include <algorithm>
#include <span>

#include "node_runs.hpp"

namespace hawser {
namespace {

// Adds local blocks of a node whose first block in the parallel numbering is `first`.
int add_blocks(LocalMesh& l, int first, int width) {
  const int at = l.blocks();
  for (int k = 0; k < width; ++k) l.global_block.push_back(first + k);
  return at;
}

// A node that shares another's position uses its block; if that node is not local, the block already added
// for the same joint.
void pin(LocalMesh& l, int local) {
  const int other = l.node(local).pinned_to;
  if (other < 0) return;
  int& block = l.block[local];
  if (const int local_node = l.find(other); local_node >= 0) {
    block = l.block[local_node];
    return;
  }
  const int first = l.first_block(other);
  const auto known = std::find(l.global_block.begin(), l.global_block.end(), first);
  block = known != l.global_block.end() ? static_cast<int>(known - l.global_block.begin())
                                        : add_blocks(l, first, 1);
}

int width_of(const Node& n) { return n.pinned_to >= 0 ? 0 : n.rotates ? 2 : 1; }

// Runs of blocks. Parallel numbering: rank by rank, in file order within a rank.
std::vector<BlockRun> block_runs(const Mesh& mesh, const NodeRanks& owner, int ranks) {
  std::vector<BlockRun> runs;
  std::vector<int> rank_of;
  std::vector<int> count(static_cast<size_t>(ranks) + 1, 0);
  const std::span<const NodeRanks::Run> owners = owner.runs();
  for (const NodeRun& nodes : node_runs(mesh)) {
    const int width = nodes.special ? width_of(*nodes.special) : nodes.rotates ? 2 : 1;
    const int end = nodes.first + nodes.nodes;
    for (size_t r = owner.run_of(nodes.first); r < owners.size() && owners[r].first < end; ++r) {
      const int from = std::max(nodes.first, owners[r].first);
      const int rank = owners[r].rank;
      if (runs.empty() || rank_of.back() != rank || runs.back().width != width || width == 0) {
        runs.push_back({from, count[rank + 1], width});
        rank_of.push_back(rank);
      }
      count[rank + 1] += width * (std::min(end, owner.end(r)) - from);
    }
  }
  for (size_t r = 0; r < static_cast<size_t>(ranks); ++r) count[r + 1] += count[r];
  for (size_t i = 0; i < runs.size(); ++i) runs[i].block += count[rank_of[i]];
  runs.shrink_to_fit();
  return runs;
}

// Numbers of the local elements in the mesh, ascending: those of owned nodes [0, owned) of a line or more.
std::vector<int> local_elements(const Mesh& mesh, const NodeRanks& owner, int rank) {
  std::vector<int> out;
  for (const EvenPart& part : mesh.parts()) {
    const int last_node = part.first_node + part.elements;
    int last = -1;  // element of `out`, in the part
    for (size_t r = owner.run_of(part.first_node);
         r < owner.runs().size() && owner.runs()[r].first <= last_node; ++r) {
      if (owner.runs()[r].rank != rank) continue;
      const int from = std::max(owner.runs()[r].first - part.first_node - 1, last + 1);
      const int to = std::min(owner.end(r) - part.first_node, part.elements);
      for (int k = std::max(from, 0); k < to; ++k) out.push_back(part.first_element + (last = k));
    }
  }
  return out;
}

}  // namespace

int LocalMesh::first_block(int node) const {
  const BlockRun& run = *last_not_after(block_runs, node, &BlockRun::first_node);
  if (run.width == 0) return first_block(mesh->node(node).pinned_to);
  return run.block + run.width * (node - run.first_node);
}

void LocalMesh::copy_local() {
  node_copies.clear();
  node_copies.reserve(global.size());
  for (const int n : global) node_copies.push_back(mesh->node(n));
  element_copies.clear();
  element_copies.reserve(elements.size());
  for (LocalElement& e : elements) {
    e.copy = static_cast<int>(element_copies.size());
    element_copies.push_back(mesh->element(e.global));
  }
}

LocalMesh local_mesh(const Mesh& mesh, const NodeRanks& owner, int rank, int ranks) {
  LocalMesh l;
  l.mesh = &mesh;
  l.owner = owner;
  l.block_runs = block_runs(mesh, owner, ranks);
  for (size_t r = 0; r < owner.runs().size(); ++r)
    if (owner.runs()[r].rank == rank)
      for (int n = owner.runs()[r].first; n < owner.end(r); ++n) l.global.push_back(n);
  l.owned = static_cast<int>(l.global.size());
  const std::vector<int> elements = local_elements(mesh, owner, rank);
  std::vector<int> ghosts;
  for (const int i : elements) {
    const Element e = mesh.element(i);
    const bool a = owner[e.first] == rank;
    const bool b = owner[e.second] == rank;
    if (a == b) continue;
    ghosts.push_back(a ? e.second : e.first);
    for (const int n : {e.first, e.second})  // and the frames that carry them
      if (const int frame = mesh.node(n).tied_to; frame >= 0 && owner[frame] != rank) ghosts.push_back(frame);
  }
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  l.global.insert(l.global.end(), ghosts.begin(), ghosts.end());
  l.element_ghosts_end = l.nodes();
  for (const int i : elements) {
    const Element e = mesh.element(i);
    l.elements.push_back({l.find(e.first), l.find(e.second), i, owner[e.first] == rank});
  }
  l.copy_local();
  for (int i = 0; i < l.nodes(); ++i) {
    l.block.push_back(add_blocks(l, l.first_block(l.global[i]), width_of(l.node(i))));
    if (i + 1 == l.owned) l.owned_blocks = l.blocks();
  }
  for (int n = 0; n < l.nodes(); ++n) pin(l, n);
  l.element_ghost_blocks_end = l.blocks();
  for (auto* kept : {&l.global, &l.block, &l.global_block}) kept->shrink_to_fit();
  l.elements.shrink_to_fit();
  return l;
}

void set_coupling_ghosts(LocalMesh& l, std::span<const int> nodes) {
  const size_t element_ghosts_end = l.element_ghosts_end;
  if (l.element_ghost_blocks_end > 0) l.global_block.resize(l.element_ghost_blocks_end);
  l.global.resize(element_ghosts_end);
  l.block.resize(element_ghosts_end);
  l.node_copies.resize(element_ghosts_end);
  std::vector<int> more;
  for (int n : nodes)
    if (l.find(n) < 0) more.push_back(n);
  for (int n : more) {
    l.global.push_back(n);
    l.node_copies.push_back(l.mesh->node(n));
    l.block.push_back(add_blocks(l, l.first_block(n), width_of(l.node_copies.back())));
  }
  for (int n = l.element_ghosts_end; n < l.nodes(); ++n) pin(l, n);
}

LineOwners line_owners(const LocalMesh& mesh) {
  LineOwners out;
  const std::vector<LineSpan>& lines = mesh.mesh->lines;
  for (size_t l = 0; l < lines.size(); ++l) {
    const int line = static_cast<int>(l);
    const int first = lines[l].first_node;
    const int end = first + lines[l].nodes;
    const bool cut = !mesh.owner.whole(first, lines[l].nodes);
    const auto owned_end = mesh.global.begin() + mesh.owned;
    const auto owned = std::lower_bound(mesh.global.begin(), owned_end, first);
    const bool local = owned != owned_end && *owned < end;
    if (cut) out.cut.push_back(line);
    if (local) out.local.push_back(line);
    if (local && !cut) out.uncut.push_back(line);
  }
  return out;
}

bool owns_line(const LocalMesh& mesh, int line) { return mesh.owns_node(mesh.mesh->lines[line].first_node); }

}  // namespace hawser
