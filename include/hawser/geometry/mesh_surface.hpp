// Signed distance to a triangle mesh with flat or curved facets.
//
// With `smooth` the facets of curved surfaces are quadratic patches (mesh_bends.hpp, smooth_patch.hpp), and
// distance, normal and curvature are those of the patches. Neighbours share the curve of their edge, so the
// distance is continuous. At kinks (creases, and slightly where patches meet) the nearest point may lie on an
// edge, with its curvature, as for flat facets.
//
// The nearest flat facet is found with a SpatialHash, the nearest patch and distant facets with a BoxTree.
// The sign comes from the angle-weighted pseudonormal at the nearest feature: Bærentzen & Aanæs (2005),
// "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3). Where it is undefined
// (a vertex or edge at which the surface touches itself, a triangle without area) the winding number decides
// (winding_tree.hpp).
//
// The inside of an open mesh is where the winding number exceeds 1/2. It is evaluated near holes and near
// facets across which it does not pass 1/2; elsewhere the pseudonormal gives the same sign faster. Facets
// with the inside on both sides (walls within the body, pieces that overlap) are excluded.
//
// Only `active` triangles take part in contact. The sign is that of the whole mesh, so the inactive rest
// closes the body. A point inside is not in contact if its nearest active point is on the border of the
// active part and it is not below an active face.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "hawser/geometry/smooth_patch.hpp"
#include "hawser/geometry/surface.hpp"
#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct MeshSurfaceOptions {
  bool smooth = false;                    // curve the facets
  double crease_angle = 40 * M_PI / 180;  // rad; edges with a larger angle remain sharp
  bool open = false;                      // allow open edges and inconsistently oriented triangles
};

class MeshSurface final : public Surface {
 public:
  // The mesh must be welded and, unless `open`, closed and oriented (MeshReport::valid); an open mesh should
  // have passed repair(). Throws std::invalid_argument with a message. `active`: flags of the triangles;
  // empty: all.
  explicit MeshSurface(TriangleMesh mesh, std::vector<bool> active = {}, MeshSurfaceOptions options = {});
  // Uses the data of write() in a block, which `keep` holds aligned to a cache line. Results are identical.
  explicit MeshSurface(std::shared_ptr<const std::byte> keep);
  ~MeshSurface() override;
  MeshSurface(MeshSurface&&) noexcept;
  MeshSurface& operator=(MeshSurface&&) noexcept;

  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  std::optional<SurfacePoint> query_again(const Vec3& y, double max_distance, int hint,
                                          NearFacets& near) const override;
  double free_radius(const Vec3& y, double distance, int hint = -1) const override;
  Box bounds() const override;  // of the active part and of all points inside the mesh
  void facet_groups(std::span<const Vec3> axis, double reach, FacetGroups& out) const override;
  bool one_facet_group(std::span<const Vec3> axis, double reach) const override;
  std::optional<SurfacePoint> query_group(const FacetGroup& group, const Vec3& y, double max_distance,
                                          bool either_side = false) const override;

  MeshView mesh() const;
  SmoothPatch patch(int triangle) const;  // without bends if flat
  int curved() const;                     // number of curved facets
  int sharp_edges() const;                // 0 without `smooth`
  double bulge() const;                   // m, upper bound of the distance of the surface from the facets
  int internal_facets() const;            // excluded because the body is on both sides of them

  // Stores all data in one block of memory to be shared (packing.hpp). packed_size(): bytes; `to` must be
  // aligned to a cache line.
  std::size_t packed_size() const;
  void write(std::byte* to) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

// Flags of the triangles of the named parts, and of those with all corners in the box.
std::vector<bool> active_by_part(const TriangleMesh& mesh, const std::vector<std::string>& names);
std::vector<bool> active_by_box(const TriangleMesh& mesh, const Box& box);

}  // namespace hawser
