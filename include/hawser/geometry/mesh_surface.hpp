// Signed distance to a triangle mesh, its facets flat or curved.
//
// With `smooth` the facets of curved surfaces are quadratic patches (mesh_bends.hpp, smooth_patch.hpp), and
// distance, normal and curvature are those of the patches. Neighbours share the curve of their edge, so the
// distance is continuous; where it has a kink (at creases, and barely where patches meet) the point may be
// nearest to an edge, with its curvature, as on flat facets.
//
// The nearest flat facet comes from a SpatialHash, the nearest patch and what is far away from a BoxTree; the
// sign from the angle-weighted pseudonormal at the nearest feature: Bærentzen & Aanæs (2005), "Signed
// distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3). Where that is not defined (a
// vertex or edge where the surface touches itself, a triangle of no area) the winding number decides
// (winding_tree.hpp).
//
// Of an open mesh the inside is where the winding number is above 1/2. It is asked near holes, and near
// facets about which it does not pass 1/2; elsewhere the pseudonormal gives the same sign at once. Facets
// with the inside on both sides (facet groups within the body, pieces that overlap) are excluded.
//
// Only `active` triangles are met. The sign is that of the whole mesh, so the inactive rest closes the
// body. A point inside whose nearest active point is on the border of the active part, and which does
// not lie under an active face, is not in contact.
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
  double crease_angle = 40 * M_PI / 180;  // rad; edges sharper stay
  bool open = false;                      // allow open edges and triangles turned opposite ways
};

class MeshSurface final : public Surface {
 public:
  // The mesh must be welded, and unless `open` closed and oriented (MeshReport::valid; an open one should
  // have been through repair()); throws std::invalid_argument with a sentence otherwise. `active`: one flag
  // per triangle, empty means all.
  explicit MeshSurface(TriangleMesh mesh, std::vector<bool> active = {}, MeshSurfaceOptions options = {});
  // Of what write() left in a block; `keep` holds it on a cache line. Answers are the same to the last bit.
  explicit MeshSurface(std::shared_ptr<const std::byte> keep);
  ~MeshSurface() override;
  MeshSurface(MeshSurface&&) noexcept;
  MeshSurface& operator=(MeshSurface&&) noexcept;

  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  std::optional<SurfacePoint> query_again(const Vec3& y, double max_distance, int hint,
                                          NearFacets& near) const override;
  double free_radius(const Vec3& y, double distance, int hint = -1) const override;
  Box bounds() const override;  // of the active part and all inside the mesh
  void facet_groups(std::span<const Vec3> axis, double reach, FacetGroups& out) const override;
  bool one_facet_group(std::span<const Vec3> axis, double reach) const override;
  std::optional<SurfacePoint> query_group(const FacetGroup& group, const Vec3& y, double max_distance,
                                          bool either_side = false) const override;

  MeshView mesh() const;
  SmoothPatch patch(int triangle) const;  // without bends if flat
  int curved() const;                     // number of curved facets
  int sharp_edges() const;                // 0 without `smooth`
  double bulge() const;                   // m, the farthest the surface lies from the facets, at most
  int internal_facets() const;            // excluded, as the body is on both sides of them

  // All it knows in one block of memory, for others to read (packing.hpp): its size in bytes, and writing
  // it to `to`, which is on a cache line.
  std::size_t packed_size() const;
  void write(std::byte* to) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

// Triangles of the named part / with all corners in the box.
std::vector<bool> active_by_part(const TriangleMesh& mesh, const std::vector<std::string>& names);
std::vector<bool> active_by_box(const TriangleMesh& mesh, const Box& box);

}  // namespace hawser
