// Interface of a body's surface for contact: signed distance with its first two derivatives.
//
// All in the body frame [m], in which a surface does not move. The signed distance is positive outside and
// negative inside, its gradient is the outward unit normal, and the shape is closed (or a half-space).
// query() is const and pure: any number of threads may call it.
//
// Planes and cylinders are here, other exact shapes in primitives.hpp, meshes in mesh_surface.hpp, meshes
// with other inside tests in tested_surface.hpp, seabeds in height_grid.hpp and ground.hpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/closest_point.hpp"
#include "hawser/geometry/facet_groups.hpp"
#include "hawser/geometry/near_facets.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct SurfacePoint {
  double distance = 0;              // m, signed: negative inside
  Vec3 normal = Vec3::UnitZ();      // unit gradient of the distance at the query point, outward
  Mat3 curvature = Mat3::Zero();    // 1/m, Hessian of the distance at the query point. For a mesh: 0 on a
                                    // face, (I - nn' - ee')/d along an edge e, (I - nn')/d at a vertex;
                                    // bounded: |d| is replaced by a small length when it is smaller
  Vec3 point = Vec3::Zero();        // m, nearest point of the surface
  int triangle = -1;                // of a mesh, or patch of a primitive; usable as a hint
  Feature feature = Feature::face;  // of that triangle
};

class Surface {
 public:
  virtual ~Surface() = default;

  // Nearest surface point to y if the signed distance is <= max_distance [m]; nullopt if y is farther
  // outside. A point inside is always found, however deep. `hint`: `triangle` of an earlier result near y, or
  // -1; it affects the time only.
  virtual std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const = 0;

  // The same result for repeated queries near a place: `near` stores the facets there and is updated if it
  // does not suffice; it affects the time only.
  virtual std::optional<SurfacePoint> query_again(const Vec3& y, double max_distance, int hint,
                                                  NearFacets& /*near*/) const {
    return query(y, max_distance, hint);
  }

  // Radius about y without any point of the body, m, for a signed distance of at least `distance` according
  // to query(). Less than `distance` if query() may return a local instead of the global minimum, and where
  // the body has no surface: at the holes of an open mesh, at an inactive part. `hint`: as for query().
  virtual double free_radius(const Vec3& /*y*/, double distance, int /*hint*/ = -1) const { return distance; }

  // Contains the active surface and all points inside it; may be infinite.
  virtual Box bounds() const = 0;

  // Facet groups that can be touched together, see facet_groups.hpp, within `reach` [m] of a polyline (one
  // point or more). Only meshes that are not convex have several; empty if query() suffices. The grouping
  // depends only on the place.
  virtual void facet_groups(std::span<const Vec3>, double /*reach*/, FacetGroups& out) const {
    out.list.clear();
  }
  // True if it is certain that there is at most one; faster.
  virtual bool one_facet_group(std::span<const Vec3>, double /*reach*/) const { return true; }
  // query() of a single facet group. A point behind it has no result unless it is inside and the facet group
  // is the nearest of all. either_side: such a point has a negative distance from the facet group.
  virtual std::optional<SurfacePoint> query_group(const FacetGroup&, const Vec3& y, double max_distance,
                                                  bool /*either_side*/ = false) const {
    return query(y, max_distance);
  }
};

// The half-space below a plane through `point` with outward `normal` (need not be unit, not zero).
class PlaneSurface final : public Surface {
 public:
  PlaneSurface(const Vec3& point, const Vec3& normal);
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  Box bounds() const override;

 private:
  Vec3 point_, normal_;
};

// A closed circular cylinder with its axis from a to b (a != b), radius > 0 [m]. Patches: 0 side, 1 cap
// at a, 2 cap at b; on the rims the feature is edge0 of the cap.
class CylinderSurface final : public Surface {
 public:
  CylinderSurface(const Vec3& a, const Vec3& b, double radius);
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  Box bounds() const override;

 private:
  Vec3 centre_, axis_;
  double half_length_, radius_;
};

}  // namespace hawser
