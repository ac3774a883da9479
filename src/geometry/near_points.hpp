// Search for points near each other, sorted along a direction to which no regular mesh is perpendicular.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser::detail {

class NearPoints {
 public:
  // The points must outlive this object.
  explicit NearPoints(std::span<const Vec3> points) : points_(points), order_(points.size()), place_(order_) {
    const Vec3 direction = Vec3(std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0)).normalized();
    for (const Vec3& p : points) along_.push_back(direction.dot(p));
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return along(a) < along(b); });
    for (size_t k = 0; k < order_.size(); ++k) place_[static_cast<size_t>(order_[k])] = static_cast<int>(k);
  }
  // Calls visit(w) for all other points w within the distance `within` [m] of point v.
  template <class Visit>
  void each(int v, double within, const Visit& visit) const {
    const double rounding = 1e-15 * point(v).norm();
    for (const int step : {-1, 1})
      for (int k = place_[static_cast<size_t>(v)] + step; k >= 0 && k < static_cast<int>(order_.size());
           k += step) {
        const int w = order_[static_cast<size_t>(k)];
        if (std::abs(along(w) - along(v)) > within + rounding) break;
        if ((point(w) - point(v)).norm() <= within) visit(w);
      }
  }

 private:
  double along(int v) const { return along_[static_cast<size_t>(v)]; }
  const Vec3& point(int v) const { return points_[static_cast<size_t>(v)]; }

  std::span<const Vec3> points_;
  std::vector<double> along_;  // m
  std::vector<int> order_, place_;
};

}  // namespace hawser::detail
