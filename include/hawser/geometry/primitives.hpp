// Primitives as contact surfaces: exact signed distance, normal and curvature in closed form.
//
// A Primitive (primitive_shape.hpp) is the plain description, make_surface() makes its Surface, facets() a
// triangle mesh of it. Body frame, m. Plane and cylinder are declared in surface.hpp, the others here.
//
// Inside, where several surface points are equally near (the medial axis: a sphere's centre, a cylinder's
// axis, a box's diagonals), the distance has a kink; the query then always returns the same one of them. The
// curvature is the Hessian of the distance at the query point, bounded by 1e6 over the primitive's size. For
// a distance f(rho, z) about an axis the Hessian is that of f in the meridian plane plus (df/drho) / rho on
// the circle's tangent; see docs/theory/geometry.md.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "hawser/geometry/primitive_shape.hpp"
#include "hawser/geometry/surface.hpp"
#include "hawser/geometry/triangle_mesh.hpp"
#include "hawser/geometry/tube_path.hpp"

namespace hawser {

// Throws std::invalid_argument with a message if the shape has no inside (see primitive_shape.hpp).
std::shared_ptr<const Surface> make_surface(const Primitive& shape);

// The shape as triangles with corners on the surface, closed and outward. A plane gives a square patch
// centred at the foot of extent.centre() that contains the foot of every point of `extent`.
TriangleMesh facets(const Primitive& shape, const Box& extent);
// The same with the radius enlarged so that the mesh has the volume of the shape. Throws
// std::invalid_argument for a plane.
TriangleMesh facets_of_volume(const Primitive& shape);
// Volume, m³; throws std::invalid_argument for a plane.
double volume(const Primitive& shape);

// Patch numbers: (i + 1) + 3 (j + 1) + 9 (k + 1), with i, j, k in {-1, 0, 1} the side of the box on which the
// nearest point lies, in the box's axes; features face, edge0 and vertex0.
class BoxSurface final : public Surface {
 public:
  explicit BoxSurface(const BoxShape& shape);
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  Box bounds() const override;

 private:
  Vec3 centre_, half_;
  Mat3 axes_;  // columns
};

// One patch, number 0.
class SphereSurface final : public Surface {
 public:
  explicit SphereSurface(const SphereShape& shape);
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  Box bounds() const override;

 private:
  Vec3 centre_;
  double radius_;
};

// Patch numbers: 0 side, 1 round end at `from`, 2 at `to`.
class CapsuleSurface final : public Surface {
 public:
  explicit CapsuleSurface(const CapsuleShape& shape);
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  Box bounds() const override;

 private:
  Vec3 from_, to_, axis_;
  double length_, radius_;
};

// One patch, number 0. For a point on the axis the nearest points form a circle, of which one is returned.
class TorusSurface final : public Surface {
 public:
  explicit TorusSurface(const TorusShape& shape);
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  Box bounds() const override;

 private:
  Vec3 centre_, axis_;
  double radius_, tube_;
};

// Patch numbers: 2i the outside and 2i + 1 the bore of the leg or arc i, 2n and 2n + 2 the rims of n pieces.
// Exact where the tube keeps clear of itself.
class TubeSurface final : public Surface {
 public:
  explicit TubeSurface(const TubeShape& shape);
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  Box bounds() const override;
  // True if y is in the bore, not in the wall.
  bool in_bore(const Vec3& y) const;

 private:
  struct End {
    Vec3 at = Vec3::Zero(), out = Vec3::UnitX();  // of the axis; unit tangent outwards
  };
  std::vector<TubePiece> pieces_;
  std::array<End, 2> ends_;
  double middle_, half_wall_, size_ = 0;
  Box box_;
};

}  // namespace hawser
