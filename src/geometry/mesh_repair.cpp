// Orientation of the patches of a faulty mesh: consistent within a patch, with its front towards the outside.
#include "hawser/geometry/mesh_repair.hpp"

#include <numeric>
#include <utility>

#include "hawser/geometry/winding_tree.hpp"
#include "nesting.hpp"
#include "patch_visibility.hpp"

namespace hawser {
namespace {

void flip(std::array<int, 3>& t) { std::swap(t[1], t[2]); }

}  // namespace

RepairResult repair(TriangleMesh& mesh) {
  RepairResult out;
  if (mesh.triangles.empty()) return out;
  const Topology topo = topology(mesh);
  const WindingTree tree(mesh);
  std::vector<signed char> turn(mesh.triangles.size(), -1);
  std::vector<int> patch;
  for (int first = 0; first < static_cast<int>(turn.size()); ++first) {
    if (turn[static_cast<std::size_t>(first)] >= 0) continue;
    const bool two_sided = detail::grow_patch(mesh, topo, first, turn, patch);
    if (!two_sided) {
      ++out.one_sided;
      for (const int t : patch) turn[static_cast<std::size_t>(t)] = 0;
      continue;
    }
    long many = 0;
    for (const int t : patch) many += turn[static_cast<std::size_t>(t)];
    bool all = 2 * many > static_cast<long>(patch.size());
    const auto turn_all = [&] {
      for (const int t : patch) turn[static_cast<std::size_t>(t)] ^= 1;
    };
    if (all) turn_all();
    for (const int t : patch)
      if (turn[static_cast<std::size_t>(t)]) flip(mesh.triangles[static_cast<std::size_t>(t)]);
    if (detail::front_faces_inside(mesh, tree, patch)) {
      for (const int t : patch) flip(mesh.triangles[static_cast<std::size_t>(t)]);
      turn_all();
    }
    for (const int t : patch) out.turned += turn[static_cast<std::size_t>(t)];
  }
  const Topology now = topology(mesh);
  out.closed = now.odd_edges == 0 && now.flipped_edges == 0;
  // The triangles have been turned, so the tree is built again.
  const WindingTree turned(mesh);
  std::vector<int> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  out.enclosing = detail::enclosing(mesh, turned, all);
  return out;
}

}  // namespace hawser
