// A mesh whose inside is what a test of its own says, instead of the pseudonormals of MeshSurface: the three
// tests of OMAE2006-92155 (point_in_polyhedron.hpp) and the winding number. Distance and nearest point are
// those of the mesh, which has flat facets.
#pragma once

#include <memory>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/sign_test.hpp"
#include "hawser/geometry/winding_tree.hpp"

namespace hawser {

class TestedSurface final : public Surface {
 public:
  // test: winding, or one of the three, which look at every triangle in each query in the box of the mesh and
  // need it as they say there: not checked. partial: not all of the mesh is active. std::invalid_argument
  // where facets are curved.
  TestedSurface(std::shared_ptr<const MeshSurface> mesh, SignTest test, bool partial = false);

  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  double free_radius(const Vec3& y, double distance, int hint = -1) const override {
    return mesh_->free_radius(y, distance, hint);
  }
  Box bounds() const override { return mesh_->bounds(); }

 private:
  bool inside(const Vec3& y) const;

  std::shared_ptr<const MeshSurface> mesh_;
  SignTest test_;
  bool partial_;
  WindingTree winding_;
};

}  // namespace hawser
