// Known free space about the axis of an element, so that a body need not be searched again while the axis
// stays in it. Pure.
#pragma once

#include <vector>

#include "hawser/kernels/bezier_axis.hpp"

namespace hawser {

// Tube about an axis, in the frame of a body, that is free of the body.
class ClearanceTube {
 public:
  // clearance: radius [m] about the axis that is free of the body; < 0: unknown.
  void set(const BezierAxis& axis, double clearance);
  // Radius of the free tube about another axis [m]; <= 0: unknown. Includes a margin for rounding.
  double radius_about(const BezierAxis& axis) const;
  // Keeps the larger tube.
  void offer(const BezierAxis& axis, double clearance) {
    if (clearance > 0 && !(radius_about(axis) >= clearance)) set(axis, clearance);
  }

 private:
  BezierAxis at_;
  double clearance_ = -1;  // m
};

// At xi on an axis nothing is nearer than `distance` [m].
struct ClearancePoint {
  double xi = 0, distance = 0;
};

// Lower bound [m] of the distance on a piece of an axis, of length w in xi, with the distances a and b at its
// ends and |dx/dxi| <= slope, |d²x/dxi²| <= bend [m]. Distances change no faster than their points move, and
// the square of a distance minus |x|² is concave, as the minimum of functions that are linear in x.
double smallest_between(double w, double a, double b, double slope, double bend);

// Lower bound for the whole axis. places: sorted by xi, at least one. worst: position between the places (or
// between them and the ends) where it is smallest.
double least_distance(const std::vector<ClearancePoint>& places, double slope, double bend, double& worst);

}  // namespace hawser
