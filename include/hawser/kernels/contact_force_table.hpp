// Normal force of contact as a table by penetration.
#pragma once

#include <span>
#include <vector>

#include "hawser/kernels/monotone_cubic.hpp"

namespace hawser {

// Monotone cubic through the rows. Force and slope are zero at zero penetration, so that the force is smooth
// at first contact; beyond the last row it is linear.
class ContactForceTable {
 public:
  using Row = MonotoneCubic::Row;  // penetration [m], force [N, or by basis]

  // Penetrations positive and increasing, forces not negative and not decreasing, the last one positive; a
  // first row (0, 0) is allowed. Throws std::invalid_argument with the number of the row (from 1).
  explicit ContactForceTable(std::span<const Row> rows);

  struct Value {
    double force = 0, slope = 0, bend = 0;  // force, and its first two derivatives by the penetration
    double potential = 0;                   // integral of the force
  };
  Value at(double penetration) const;  // zero below 0

  double largest_slope() const { return curve_.largest_slope(); }
  const std::vector<Row>& rows() const { return curve_.rows(); }  // including (0, 0)

 private:
  MonotoneCubic curve_;
};

}  // namespace hawser
