// Ground below a regular grid of heights: signed distance to a bicubic spline through them.
//
// The spline is the tensor product of natural cubic splines (de Boor 1962, "Bicubic spline interpolation", J.
// Math. Phys. 41), with continuous slope and curvature. It is linear beyond the grid. The nearest point is
// found by Newton's method from the point vertically below or above. It is the global one for query points
// nearer than the surface's radius of curvature, and the distance is twice continuously differentiable there.
#pragma once

#include <vector>

#include "hawser/geometry/surface.hpp"

namespace hawser {

class HeightGrid final : public Surface {
 public:
  // x (columns) and y (rows) [m] ascending, at least two each; heights [m] row by row. Throws
  // std::invalid_argument.
  HeightGrid(std::vector<double> x, std::vector<double> y, const std::vector<double>& height);

  // The inside is the ground.
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint = -1) const override;
  double free_radius(const Vec3& y, double distance, int hint = -1) const override;
  Box bounds() const override;  // infinite

  struct Height {
    double z = 0;           // m
    Eigen::Vector2d slope;  // by x and y
    Eigen::Matrix2d bend;   // 1/m
  };
  Height at(double x, double y) const;

  // Place on a grid line where the spline is farthest above (or below) both neighbouring heights, by more
  // than the shape of a hill (or hollow) explains, as beside a step.
  struct Overshoot {
    double height = 0;  // m; 0: nowhere
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    bool above = false;
  };
  Overshoot overshoot() const;

  bool covers(const Vec3& p) const {
    return p.x() >= x_.front() && p.x() <= x_.back() && p.y() >= y_.front() && p.y() <= y_.back();
  }
  double lowest() const { return lowest_; }      // m, of the given heights
  double highest() const { return highest_; }    // m
  double steepest() const { return steepest_; }  // upper bound of the slope (tangent)
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
