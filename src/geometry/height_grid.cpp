// Bicubic spline through a grid of heights, and the signed distance to it by Newton's method.
#include "hawser/geometry/height_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hawser {
namespace {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

// Slopes of the natural cubic spline through values at ascending t: continuous second derivative, zero at the
// ends. get(i), set(i, slope).
template <class Get, class Set>
void natural_slopes(const std::vector<double>& t, Get&& get, Set&& set) {
  const size_t n = t.size();
  // h1 s[i-1] + 2 (h0 + h1) s[i] + h0 s[i+1] = 3 (h1 d0 + h0 d1), d the slopes of the chords.
  std::vector<double> upper(n);
  std::vector<double> right(n);
  const auto chord = [&](size_t i) { return (get(i + 1) - get(i)) / (t[i + 1] - t[i]); };
  upper[0] = 0.5;
  right[0] = 1.5 * chord(0);
  for (size_t i = 1; i + 1 < n; ++i) {
    const double h0 = t[i] - t[i - 1];
    const double h1 = t[i + 1] - t[i];
    const double pivot = 2 * (h0 + h1) - h1 * upper[i - 1];
    upper[i] = h0 / pivot;
    right[i] = (3 * (h1 * chord(i - 1) + h0 * chord(i)) - h1 * right[i - 1]) / pivot;
  }
  double s = (3 * chord(n - 2) - right[n - 2]) / (2 - upper[n - 2]);
  set(n - 1, s);
  for (size_t i = n - 1; i-- > 0;) set(i, s = right[i] - upper[i] * s);
}

// Hermite's functions of values and slopes at both ends of a cell, and their derivatives; straight beyond the
// first and last cell.
struct Basis {
  size_t cell = 0;
  double value[4], slope[4], bend[4];  // of: value, value, slope, slope

  Basis(const std::vector<double>& t, double at) {
    const auto above = std::upper_bound(t.begin() + 1, t.end() - 1, at);
    cell = static_cast<size_t>(above - t.begin()) - 1;
    const double h = t[cell + 1] - t[cell];
    const double clamped = std::clamp(at, t.front(), t.back());
    const double u = (clamped - t[cell]) / h;
    const double v = 1 - u;
    value[0] = v * v * (1 + 2 * u);
    value[1] = u * u * (3 - 2 * u);
    value[2] = h * u * v * v;
    value[3] = -h * u * u * v;
    slope[0] = -6 * u * v / h;
    slope[1] = 6 * u * v / h;
    slope[2] = v * (1 - 3 * u);
    slope[3] = u * (3 * u - 2);
    bend[0] = (12 * u - 6) / (h * h);
    bend[1] = -bend[0];
    bend[2] = (6 * u - 4) / h;
    bend[3] = (6 * u - 2) / h;
    if (clamped == at) return;
    for (int i = 0; i < 4; ++i) {
      value[i] += (at - clamped) * slope[i];
      bend[i] = 0;
    }
  }
};

}  // namespace

HeightGrid::HeightGrid(std::vector<double> x, std::vector<double> y, const std::vector<double>& height)
    : x_(std::move(x)), y_(std::move(y)) {
  const size_t nx = x_.size();
  const size_t ny = y_.size();
  if (nx < 2 || ny < 2) throw std::invalid_argument("a grid of heights needs two columns and two rows");
  if (height.size() != nx * ny) throw std::invalid_argument("a grid of heights needs one for each place");
  for (const std::vector<double>* t : {&x_, &y_})
    for (size_t i = 1; i < t->size(); ++i)
      if (!((*t)[i] > (*t)[i - 1])) throw std::invalid_argument("columns and rows of a grid must ascend");
  nodes_.resize(nx * ny);
  for (size_t i = 0; i < nodes_.size(); ++i) nodes_[i].z = height[i];
  const auto along_x = [&](double Node::*from, double Node::*to) {
    for (size_t j = 0; j < ny; ++j) {
      Node* row = nodes_.data() + j * nx;
      natural_slopes(
          x_, [=](size_t i) { return row[i].*from; }, [=](size_t i, double s) { row[i].*to = s; });
    }
  };
  along_x(&Node::z, &Node::x);
  const auto along_y = [&](double Node::*from, double Node::*to) {
    for (size_t i = 0; i < nx; ++i) {
      Node* column = nodes_.data() + i;
      natural_slopes(
          y_, [=](size_t j) { return column[j * nx].*from; },
          [=](size_t j, double s) { column[j * nx].*to = s; });
    }
  };
  along_y(&Node::z, &Node::y);
  along_y(&Node::x, &Node::xy);

  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  lowest_ = *low;
  highest_ = *high;
  // The slope of a cell is bounded by the differences of its Bézier points.
  for (size_t j = 0; j + 1 < ny; ++j)
    for (size_t i = 0; i + 1 < nx; ++i) {
      const double h = (x_[i + 1] - x_[i]) / 3;
      const double k = (y_[j + 1] - y_[j]) / 3;
      double p[4][4];
      for (size_t b = 0; b < 2; ++b)
        for (size_t a = 0; a < 2; ++a) {
          const Node& n = nodes_[(j + b) * nx + i + a];
          const double dx = a ? -h : h;
          const double dy = b ? -k : k;
          const size_t r = 3 * b;
          const size_t c = 3 * a;
          const size_t r1 = b ? 2 : 1;
          const size_t c1 = a ? 2 : 1;
          p[r][c] = n.z;
          p[r][c1] = n.z + dx * n.x;
          p[r1][c] = n.z + dy * n.y;
          p[r1][c1] = n.z + dx * n.x + dy * n.y + dx * dy * n.xy;
        }
      double by_x = 0, by_y = 0;
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 3; ++b) {
          by_x = std::max(by_x, std::abs(p[a][b + 1] - p[a][b]) / h);
          by_y = std::max(by_y, std::abs(p[b + 1][a] - p[b][a]) / k);
        }
      steepest_ = std::max(steepest_, std::hypot(by_x, by_y));
    }
}

HeightGrid::Height HeightGrid::at(double x, double y) const {
  const Basis a(x_, x);
  const Basis b(y_, y);
  const size_t nx = x_.size();
  Height h;
  h.slope.setZero();
  h.bend.setZero();
  for (size_t j = 0; j < 2; ++j)
    for (size_t i = 0; i < 2; ++i) {
      const Node& n = nodes_[(b.cell + j) * nx + a.cell + i];
      // By the functions of y.
      const double z[2] = {n.z, n.y};
      const double s[2] = {n.x, n.xy};
      for (size_t k = 0; k < 2; ++k) {
        const size_t p = i;
        const size_t q = i + 2;
        const size_t r = j + 2 * k;
        const double value = a.value[p] * z[k] + a.value[q] * s[k];
        const double slope = a.slope[p] * z[k] + a.slope[q] * s[k];
        h.z += b.value[r] * value;
        h.slope[0] += b.value[r] * slope;
        h.slope[1] += b.slope[r] * value;
        h.bend(0, 0) += b.value[r] * (a.bend[p] * z[k] + a.bend[q] * s[k]);
        h.bend(0, 1) += b.slope[r] * slope;
        h.bend(1, 1) += b.bend[r] * value;
      }
    }
  h.bend(1, 0) = h.bend(0, 1);
  return h;
}

// The cone that opens upwards from the surface point under y, with the steepest slope of the bed, contains no
// ground.
double HeightGrid::free_radius(const Vec3& y, double distance, int /*hint*/) const {
  return std::min(distance, (y.z() - at(y.x(), y.y()).z) / std::sqrt(1 + steepest_ * steepest_));
}

std::optional<SurfacePoint> HeightGrid::query(const Vec3& y, double max_distance, int) const {
  Vec2 p = y.head<2>();
  Height f = at(p.x(), p.y());
  if (y.z() - f.z > max_distance * std::sqrt(1 + steepest_ * steepest_)) return std::nullopt;
  // Minimum of (|p - y|² + (f(p) - z)²)/2 by Newton's method, by Gauss-Newton where it is not convex.
  const auto square = [&](const Vec2& q, const Height& g) {
    return 0.5 * ((q - y.head<2>()).squaredNorm() + (g.z - y.z()) * (g.z - y.z()));
  };
  double now = square(p, f);
  const double size = std::max({1.0, std::abs(y.x()), std::abs(y.y()), std::abs(y.z())});
  for (int i = 0; i < 60; ++i) {
    const double w = f.z - y.z();
    const Vec2 gradient = p - y.head<2>() + w * f.slope;
    const Mat2 first = Mat2::Identity() + f.slope * f.slope.transpose();
    const Mat2 full = first + w * f.bend;
    const bool convex = full(0, 0) > 0 && full.determinant() > 0.05 * first.determinant();
    Vec2 step = (convex ? full : first).inverse() * -gradient;
    if (step.norm() <= 1e-15 * size) break;
    bool done = false;
    for (int cut = 0; cut < 30; ++cut, step *= 0.5) {
      const Vec2 next = p + step;
      const Height g = at(next.x(), next.y());
      const double then = square(next, g);
      // Near the solution the square is at round-off, and Newton's step is accepted.
      if (!(then <= now + 1e-14 * now)) continue;
      p = next;
      f = g;
      now = then;
      done = true;
      break;
    }
    if (!done || step.norm() <= 1e-14 * size) break;
  }
  SurfacePoint s;
  s.point = Vec3(p.x(), p.y(), f.z);
  s.normal = Vec3(-f.slope.x(), -f.slope.y(), 1).normalized();
  s.distance = s.normal.dot(y - s.point);
  if (s.distance > max_distance) return std::nullopt;
  // Principal curvatures k (concave > 0) in the tangent plane; those of the distance are -k/(1 - k d).
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = Vec3(1, 0, f.slope.x()).normalized();
  axes.col(1) = s.normal.cross(Vec3(axes.col(0)));
  const Mat2 plan = axes.topRows<2>();
  const Mat2 bends = plan.transpose() * (s.normal.z() * f.bend) * plan;
  // This function of the matrix, by linear interpolation between its eigenvalues. It is bounded at and beyond
  // the centre of curvature, where the point is not the nearest.
  const auto offset_curvature = [&](double k) { return k / std::max(1 - k * s.distance, 0.05); };
  const double middle = 0.5 * bends.trace();
  const double half = std::hypot(0.5 * (bends(0, 0) - bends(1, 1)), bends(0, 1));
  const double smallest = middle - half;
  const double low = offset_curvature(smallest);
  const double rise = half > 0 ? (offset_curvature(middle + half) - low) / (2 * half) : 0;
  s.curvature -= axes * ((low - rise * smallest) * Mat2::Identity() + rise * bends) * axes.transpose();
  return s;
}

Box HeightGrid::bounds() const { return Box::everything(); }

}  // namespace hawser
