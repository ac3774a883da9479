// A mesh whose inside is what a test of its own says, instead of the pseudonormals of MeshSurface: the three
// tests of OMAE2006-92155 (point_in_polyhedron.hpp) and the winding number. Distance and nearest point are
// those of the mesh, which has flat facets.
#pragma once

#include <memory>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/winding_tree.hpp"

namespace hawser {

enum class SignBy { tetrahedra, ray, solid_angle, winding };

class TestedSurface final : public Surface {
 public:
  // partial: not all of the mesh is active. tetrahedra: the mesh is closed and convex, of one piece; ray and
  // solid_angle: closed and outward; neither is checked. The first three look at every triangle in each
  // query in the box of the mesh. std::invalid_argument where facets are curved.
  TestedSurface(std::shared_ptr<const MeshSurface> mesh, SignBy test, bool partial = false);

  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  double free_radius(const Vec3& y, double distance) const override {
    return mesh_->free_radius(y, distance);
  }
  Box bounds() const override { return mesh_->bounds(); }

 private:
  std::shared_ptr<const MeshSurface> mesh_;
  SignBy test_;
  bool partial_;
  WindingTree winding_;
};

}  // namespace hawser
