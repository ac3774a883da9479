// Current velocity by depth, from a table with linear interpolation or a power law, and a time factor.
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
  // Rows with increasing depth; constant above the first and below the last.
  explicit CurrentProfile(std::vector<Row> rows);
  // velocity (1 - depth/water_depth)^exponent; above the surface its value at the surface.
  CurrentProfile(const Vec3& velocity, double exponent, double water_depth);

  bool none() const { return rows_.empty(); }
  // Velocity at a depth [m], and d velocity/d depth [1/s].
  void at(double depth, Vec3& velocity, Vec3& by_depth) const;

 private:
  std::vector<Row> rows_;
  double exponent_ = 0, water_depth_ = 0;
};

// Factor by time: linear between rows, constant before the first and after the last; 1 without rows.
class TimeFactor {
 public:
  using Row = std::pair<double, double>;  // s, factor
  TimeFactor() = default;
  // Rows with increasing time; throws std::invalid_argument.
  explicit TimeFactor(std::vector<Row> rows);

  double at(double time) const;
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

}  // namespace hawser
