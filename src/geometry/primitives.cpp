// Plane and cylinder: distance and its derivatives.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/geometry/surface.hpp"

namespace hawser {

PlaneSurface::PlaneSurface(const Vec3& point, const Vec3& normal)
    : point_(point), normal_(normal.normalized()) {
  if (!(normal.norm() > 0)) throw std::invalid_argument("a plane needs a normal that is not zero");
}

std::optional<SurfacePoint> PlaneSurface::query(const Vec3& y, double max_distance, int) const {
  SurfacePoint s;
  s.distance = normal_.dot(y - point_);
  if (s.distance > max_distance) return std::nullopt;
  s.normal = normal_;
  s.point = y - s.distance * normal_;
  s.triangle = 0;
  return s;
}

Box PlaneSurface::bounds() const {
  // Only a plane normal to an axis bounds its half-space.
  Box box = Box::everything();
  for (int i = 0; i < 3; ++i) {
    if (normal_[i] == 1) box.hi[i] = point_[i];
    if (normal_[i] == -1) box.lo[i] = point_[i];
  }
  return box;
}

CylinderSurface::CylinderSurface(const Vec3& a, const Vec3& b, double radius)
    : centre_(0.5 * (a + b)),
      axis_((b - a).normalized()),
      half_length_(0.5 * (b - a).norm()),
      radius_(radius) {
  if (!(half_length_ > 0) || !(radius > 0))
    throw std::invalid_argument("a cylinder needs a length and a radius above zero");
}

std::optional<SurfacePoint> CylinderSurface::query(const Vec3& y, double max_distance, int) const {
  const Vec3 r = y - centre_;
  const double z = r.dot(axis_);
  const Vec3 radial = r - z * axis_;
  const double rho = radial.norm();
  // On the axis any radial direction is valid.
  const Vec3 er = rho > 1e-12 * radius_ ? Vec3(radial / rho) : axis_.unitOrthogonal();
  const Vec3 ez = z < 0 ? Vec3(-axis_) : axis_;
  const double rho_safe = std::max(rho, 1e-6 * radius_);
  const double side = rho - radius_;
  const double cap = std::abs(z) - half_length_;

  SurfacePoint s;
  s.distance = side > 0 && cap > 0 ? std::hypot(side, cap) : std::max(side, cap);
  if (s.distance > max_distance) return std::nullopt;
  if (side > 0 && cap > 0) {
    s.normal = (side * er + cap * ez) / s.distance;
    const Vec3 et = axis_.cross(er);
    const double d = std::max(s.distance, 1e-6 * radius_);
    const Mat3 tt = et * et.transpose();
    s.curvature =
        (Mat3::Identity() - s.normal * s.normal.transpose() - tt) / d + s.normal.dot(er) / rho_safe * tt;
    s.feature = Feature::edge0;
  } else if (side >= cap) {
    s.normal = er;
    s.curvature = (Mat3::Identity() - er * er.transpose() - axis_ * axis_.transpose()) / rho_safe;
  } else {
    s.normal = ez;
  }
  s.triangle = side >= cap && s.feature == Feature::face ? 0 : (z < 0 ? 1 : 2);
  s.point = y - s.distance * s.normal;
  return s;
}

Box CylinderSurface::bounds() const {
  // Half extent of a disc of radius R normal to the axis a: R sqrt(1 - a_i²).
  const Vec3 h =
      (half_length_ * axis_.cwiseAbs().array() + radius_ * (1 - axis_.array().square()).max(0.0).sqrt())
          .matrix();
  return {centre_ - h, centre_ + h};
}

}  // namespace hawser
