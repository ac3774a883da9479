// What contact asks of a body's surface: the signed distance with its first two derivatives.
//
// All in the body frame [m]; a surface never moves in it, so it is built once. Signed distance is
// positive outside and negative inside, its gradient is the outward unit normal, and the shape behind
// it is closed (or a half-space). query() is const and pure: any number of threads may call it.
//
// Kinds: PlaneSurface and CylinderSurface here; other exact shapes in primitives.hpp; meshes in
// mesh_surface.hpp, with an inside test of their own in tested_surface.hpp; beds in height_grid.hpp and
// ground.hpp.
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
  Mat3 curvature = Mat3::Zero();    // 1/m, Hessian of the distance at the query point. Of a mesh: 0 on a
                                    // face, (I - nn' - ee')/d along an edge e, (I - nn')/d at a vertex;
                                    // bounded: |d| is replaced by a small length when it is smaller
  Vec3 point = Vec3::Zero();        // m, nearest point of the surface
  int triangle = -1;                // of a mesh, or the patch of a primitive; give it back as a hint
  Feature feature = Feature::face;  // of that triangle
};

class Surface {
 public:
  virtual ~Surface() = default;

  // The nearest surface point to y when the signed distance is <= max_distance [m]; nullopt when y is
  // farther outside. A point inside is always reported, however deep. `hint` is the `triangle` of an
  // earlier answer near y, or -1: it changes the time, never the answer.
  virtual std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const = 0;

  // The same answer where it is asked for again and again near a place: `near` keeps what is known of the
  // facets there, is renewed where it does not suffice, and changes nothing but the time.
  virtual std::optional<SurfacePoint> query_again(const Vec3& y, double max_distance, int hint,
                                                  NearFacets& /*near*/) const {
    return query(y, max_distance, hint);
  }

  // m: no point of the body is nearer to y than that, where query() says it is `distance` away or farther.
  // Less than `distance` where query() may take a near place for the nearest, and where the body begins
  // without a surface: at the holes of an open mesh, at an inactive part. `hint` as of query().
  virtual double free_radius(const Vec3& /*y*/, double distance, int /*hint*/ = -1) const { return distance; }

  // Contains the surface that can be met and all points inside it; may be infinite.
  virtual Box bounds() const = 0;

  // Facet groups that can be touched together, see facet_groups.hpp; only meshes that are not convex have
  // several. Of those within `reach` [m] of a polyline (one point or more): none where query() says all there
  // is. What is one facet group and what are two depends on the place and on nothing else.
  virtual void facet_groups(std::span<const Vec3>, double /*reach*/, FacetGroups& out) const {
    out.of.clear();
  }
  // Whether no more than one is known to be there; quicker.
  virtual bool one_facet_group(std::span<const Vec3>, double /*reach*/) const { return true; }
  // query() of a facet group alone. What is behind it gets no answer unless it is inside and the facet group
  // is the nearest of all; either_side: it does, with its distance from the facet group, negative there.
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
