// The ground under a regular grid of heights: the signed distance to a bicubic spline through them.
//
// The spline is the tensor product of natural cubic splines (de Boor 1962, "Bicubic spline interpolation", J.
// Math. Phys. 41), so slope and curvature are continuous everywhere. Beyond the grid it goes on straight, as
// natural splines do. The nearest point is found by Newton's method from the one straight below or above: it
// is the nearest of all where the point is nearer than the surface's radius of curvature, and there the
// distance is twice continuously differentiable.
#pragma once

#include <vector>

#include "hawser/geometry/surface.hpp"

namespace hawser {

class HeightGrid final : public Surface {
 public:
  // Ascending x (columns) and y (rows) [m], two of each at least; heights [m] row by row.
  // std::invalid_argument otherwise.
  HeightGrid(std::vector<double> x, std::vector<double> y, const std::vector<double>& height);

  // The ground is inside.
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  double free_radius(const Vec3& y, double distance, int hint = -1) const override;
  Box bounds() const override;  // infinite

  struct Height {
    double z = 0;           // m
    Eigen::Vector2d slope;  // by x and y
    Eigen::Matrix2d bend;   // 1/m
  };
  Height at(double x, double y) const;

  // The place on a line of the grid where the spline is furthest above (or below) both heights beside it,
  // more than the shape of a hill (or hollow) explains: beside a step.
  struct Overshoot {
    double by = 0;  // m; 0: nowhere
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    bool above = false;
  };
  Overshoot overshoot() const;

  bool covers(const Vec3& p) const {
    return p.x() >= x_.front() && p.x() <= x_.back() && p.y() >= y_.front() && p.y() <= y_.back();
  }
  double lowest() const { return lowest_; }      // m, of the given heights
  double highest() const { return highest_; }    // m
  double steepest() const { return steepest_; }  // a bound on the slope (tangent) anywhere
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }

 private:
  struct Node {
    double z, x, y, xy;  // height and its derivatives
  };
  std::vector<double> x_, y_;
  std::vector<Node> nodes_;
  double lowest_ = 0, highest_ = 0, steepest_ = 0;
};

}  // namespace hawser
