// How far the axis of an element may move before it can meet a body: what was once found free about it is not
// looked for again. Pure.
#pragma once

#include <array>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

// Bézier points of an axis in the body's frame [m]: no point of an axis is farther from that of another than
// the farthest of these from its own.
using AxisPoints = std::array<Vec3, 4>;

// A tube about an axis in which nothing is met.
class ClearanceTube {
 public:
  // clearance: m, what no point of the axis touches within; less than zero: nothing is known.
  void set(const AxisPoints& axis, double clearance);
  // How much of it is left about another axis, m; zero or less: nothing is known. Less than there is, by more
  // than the rounding of a distance.
  double left(const AxisPoints& axis) const;
  // The larger one stays.
  void offer(const AxisPoints& axis, double clearance) {
    if (clearance > 0 && !(left(axis) >= clearance)) set(axis, clearance);
  }

 private:
  AxisPoints at_;
  double clearance_ = -1;  // m
};

// That at xi on an axis nothing is nearer than `distance` [m].
struct ClearancePoint {
  double xi = 0, distance = 0;
};

// The same of the whole axis, |dx/dxi| <= reach, |d²x/dxi²| <= bend [m]: places by xi, one at least. As in
// contact_intervals(): distances change no faster than their points move, and the square of one less |x|² is
// concave. worst: where between the places (or between them and the ends) it is least.
double least_distance(const std::vector<ClearancePoint>& places, double reach, double bend, double& worst);

}  // namespace hawser
