// Angle-weighted pseudonormals of a closed oriented mesh (Bærentzen & Aanæs 2005), its facets flat or curved:
// near a point of a curved surface only its tangent planes count.
#pragma once

#include <vector>

#include "facets.hpp"

namespace hawser::detail {

class Pseudonormals {
 public:
  Pseudonormals() = default;
  Pseudonormals(const Facets& facets, const Topology& topo);

  const Vec3& face(int t) const { return face_[static_cast<std::size_t>(t)]; }  // unit; zero if no area
  int neighbour(int t, int edge) const {
    return neighbours_[static_cast<std::size_t>(t)][static_cast<std::size_t>(edge)];
  }
  // At p on facet t. Not unit; zero where it would not give the sign: non-manifold edges and vertices, beside
  // triangles of no area, and where two faces are folded onto each other.
  Vec3 at(const Facets& facets, int t, const PatchPoint& p) const;
  // Whether all are defined at the vertices and edges of facets with area.
  bool complete() const { return complete_; }
  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.array(self.face_), p.array(self.vertex_), p.array(self.neighbours_);
    p.value(self.complete_);
  }
  std::size_t memory() const;

 private:
  LargeVector<Vec3> face_, vertex_;
  LargeVector<std::array<int, 3>> neighbours_;
  bool complete_ = true;
};

}  // namespace hawser::detail
