// Where along the axis of an element there is contact: the stretches of xi in [0, 1] on which the gap to a
// surface is negative, and the Gauss points on them. Pure: same gap, same answer.
#pragma once

#include <array>
#include <vector>

namespace hawser {

struct AxisGap {
  double gap = 0;    // m, here less than 0: contact (the smoothing of the law is already taken off)
  double slope = 0;  // m, d gap / d xi
};

// The gap along the axis. 1-Lipschitz in space: |d gap / d xi| <= |dx / d xi|.
class AxisGapFunction {
 public:
  virtual ~AxisGapFunction() = default;
  // May answer {within, 0} where the gap is larger than `within` [m, >= 0].
  virtual AxisGap at(double xi, double within) = 0;
};

struct ContactStretch {
  double from = 0, to = 1;
  bool from_moves = false, to_moves = false;  // that end is a root of the gap, not an end of the element
};

// All stretches of contact, in order. reach [m]: a bound of |dx/dxi|. The element is halved where contact
// cannot be excluded until pieces are 2^-levels (levels >= 1) of it; on such a piece the gap has one minimum
// or one maximum at most. Ends are roots to 1e-14.
std::vector<ContactStretch> contact_stretches(AxisGapFunction& gap, double reach, int levels);

// Levels at which pieces are no longer than 4 radii, from 1/4 to 1/32 of the element: two places of contact
// on one piece would be nearer to each other than the line is thick.
int contact_levels(double length, double radius);

// Stretches cut where pieces of 2^-levels meet: what one Gauss rule integrates. Fixed cuts, so that the
// integral is continuous when a stretch grows; fine ones, so that it hardly changes when a stretch parts in
// two.
std::vector<ContactStretch> cut_stretches(const std::vector<ContactStretch>& stretches, int levels);

// Gauss-Legendre on (0, 1).
struct ContactRule {
  static constexpr int kPoints = 4;  // a pressure as a parabola, times Hermite's cubics, with one to spare
  static const std::array<double, kPoints>& place();
  static const std::array<double, kPoints>& weight();
};

}  // namespace hawser
