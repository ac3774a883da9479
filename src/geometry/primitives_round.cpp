// Sphere, capsule, torus: distance and its derivatives.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/geometry/primitives.hpp"

namespace hawser {
namespace {

// Smallest distance as a fraction of the radius of curvature, which bounds the Hessian, and the distance
// below which a point counts as on the medial axis.
constexpr double kNear = 1e-6, kOnAxis = 1e-12;

void need(bool condition, const char* sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

Mat3 outer(const Vec3& a) { return a * a.transpose(); }

// Distance |y - c| - radius about the point c. At c itself the normal is `fallback`.
SurfacePoint about_point(const Vec3& y, const Vec3& c, double radius, const Vec3& fallback) {
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

}  // namespace

SphereSurface::SphereSurface(const SphereShape& shape) : centre_(shape.centre), radius_(shape.radius) {
  need(radius_ > 0, "a sphere needs a radius above zero");
}

std::optional<SurfacePoint> SphereSurface::query(const Vec3& y, double max_distance, int) const {
  SurfacePoint s = about_point(y, centre_, radius_, Vec3::UnitZ());
  if (s.distance > max_distance) return std::nullopt;
  return s;
}

Box SphereSurface::bounds() const { return Box{centre_, centre_}.grown(radius_); }

CapsuleSurface::CapsuleSurface(const CapsuleShape& shape)
    : from_(shape.from),
      to_(shape.to),
      axis_(Vec3::UnitZ()),
      length_((shape.to - shape.from).norm()),
      radius_(shape.radius) {
  need(radius_ > 0, "a capsule needs a radius above zero");
  if (length_ > 0) axis_ = (to_ - from_) / length_;
}

std::optional<SurfacePoint> CapsuleSurface::query(const Vec3& y, double max_distance, int) const {
  const double z = (y - from_).dot(axis_);
  const bool side = z > 0 && z < length_;
  const Vec3 foot = side ? Vec3(from_ + z * axis_) : z > 0 ? to_ : from_;
  // At the ends of the axis the normal points outward along it; between them any perpendicular direction is
  // valid.
  const Vec3 fallback = side ? axis_.unitOrthogonal() : z > 0 ? axis_ : Vec3(-axis_);
  SurfacePoint s = about_point(y, foot, radius_, fallback);
  if (s.distance > max_distance) return std::nullopt;
  if (side) {
    // Rounding of the foot leaves an axial component, which matters if y is near the axis.
    const Vec3 across = s.normal - s.normal.dot(axis_) * axis_;
    s.normal = across.normalized();
    s.point = foot + radius_ * s.normal;
    const double l = std::max(s.distance + radius_, kNear * radius_);
    s.curvature = (Mat3::Identity() - outer(s.normal) - outer(axis_)) / l;
  } else {
    s.triangle = z > 0 ? 2 : 1;
  }
  return s;
}

Box CapsuleSurface::bounds() const {
  Box box;
  box.add(from_);
  box.add(to_);
  return box.grown(radius_);
}

TorusSurface::TorusSurface(const TorusShape& shape)
    : centre_(shape.centre),
      axis_(shape.axis.stableNormalized()),
      radius_(shape.radius),
      tube_(shape.tube_radius) {
  need(shape.axis.stableNorm() > 0, "a torus needs an axis that is not zero");
  need(tube_ > 0 && radius_ > tube_, "a torus needs a tube radius above zero and below its radius");
}

std::optional<SurfacePoint> TorusSurface::query(const Vec3& y, double max_distance, int) const {
  const Vec3 r = y - centre_;
  const double z = r.dot(axis_);
  const Vec3 radial = r - z * axis_;
  const double rho = radial.norm();
  const Vec3 er = rho > kOnAxis * radius_ ? Vec3((radial - radial.dot(axis_) * axis_).normalized())
                                          : axis_.unitOrthogonal();
  const Vec3 middle = centre_ + radius_ * er;  // nearest point of the circle
  SurfacePoint s = about_point(y, middle, tube_, er);
  if (s.distance > max_distance) return std::nullopt;
  const Vec3 et = axis_.cross(er);
  // about_point's Hessian has 1 / l along the circle too; the exact value is (n er) / rho.
  const double l = std::max(s.distance + tube_, kNear * tube_);
  s.curvature += (s.normal.dot(er) / std::max(rho, kNear * radius_) - 1 / l) * outer(et);
  return s;
}

Box TorusSurface::bounds() const {
  const Vec3 h = (radius_ * (1 - axis_.array().square()).max(0.0).sqrt()).matrix();
  return Box{centre_ - h, centre_ + h}.grown(tube_);
}

}  // namespace hawser
