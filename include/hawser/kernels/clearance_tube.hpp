// How far the axis of an element may move before it can meet a body: what was once found free about it is not
// looked for again. Pure.
#pragma once

#include <vector>

#include "hawser/kernels/bezier_axis.hpp"

namespace hawser {

// A tube about an axis, in the frame of a body, in which nothing is met.
class ClearanceTube {
 public:
  // clearance: m, what no point of the axis touches within; less than zero: nothing is known.
  void set(const BezierAxis& axis, double clearance);
  // How much of it is left about another axis, m; zero or less: nothing is known. Less than there is, by more
  // than the rounding of a distance.
  double left(const BezierAxis& axis) const;
  // The larger one stays.
  void offer(const BezierAxis& axis, double clearance) {
    if (clearance > 0 && !(left(axis) >= clearance)) set(axis, clearance);
  }

 private:
  BezierAxis at_;
  double clearance_ = -1;  // m
};

// That at xi on an axis nothing is nearer than `distance` [m].
struct ClearancePoint {
  double xi = 0, distance = 0;
};

// m: of a piece of an axis, w long in xi, with the distances a and b at its ends, none on it is less;
// |dx/dxi| <= slope, |d²x/dxi²| <= bend [m]. Distances change no faster than their points move, and the
// square of one less |x|² is concave, being the least of functions that are linear in x.
double least_between(double w, double a, double b, double slope, double bend);

// The same of the whole axis: places by xi, one at least. worst: where between the places (or between them
// and the ends) it is least.
double least_distance(const std::vector<ClearancePoint>& places, double slope, double bend, double& worst);

}  // namespace hawser
