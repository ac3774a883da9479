// How near to the seabed a line begins to press on it.
#pragma once

#include <algorithm>

#include "hawser/model/bed.hpp"

namespace hawser::model {

// Half width of the smooth start of the bed's force [m], which begins at this gap. weight, stiffness: of a
// line under water and of the bed under it, both per the same length. A fifth of what the line at rest sinks
// in: what rests lies beyond the ramp, what touches down is soft. A table of forces has none.
inline double bed_smoothing(const Seabed& bed, double radius, double weight, double stiffness) {
  if (bed.force_table) return 0;
  return bed.smoothing.value_or(std::max(0.002 * radius, 0.2 * std::max(weight, 0.0) / stiffness));
}

// m, height of the line's axis above the bed at which the force begins.
inline double touching_height(const Case& c, const LineType& t) {
  const Seabed& bed = c.environment.seabed;
  const double radius = 0.5 * t.contact_diameter, weight = submerged_weight(c, t);
  const double width = bed.basis == StiffnessBasis::per_length ? 1 : t.contact_diameter;
  return radius + bed_smoothing(bed, radius, weight, bed.normal_stiffness * width);
}

}  // namespace hawser::model
