// The normal force of contact, given as a table over the penetration.
#pragma once

#include <span>
#include <vector>

#include "hawser/kernels/monotone_cubic.hpp"

namespace hawser {

// A monotone cubic through the rows. Starts at zero penetration with no force and no slope, so that nothing
// jumps when a surface is met; beyond the last row it goes on straight with the slope there.
class ContactForceTable {
 public:
  using Row = MonotoneCubic::Row;  // penetration [m], force [N, or by basis]

  // Penetrations positive and increasing, forces not negative and not falling, the last one positive;
  // std::invalid_argument with the number of the row (from 1) otherwise. A row at zero penetration with no
  // force may lead.
  explicit ContactForceTable(std::span<const Row> rows);

  struct Value {
    double force = 0, slope = 0, bend = 0;  // and first two derivatives by the penetration
    double potential = 0;                   // its integral
  };
  Value at(double penetration) const;  // zero below 0

  double largest_slope() const { return curve_.largest_slope(); }
  const std::vector<Row>& rows() const { return curve_.rows(); }  // from (0, 0) on

 private:
  MonotoneCubic curve_;
};

}  // namespace hawser
