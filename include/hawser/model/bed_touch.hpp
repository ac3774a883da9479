// Height above the seabed at which its force on a line begins.
#pragma once

#include <algorithm>

#include "hawser/model/bed.hpp"

namespace hawser::model {

// Half width of the smooth start of the bed force [m], which begins at this gap. weight, stiffness: submerged
// weight of the line and stiffness of the bed, both per the same length. A fifth of the penetration at rest:
// a line at rest is beyond the smooth part, and touchdown is soft. 0 with a force table.
inline double bed_smoothing(const Seabed& bed, double radius, double weight, double stiffness) {
  if (bed.force_table) return 0;
  return bed.smoothing.value_or(std::max(0.002 * radius, 0.2 * std::max(weight, 0.0) / stiffness));
}

// Height of the line's axis above the bed at which the force begins, m.
inline double touching_height(const Case& c, const LineType& t) {
  const Seabed& bed = c.environment.seabed;
  const double radius = 0.5 * t.contact_diameter;
  const double weight = submerged_weight(c, t);
  const double width = bed.basis == StiffnessBasis::per_length ? 1 : t.contact_diameter;
  return radius + bed_smoothing(bed, radius, weight, bed.normal_stiffness * width);
}

}  // namespace hawser::model
