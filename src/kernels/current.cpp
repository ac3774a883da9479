// Current velocity by depth from a table or a power law, with its derivative, and its time factor.
#include "hawser/kernels/current.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/math/broken_line.hpp"

namespace hawser {

CurrentProfile::CurrentProfile(std::vector<Row> rows) : rows_(std::move(rows)) {
  for (size_t i = 1; i < rows_.size(); ++i)
    if (!(rows_[i].depth > rows_[i - 1].depth)) throw std::invalid_argument("depths of a current must grow");
}

CurrentProfile::CurrentProfile(const Vec3& velocity, double exponent, double water_depth)
    : rows_{{0, velocity}}, exponent_(exponent), water_depth_(water_depth) {
  if (exponent > 0 && !(water_depth > 0)) throw std::invalid_argument("a power law needs the water's depth");
}

// Power law of the height above the bed over the depth d of the water, u = 1 - depth/d:
//   v = v0 u^p,   dv/d depth = -p u^(p - 1) v0/d
void CurrentProfile::at(double depth, Vec3& velocity, Vec3& by_depth) const {
  by_depth.setZero();
  if (rows_.empty()) {
    velocity.setZero();
    return;
  }
  if (exponent_ > 0) {
    velocity = rows_.front().velocity;
    if (depth <= 0) return;
    // The slope is unbounded near the bed: linear over the last thousandth of the depth.
    constexpr double kLast = 1e-3;
    const double up = 1 - depth / water_depth_;
    const double r = std::max(up, kLast);
    const double p = std::pow(r, exponent_);
    if (up >= kLast) {
      by_depth = -exponent_ * p / (r * water_depth_) * velocity;
      velocity *= p;
    } else if (up > 0) {
      by_depth = -p / (kLast * water_depth_) * velocity;
      velocity *= p * up / kLast;
    } else
      velocity.setZero();
    return;
  }
  if (depth <= rows_.front().depth || rows_.size() == 1) {
    velocity = rows_.front().velocity;
  } else if (depth >= rows_.back().depth) {
    velocity = rows_.back().velocity;
  } else {
    const auto above = std::upper_bound(rows_.begin(), rows_.end(), depth,
                                        [](double d, const Row& r) { return d < r.depth; });
    const Row& b = *above;
    const Row& a = *(above - 1);
    by_depth = (b.velocity - a.velocity) / (b.depth - a.depth);
    velocity = a.velocity + (depth - a.depth) * by_depth;
  }
}

TimeFactor::TimeFactor(std::vector<Row> rows) : rows_(std::move(rows)) {
  for (size_t i = 1; i < rows_.size(); ++i)
    if (!(rows_[i].first > rows_[i - 1].first)) throw std::invalid_argument("times of a factor must grow");
}

double TimeFactor::at(double time) const { return rows_.empty() ? 1 : on_broken_line(rows_, time); }

}  // namespace hawser
