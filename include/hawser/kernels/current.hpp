// Current by depth: straight lines between rows of a table, or a power law.
#pragma once

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

}  // namespace hawser
