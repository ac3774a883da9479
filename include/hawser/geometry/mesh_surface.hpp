// Signed distance to a closed triangle mesh.
//
// The nearest triangle comes from a SpatialHash, the sign from the angle-weighted pseudonormal at the
// nearest feature: Bærentzen & Aanæs (2005), "Signed distance computation using the angle weighted
// pseudonormal", IEEE TVCG 11(3). Where that is not defined (a vertex or edge where the surface touches
// itself, a triangle of no area) the solid angle decides.
//
// Only `active` triangles are met. The sign is that of the whole mesh, so the inactive rest closes the
// body. A point inside whose nearest active point is on the border of the active part, and which does
// not lie under an active face, is not in contact.
#pragma once

#include <memory>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

class MeshSurface final : public Surface {
 public:
  // The mesh must be welded, closed and oriented (MeshReport::valid); throws std::invalid_argument with
  // a sentence otherwise. `active`: one flag per triangle, empty means all.
  explicit MeshSurface(TriangleMesh mesh, std::vector<bool> active = {});
  ~MeshSurface() override;
  MeshSurface(MeshSurface&&) noexcept;
  MeshSurface& operator=(MeshSurface&&) noexcept;

  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  Box bounds() const override;  // of the active part and all inside the mesh

  const TriangleMesh& mesh() const;
  std::size_t memory() const;  // bytes

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

// Triangles of the named part / with all corners in the box.
std::vector<bool> active_by_part(const TriangleMesh& mesh, const std::vector<std::string>& names);
std::vector<bool> active_by_box(const TriangleMesh& mesh, const Box& box);

}  // namespace hawser
