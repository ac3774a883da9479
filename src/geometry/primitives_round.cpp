// Sphere, capsule, torus: distance and its derivatives.
#include <cmath>
#include <stdexcept>

#include "hawser/geometry/primitives.hpp"
#include "round_surfaces.hpp"

namespace hawser {
namespace {

using namespace round_surfaces;

void need(bool condition, const char* sentence) {
  if (!condition) throw std::invalid_argument(sentence);
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
  if (side) {
    const SurfacePoint s = about_line(y, from_, axis_, radius_);
    if (s.distance > max_distance) return std::nullopt;
    return s;
  }
  // At the ends of the axis the normal points outward along it.
  SurfacePoint s = about_point(y, z > 0 ? to_ : from_, radius_, z > 0 ? axis_ : Vec3(-axis_));
  if (s.distance > max_distance) return std::nullopt;
  s.triangle = z > 0 ? 2 : 1;
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
  const SurfacePoint s = about_circle(y, centre_, axis_, radius_, tube_);
  if (s.distance > max_distance) return std::nullopt;
  return s;
}

Box TorusSurface::bounds() const {
  const Vec3 h = (radius_ * (1 - axis_.array().square()).max(0.0).sqrt()).matrix();
  return Box{centre_ - h, centre_ + h}.grown(tube_);
}

}  // namespace hawser
