// Current by depth: straight lines between rows of a table, or a power law. A factor of it by time.
#pragma once

#include <utility>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

class CurrentProfile {
 public:
  struct Row {
    double depth = 0;              // m below the surface
    Vec3 velocity = Vec3::Zero();  // m/s
  };
  CurrentProfile() = default;
  // Rows with growing depth; constant above the first and below the last.
  explicit CurrentProfile(std::vector<Row> rows);
  // velocity (1 - depth/water_depth)^exponent; above the surface as at it.
  CurrentProfile(const Vec3& velocity, double exponent, double water_depth);

  bool none() const { return rows_.empty(); }
  // At a depth [m]; d velocity/d depth [1/s].
  void at(double depth, Vec3& velocity, Vec3& by_depth) const;

 private:
  std::vector<Row> rows_;
  double exponent_ = 0, water_depth_ = 0;
};

// A number by time: straight lines between rows, constant before the first and after the last; 1 without
// rows.
class TimeFactor {
 public:
  using Row = std::pair<double, double>;  // s, factor
  TimeFactor() = default;
  // Rows with growing time; std::invalid_argument otherwise.
  explicit TimeFactor(std::vector<Row> rows);

  double at(double time) const;
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

}  // namespace hawser
