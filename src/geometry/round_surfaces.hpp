// Distances from a point, a line and a circle less a radius, with their derivatives.
#pragma once

#include <algorithm>

#include "hawser/geometry/surface.hpp"

namespace hawser::round_surfaces {

// Smallest distance as a fraction of the radius of curvature, which bounds the Hessian, and the distance
// below which a point counts as on the medial axis.
constexpr double kNear = 1e-6, kOnAxis = 1e-12;

inline Mat3 outer(const Vec3& a) { return a * a.transpose(); }

// Distance |y - c| - radius about the point c. At c itself the normal is `fallback`.
inline SurfacePoint about_point(const Vec3& y, const Vec3& c, double radius, const Vec3& fallback) {
  SurfacePoint s;
  const Vec3 r = y - c;
  const double l = r.norm();
  s.distance = l - radius;
  s.normal = l > kOnAxis * radius ? Vec3(r / l) : fallback;
  s.curvature = (Mat3::Identity() - outer(s.normal)) / std::max(l, kNear * radius);
  s.point = c + radius * s.normal;
  s.triangle = 0;
  return s;
}

// The same about a line through `from` along the unit vector `axis`. On the line itself any perpendicular
// direction is valid.
inline SurfacePoint about_line(const Vec3& y, const Vec3& from, const Vec3& axis, double radius) {
  const Vec3 foot = from + (y - from).dot(axis) * axis;
  SurfacePoint s = about_point(y, foot, radius, axis.unitOrthogonal());
  // Rounding of the foot leaves an axial component, which matters if y is near the axis.
  const Vec3 across = s.normal - s.normal.dot(axis) * axis;
  s.normal = across.normalized();
  s.point = foot + radius * s.normal;
  const double l = std::max(s.distance + radius, kNear * radius);
  s.curvature = (Mat3::Identity() - outer(s.normal) - outer(axis)) / l;
  return s;
}

// The same about a circle of radius `ring` with the unit vector `axis`; radius below `ring`.
inline SurfacePoint about_circle(const Vec3& y, const Vec3& centre, const Vec3& axis, double ring,
                                 double radius) {
  const Vec3 r = y - centre;
  const Vec3 radial = r - r.dot(axis) * axis;
  const double rho = radial.norm();
  const Vec3 er =
      rho > kOnAxis * ring ? Vec3((radial - radial.dot(axis) * axis).normalized()) : axis.unitOrthogonal();
  SurfacePoint s = about_point(y, centre + ring * er, radius, er);  // about the nearest point of the circle
  const Vec3 et = axis.cross(er);
  // about_point's Hessian has 1 / l along the circle too; the exact value is (n er) / rho.
  const double l = std::max(s.distance + radius, kNear * radius);
  s.curvature += (s.normal.dot(er) / std::max(rho, kNear * ring) - 1 / l) * outer(et);
  return s;
}

}  // namespace hawser::round_surfaces
