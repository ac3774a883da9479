// A rotated box: distance and its derivatives.
#include <algorithm>
#include <stdexcept>

#include "hawser/geometry/primitives.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {

BoxSurface::BoxSurface(const BoxShape& shape)
    : centre_(shape.centre), half_(0.5 * shape.size), axes_(exp_so3(shape.rotation).toRotationMatrix()) {
  if (!((half_.array() > 0).all())) throw std::invalid_argument("a box needs sides above zero");
}

std::optional<SurfacePoint> BoxSurface::query(const Vec3& y, double max_distance, int) const {
  const Vec3 p = axes_.transpose() * (y - centre_);
  const Vec3 excess = p.cwiseAbs() - half_;
  Vec3 normal = Vec3::Zero();  // in the box's axes, like the rest
  Mat3 curvature = Mat3::Zero();
  int side[3] = {0, 0, 0};
  SurfacePoint s;
  int outside = 0;
  for (int i = 0; i < 3; ++i) {
    if (!(excess[i] > 0)) continue;
    ++outside;
    side[i] = p[i] < 0 ? -1 : 1;
    normal[i] = side[i] * excess[i];
  }
  if (outside > 0) {
    s.distance = normal.stableNorm();
    if (s.distance > max_distance) return std::nullopt;
    normal /= s.distance;
    if (outside > 1) {
      const double near = 1e-6 * half_.maxCoeff();
      curvature = -normal * normal.transpose();
      for (int i = 0; i < 3; ++i)
        if (side[i] != 0) curvature(i, i) += 1;
      curvature /= std::max(s.distance, near);
    }
    s.feature = outside == 1 ? Feature::face : outside == 2 ? Feature::edge0 : Feature::vertex0;
  } else {
    // Nearest face, the first of equal ones.
    int i = 0;
    for (int k = 1; k < 3; ++k)
      if (excess[k] > excess[i]) i = k;
    side[i] = p[i] < 0 ? -1 : 1;
    s.distance = excess[i];
    if (s.distance > max_distance) return std::nullopt;
    normal[i] = side[i];
  }
  Vec3 point = p;
  for (int i = 0; i < 3; ++i)
    if (side[i] != 0) point[i] = side[i] * half_[i];
  s.normal = axes_ * normal;
  s.curvature = axes_ * curvature * axes_.transpose();
  s.point = centre_ + axes_ * point;
  s.triangle = (side[0] + 1) + 3 * (side[1] + 1) + 9 * (side[2] + 1);
  return s;
}

Box BoxSurface::bounds() const {
  const Vec3 h = axes_.cwiseAbs() * half_;
  return {centre_ - h, centre_ + h};
}

}  // namespace hawser
