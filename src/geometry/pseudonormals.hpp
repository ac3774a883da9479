// Angle-weighted pseudonormals of a closed oriented mesh (Bærentzen & Aanæs 2005).
#pragma once

#include <vector>

#include "hawser/geometry/closest_point.hpp"
#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

class Pseudonormals {
 public:
  Pseudonormals() = default;
  Pseudonormals(const TriangleMesh& mesh, const Topology& topo);

  const Vec3& face(int t) const { return face_[static_cast<std::size_t>(t)]; }  // unit; zero if no area
  int neighbour(int t, int edge) const {
    return neighbours_[static_cast<std::size_t>(t)][static_cast<std::size_t>(edge)];
  }
  // Not unit; zero where it would not give the sign: non-manifold edges and vertices, beside triangles
  // of no area, and where two faces are folded onto each other.
  Vec3 at(int t, Feature feature) const;
  std::size_t memory() const;

 private:
  std::vector<Vec3> face_, vertex_;
  std::vector<std::array<int, 3>> triangles_, neighbours_;
};

}  // namespace hawser::detail
