// Construction of a rank's part of the mesh: block numbers over all ranks, ghost nodes of its elements,
// shared positions at joints, and further ghosts for couplings.
#include "hawser/mesh/local_mesh.hpp"

#include <algorithm>
#include <unordered_map>

#include "hawser/mesh/partition.hpp"

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
  const int g = l.global[local], other = l.mesh->nodes[g].pinned_to;
  if (other < 0) return;
  int& block = l.block[local];
  const int first = l.first_block[g];
  if (const int here = l.find(other); here >= 0) {
    block = l.block[here];
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
  for (size_t n = 0; n < owner.size(); ++n) count[owner[n] + 1] += width(n);
  for (size_t r = 0; r < static_cast<size_t>(ranks); ++r) count[r + 1] += count[r];
  std::vector<int> first_block(owner.size());
  for (size_t n = 0; n < owner.size(); ++n) {
    int& next = count[owner[n]];
    first_block[n] = next;
    next += width(n);
  }
  for (size_t n = 0; n < owner.size(); ++n)
    if (const int other = mesh.nodes[n].pinned_to; other >= 0) first_block[n] = first_block[other];

  std::vector<int> ghosts;
  for (size_t n = 0; n < owner.size(); ++n)
    if (owner[n] == rank) l.global.push_back(static_cast<int>(n));
  l.owned = static_cast<int>(l.global.size());
  for (const Element& e : mesh.elements) {
    const bool a = owner[e.first] == rank, b = owner[e.second] == rank;
    if (a && !b) ghosts.push_back(e.second);
    if (b && !a) ghosts.push_back(e.first);
    if (a == b) continue;
    for (const int n : {e.first, e.second})  // and the frames that carry them
      if (const int frame = mesh.nodes[n].tied_to; frame >= 0 && owner[frame] != rank)
        ghosts.push_back(frame);
  }
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  l.global.insert(l.global.end(), ghosts.begin(), ghosts.end());

  std::unordered_map<int, int> local;
  for (int i = 0; i < l.nodes(); ++i) {
    const size_t n = l.global[i];
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
    const bool a = owner[e.first] == rank, b = owner[e.second] == rank;
    if (a || b) l.elements.push_back({local.at(e.first), local.at(e.second), static_cast<int>(i), a});
  }
  for (auto* kept : {&l.global, &l.block, &l.global_block}) kept->shrink_to_fit();
  l.elements.shrink_to_fit();
  return l;
}

void set_coupling_ghosts(LocalMesh& l, std::span<const int> nodes) {
  const size_t chain = l.chain;
  if (l.chain_blocks > 0) l.global_block.resize(l.chain_blocks);
  l.global.resize(chain);
  l.block.resize(chain);
  std::vector<int> more;
  for (int n : nodes)
    if (l.find(n) < 0) more.push_back(n);
  for (int n : more) {
    const Node& node = l.mesh->nodes[n];
    l.global.push_back(n);
    const int width = node.pinned_to >= 0 ? 0 : node.rotates ? 2 : 1;
    l.block.push_back(add_blocks(l, l.first_block[n], width));
  }
  for (int n = l.chain; n < l.nodes(); ++n) pin(l, n);
}

LineOwners line_owners(const LocalMesh& mesh) {
  LineOwners out;
  const std::vector<LineSpan>& lines = mesh.mesh->lines;
  for (size_t l = 0; l < lines.size(); ++l) {
    const auto first = mesh.owner.begin() + lines[l].first_node, last = first + lines[l].nodes;
    if (std::any_of(first, last, [&](int rank) { return rank != *first; }))
      out.cut.push_back(static_cast<int>(l));
    else if (owns_line(mesh, static_cast<int>(l)))
      out.uncut.push_back(static_cast<int>(l));
  }
  return out;
}

bool owns_line(const LocalMesh& mesh, int line) { return mesh.owns_node(mesh.mesh->lines[line].first_node); }

}  // namespace hawser
