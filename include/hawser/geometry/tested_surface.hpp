// Mesh surface whose inside is determined by a separate test instead of the pseudonormals of MeshSurface: the
// three tests of OMAE2006-92155 (point_in_polyhedron.hpp) or the winding number. Distance and nearest point
// are those of the mesh, which has flat facets.
#pragma once

#include <memory>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/sign_test.hpp"
#include "hawser/geometry/winding_tree.hpp"

namespace hawser {

class TestedSurface final : public Surface {
 public:
  // test: winding, or one of the three tests, which visit every triangle in each query in the mesh's box and
  // have requirements that are not checked. partial: part of the mesh is inactive. Throws
  // std::invalid_argument for curved facets.
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
