// Overshoot of the spline through a grid of heights beyond the range of neighbouring heights at steps of the
// ground.
#include <algorithm>
#include <cmath>

#include "hawser/geometry/height_grid.hpp"

namespace hawser {
namespace {

// Four heights in a row, the middle two at the distance `h` with slopes `m` and `n`, and a point between
// these.
struct Cell {
  double before, p, q, after, h, m, n;

  double at(double u) const {
    const double v = 1 - u;
    return v * v * (1 + 2 * u) * p + u * u * (3 - 2 * u) * q + h * u * v * (v * m - u * n);
  }
  // A parabola over a hilltop exceeds two equally high points beside it by an eighth of the smaller descent
  // on both sides; twice that is attributed to the shape of the ground. A step has no descent on one side.
  double beyond(double z) const {
    constexpr double kShapeFraction = 0.25;
    const auto above = [&](double sign) {
      const double descent = std::min(sign * (p - before), sign * (q - after));
      return sign * z - std::max(sign * p, sign * q) - kShapeFraction * std::max(0.0, descent);
    };
    return std::max(above(1), above(-1));
  }
  // Position, as a fraction of h, of the largest overshoot; 0: none.
  double furthest() const {
    // Roots of the slope a u² + b u + m.
    const double a = 3 * (m + n - 2 * (q - p) / h);
    const double b = 2 * (3 * (q - p) / h - 2 * m - n);
    const double root = b * b - 4 * a * m;
    if (root < 0) return 0;
    const double k = -0.5 * (b + std::copysign(std::sqrt(root), b));
    double best = 0, largest = 0;
    for (const double u : {a != 0 ? k / a : 0, k != 0 ? m / k : 0})
      if (u > 0 && u < 1 && beyond(at(u)) > largest) {
        best = u;
        largest = beyond(at(u));
      }
    return best;
  }
};

}  // namespace

HeightGrid::Overshoot HeightGrid::overshoot() const {
  const size_t nx = x_.size();
  const size_t ny = y_.size();
  Overshoot worst;
  const auto scan_row = [&](size_t first, size_t stride, const std::vector<double>& t, double Node::*slope,
                            auto&& place) {
    const auto node = [&](size_t i) -> const Node& { return nodes_[first + i * stride]; };
    for (size_t i = 0; i + 1 < t.size(); ++i) {
      const Node& p = node(i);
      const Node& q = node(i + 1);
      const Cell cell{node(i > 0 ? i - 1 : 0).z, p.z,      q.z,     node(std::min(i + 2, t.size() - 1)).z,
                      t[i + 1] - t[i],           p.*slope, q.*slope};
      const double u = cell.furthest();
      const double z = cell.at(u);
      if (u == 0 || !(cell.beyond(z) > worst.height)) continue;
      worst = {cell.beyond(z), place(t[i] + u * cell.h), z > std::max(p.z, q.z)};
    }
  };
  for (size_t j = 0; j < ny; ++j)
    scan_row(j * nx, 1, x_, &Node::x, [&](double x) { return Eigen::Vector2d(x, y_[j]); });
  for (size_t i = 0; i < nx; ++i)
    scan_row(i, nx, y_, &Node::y, [&](double y) { return Eigen::Vector2d(x_[i], y); });
  return worst;
}

}  // namespace hawser
