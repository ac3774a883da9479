// Angle-weighted pseudonormals of a closed oriented mesh (Bærentzen & Aanæs 2005) with flat or curved facets;
// near a point of a curved surface only its tangent planes matter.
#pragma once

#include <algorithm>
#include <vector>

#include "facets.hpp"

namespace hawser::detail {

class Pseudonormals {
 public:
  Pseudonormals() = default;
  Pseudonormals(const Facets& facets, const Topology& topo);

  // Unit normal of a face; zero without area. Not stored: a search has just read the corners, and stored
  // normals would add a sixth to the memory of a curved mesh.
  static Vec3 face(const Facets& facets, int t) {
    return triangle_normal(facets.corner(t, 0), facets.corner(t, 1), facets.corner(t, 2));
  }
  // face() of a well-shaped facet by a fast formula, accurate to 1e-12.
  static Vec3 quick_face(const Facets& facets, int t) {
    const Vec3 n = quick_area(facets, t);
    return n.isZero(0) ? face(facets, t) : Vec3(n / n.norm());
  }
  // True if face() is not zero.
  static bool has_area(const Facets& facets, int t) {
    return !quick_area(facets, t).isZero(0) || !face(facets, t).isZero(0);
  }
  int neighbour(int t, int edge) const {
    return neighbours_[static_cast<std::size_t>(t)][static_cast<std::size_t>(edge)];
  }
  // Pseudonormal at p on facet t, not a unit vector; zero where it would not determine the sign: at
  // non-manifold edges and vertices, next to triangles without area, and where two faces are folded onto each
  // other.
  Vec3 at(const Facets& facets, int t, const PatchPoint& p) const;
  // True if all pseudonormals at the vertices and edges of facets with area are defined.
  bool complete() const { return complete_; }
  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.array(self.vertex_);
    p.array(self.neighbours_);
    p.value(self.complete_);
  }

 private:
  // Area vector times two of a well-shaped facet; else zero.
  static Vec3 quick_area(const Facets& facets, int t) {
    const Vec3& a = facets.corner(t, 0);
    const Vec3 e = facets.corner(t, 1) - a;
    const Vec3 f = facets.corner(t, 2) - a;
    const Vec3 n = e.cross(f);
    const double longest2 = std::max(e.squaredNorm(), f.squaredNorm());
    return n.squaredNorm() > 1e-8 * longest2 * longest2 ? n : Vec3(Vec3::Zero());
  }

  ConstArray<Vec3> vertex_;
  ConstArray<std::array<int, 3>> neighbours_;
  bool complete_ = true;
};

}  // namespace hawser::detail
