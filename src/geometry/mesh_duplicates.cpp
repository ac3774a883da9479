// Selection of the duplicate triangles that belong to the surface of a mesh, by the volume their patches
// enclose, and detection of flat pieces.
#include "hawser/geometry/mesh_duplicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "hawser/geometry/mesh_repair.hpp"
#include "hawser/geometry/winding_tree.hpp"
#include "hawser/math/disjoint_sets.hpp"
#include "hawser/math/ordered.hpp"
#include "patch_visibility.hpp"

namespace hawser {
namespace {

// 1 if the corners are an even permutation of their order by index, -1 if odd.
int parity(const std::array<int, 3>& t) {
  int s = 1;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i + 1; j < 3; ++j)
      if (t[i] > t[j]) s = -s;
  return s;
}

// All triangles with the same corners.
struct Face {
  std::size_t first, kept_triangle;  // first triangle, and the one that is kept if one is
  int copies;
  int patch = -1;  // for an even number of copies
  bool open() const { return copies % 2 == 0; }
};

std::vector<Face> faces_of(const TriangleMesh& mesh) {
  std::vector<std::pair<std::array<int, 3>, std::size_t>> sorted(mesh.triangles.size());
  for (std::size_t t = 0; t < sorted.size(); ++t) {
    sorted[t] = {mesh.triangles[t], t};
    std::sort(sorted[t].first.begin(), sorted[t].first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Face> faces;
  for (std::size_t i = 0, j = 0; i < sorted.size(); i = j) {
    int balance = 0;
    for (j = i; j < sorted.size() && sorted[j].first == sorted[i].first; ++j)
      balance += parity(mesh.triangles[sorted[j].second]);
    std::size_t k = i;
    while (balance != 0 && (parity(mesh.triangles[sorted[k].second]) > 0) != (balance > 0)) ++k;
    faces.push_back({sorted[i].second, sorted[k].second, static_cast<int>(j - i)});
  }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.first < b.first; });
  return faces;
}

// Mesh with one triangle for each face that belongs to no patch or to a kept one.
TriangleMesh once(const TriangleMesh& mesh, const std::vector<Face>& faces, const std::vector<bool>& kept) {
  TriangleMesh out;
  out.vertices = mesh.vertices;
  out.parts = mesh.parts;
  const bool parts = mesh.part.size() == mesh.triangles.size();
  for (const Face& f : faces) {
    if (f.patch >= 0 && !kept[static_cast<std::size_t>(f.patch)]) continue;
    out.triangles.push_back(mesh.triangles[f.kept_triangle]);
    if (parts) out.part.push_back(mesh.part[f.kept_triangle]);
  }
  return out;
}

// Edge at which patches may end.
struct Rim {
  double length;                             // m
  int fixed_faces = 0;                       // faces that stay in any case
  std::vector<std::pair<int, int>> patches;  // patches, and the number of their faces at the edge
};

class Patches {
 public:
  Patches(const TriangleMesh& mesh, std::vector<Face>& faces) : mesh_(mesh), faces_(faces) {
    const TriangleMesh all = once(mesh, faces, {});
    find(topology(all));
    find_rims();
  }
  // Patches that are kept, with one copy.
  std::vector<bool> kept() {
    std::vector<bool> kept(count_, true);
    while (drop_false_boundaries(kept)) {
    }
    return kept;
  }

 private:
  // topo: of the mesh whose triangles are the faces.
  void find(const Topology& topo) {
    DisjointSets group(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (const int other : topo.neighbours[f])
        if (other >= 0 && faces_[f].open() && faces_[static_cast<std::size_t>(other)].open())
          group.unite(static_cast<int>(f), other);
    int count = 0;
    const auto open = [&](int f) { return faces_[static_cast<std::size_t>(f)].open(); };
    const std::vector<int> number = group.numbered(open, count);
    for (std::size_t f = 0; f < faces_.size(); ++f) faces_[f].patch = number[f];
    count_ = static_cast<std::size_t>(count);
  }
  void find_rims() {
    struct Use {
      int a, b, patch;
    };
    std::vector<Use> uses;
    uses.reserve(3 * faces_.size());
    for (const Face& f : faces_)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] =
            ordered(mesh_.triangles[f.kept_triangle][i], mesh_.triangles[f.kept_triangle][(i + 1) % 3]);
        uses.push_back({a, b, f.patch});
      }
    std::sort(uses.begin(), uses.end(), [](const Use& x, const Use& y) {
      return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.patch < y.patch;
    });
    rims_of_patch_.resize(count_);
    for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
      const auto end = [&](std::size_t k) { return static_cast<std::size_t>(uses[k].a); };
      Rim r{(mesh_.vertices[end(i)] - mesh_.vertices[static_cast<std::size_t>(uses[i].b)]).norm(), 0, {}};
      for (j = i; j < uses.size() && uses[j].a == uses[i].a && uses[j].b == uses[i].b; ++j) {
        if (uses[j].patch < 0)
          ++r.fixed_faces;
        else if (!r.patches.empty() && r.patches.back().first == uses[j].patch)
          ++r.patches.back().second;
        else
          r.patches.emplace_back(uses[j].patch, 1);
      }
      for (const auto& [p, n] : r.patches)
        if (n % 2 == 1) rims_of_patch_[static_cast<std::size_t>(p)].push_back(rims_.size());
      rims_.push_back(std::move(r));
    }
  }

  // Length of a patch's rim where the other faces end (needed), and where they continue without it
  // (superfluous); without other faces neither counts.
  struct RimLength {
    double needed = 0, superfluous = 0;
  };
  RimLength rim_length(std::size_t patch, const std::vector<bool>& kept) const {
    RimLength length;
    for (const std::size_t r : rims_of_patch_[patch]) {
      int others = rims_[r].fixed_faces;
      for (const auto& [p, n] : rims_[r].patches)
        if (static_cast<std::size_t>(p) != patch && kept[static_cast<std::size_t>(p)]) others += n;
      if (others > 0) (others % 2 == 1 ? length.needed : length.superfluous) += rims_[r].length;
    }
    return length;
  }

  // Patches that are not required or not connected are tested for the boundary of the body. Where three
  // duplicated sheets meet, it ends at two of them and not at the wall between. A wall in an open hull may
  // look like an end of the body to the winding number, but both its sides have equal visibility.
  bool drop_false_boundaries(std::vector<bool>& kept) const {
    constexpr double kAttached = 0.25, kLone = 0.02, kOneSided = 0.25;
    std::vector<std::pair<std::size_t, bool>> candidates;  // and whether the rest touches it
    for (std::size_t p = 0; p < count_; ++p) {
      if (!kept[p] || rims_of_patch_[p].empty()) continue;
      const RimLength rim = rim_length(p, kept);
      if (rim.superfluous > rim.needed || rim.needed == 0) candidates.emplace_back(p, rim.superfluous > 0);
    }
    if (candidates.empty()) return false;
    TriangleMesh all = once(mesh_, faces_, kept);
    std::vector<std::vector<int>> triangles(count_);
    int t = 0;
    for (const Face& f : faces_)
      if (f.patch < 0)
        ++t;
      else if (kept[static_cast<std::size_t>(f.patch)])
        triangles[static_cast<std::size_t>(f.patch)].push_back(t++);
    repair(all);
    const WindingTree tree(all);
    bool dropped = false;
    for (const auto& [p, attached] : candidates) {
      const auto& patch_triangles = triangles[p];
      if (detail::enclosing(all, tree, patch_triangles, attached ? kAttached : kLone) >= 0.5 &&
          (!attached || detail::one_sided_visibility(all, tree, patch_triangles) > kOneSided))
        continue;
      kept[p] = false;
      dropped = true;
    }
    return dropped;
  }

  const TriangleMesh& mesh_;
  std::vector<Face>& faces_;
  std::size_t count_ = 0;
  std::vector<Rim> rims_;
  std::vector<std::vector<std::size_t>> rims_of_patch_;  // by patch: rims with an odd number of its faces
};

}  // namespace

DuplicateResult drop_duplicates(TriangleMesh& mesh) {
  DuplicateResult out;
  std::vector<Face> faces = faces_of(mesh);
  if (faces.size() == mesh.triangles.size()) return out;
  const std::vector<bool> kept = Patches(mesh, faces).kept();
  for (const Face& f : faces)
    if (f.patch >= 0 && !kept[static_cast<std::size_t>(f.patch)])
      out.back_to_back += f.copies;
    else
      out.copies += f.copies - 1;
  mesh = once(mesh, faces, kept);
  return out;
}

int drop_flat_pieces(TriangleMesh& mesh, double thickness) {
  const Topology topo = topology(mesh);
  const auto n = static_cast<std::size_t>(topo.components);
  const MeshView view(mesh);
  const auto piece = [&](std::size_t t) { return static_cast<std::size_t>(topo.component[t]); };
  std::vector<bool> drop(n, true);
  std::vector<Vec3> normal(n, Vec3::Zero());
  std::vector<Vec3> at(n);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 a = view.area_vector(t);
    if (a.squaredNorm() > normal[piece(t)].squaredNorm()) {
      normal[piece(t)] = a;
      at[piece(t)] = view.corner(t, 0);
    }
    for (const int other : topo.neighbours[t])
      if (other == kOpenEdge) drop[piece(t)] = false;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (std::abs(normal[piece(t)].normalized().dot(view.corner(t, i) - at[piece(t)])) > thickness)
        drop[piece(t)] = false;
  const int pieces = static_cast<int>(std::count(drop.begin(), drop.end(), true));
  if (pieces == 0) return 0;
  mesh.keep_triangles([&](std::array<int, 3>&, std::size_t t) { return !drop[piece(t)]; });
  return pieces;
}

}  // namespace hawser
