// Tube: distance from its wall and the derivatives.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "hawser/geometry/primitives.hpp"
#include "round_surfaces.hpp"

namespace hawser {
namespace {

using namespace round_surfaces;

constexpr double kOverlap =
    1e-14;  // of coordinates: their rounding, by which pieces extend beyond their ends
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct AtRing {
  double across = 0, along = 0;  // m, across and along the axis of the ring
};
AtRing at_ring(const Vec3& y, const Vec3& centre, const Vec3& axis) {
  const Vec3 r = y - centre;
  const double along = r.dot(axis);
  return {(r - along * axis).norm(), along};
}

// Distance of y from the axis, m; infinite where its foot is not on the piece.
double from_axis(const TubePiece& p, const Vec3& y, double overlap) {
  if (!p.arc()) {
    const double z = (y - p.from).dot(p.direction);
    return z < -overlap || z > p.length + overlap ? kInfinity : (y - p.from - z * p.direction).norm();
  }
  // An arc turns by less than half a turn: it is ahead of its start and behind its end.
  const Vec3 r = y - p.centre();
  if (r.dot(p.direction) < -overlap || r.dot(p.tangent(p.length)) > overlap) return kInfinity;
  const AtRing at = at_ring(y, p.centre(), p.axis());
  return std::hypot(at.across - p.radius, at.along);
}

}  // namespace

TubeSurface::TubeSurface(const TubeShape& shape)
    : pieces_(tube_pieces(shape)), middle_(shape.middle_radius()), half_wall_(0.5 * shape.wall_thickness) {
  if (!(shape.inner_radius > 0) || !(shape.wall_thickness > 0))
    throw std::invalid_argument("a tube needs an inner radius and a wall thickness above zero");
  for (const TubePiece& p : pieces_)
    if (p.arc() && !(p.radius > shape.outer_radius()))
      throw std::invalid_argument("the bend radius of a tube must be above its outer radius");
  const TubePiece& last = pieces_.back();
  ends_ = {{{pieces_.front().from, -pieces_.front().direction},
            {last.point(last.length), last.tangent(last.length)}}};
  for (const Vec3& p : shape.path) box_.add(p);
  size_ = std::max(box_.lo.cwiseAbs().maxCoeff(), box_.hi.cwiseAbs().maxCoeff());
  box_ = box_.grown(shape.outer_radius());
}

// With M the surface in the middle of the wall, the distance is that from M less half the wall. The nearest
// point of M is opposite to a foot on the axis, or on the rim.
std::optional<SurfacePoint> TubeSurface::query(const Vec3& y, double max_distance, int) const {
  const double overlap = kOverlap * (size_ + y.cwiseAbs().maxCoeff());
  const int n = static_cast<int>(pieces_.size());
  double nearest = kInfinity;
  int part = -1;
  for (int i = 0; i < n; ++i) {
    const double d = std::abs(from_axis(pieces_[i], y, overlap) - middle_);
    if (!(d < nearest)) continue;
    nearest = d;
    part = i;
  }
  // Beside its end the surface itself is at least as near as the rim.
  for (int e = 0; e < 2; ++e) {
    const AtRing at = at_ring(y, ends_[e].at, ends_[e].out);
    const double d = std::hypot(at.across - middle_, at.along);
    if (at.along < 0 || !(d < nearest)) continue;
    nearest = d;
    part = n + e;
  }
  if (part < 0 || nearest - half_wall_ > max_distance) return std::nullopt;
  if (part >= n) {
    SurfacePoint s = about_circle(y, ends_[part - n].at, ends_[part - n].out, middle_, half_wall_);
    s.triangle = 2 * part;
    return s;
  }
  const TubePiece& p = pieces_[part];
  SurfacePoint s = p.arc() ? about_circle(y, p.centre(), p.axis(), p.radius, middle_)
                           : about_line(y, p.from, p.direction, middle_);
  // d = |rho - R_m| - t/2: in the bore the normal points to the axis.
  const bool bore = s.distance < 0;
  if (bore) {
    s.distance = -s.distance;
    s.normal = -s.normal;
    s.curvature = -s.curvature;
  }
  s.distance -= half_wall_;
  s.point += half_wall_ * s.normal;
  s.triangle = 2 * part + bore;
  return s;
}

bool TubeSurface::in_bore(const Vec3& y) const {
  const auto s = query(y, middle_);
  return s && s->distance > 0 && s->triangle % 2 == 1;
}

Box TubeSurface::bounds() const { return box_; }

}  // namespace hawser
