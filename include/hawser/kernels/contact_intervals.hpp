// Where along the axis of an element there is contact: the intervals of xi in [0, 1] on which the gap to a
// surface is negative, and the Gauss points on them. Pure functions: the result depends on the gap alone.
#pragma once

#include <array>
#include <vector>

#include "hawser/math/function_ref.hpp"

namespace hawser {

struct AxisGap {
  double gap = 0;    // m, negative: contact; the smoothing of the law is subtracted already
  double slope = 0;  // m, d gap / d xi
};

// The gap along the axis. It is 1-Lipschitz in space: |d gap / d xi| <= |dx / d xi|. Where the gap is larger
// than `within` [m, >= 0] the function may return {within, 0}.
using AxisGapFunction = FunctionRef<AxisGap(double xi, double within)>;

struct ContactInterval {
  double from = 0, to = 1;
  // Whether that end is a root of the gap, which moves with the axis, and not an end of the element.
  bool from_moves = false, to_moves = false;
};

// Bounds by which contact of a piece of the axis is excluded (least_between()): on the piece the gap is no
// less than its values at the ends and these bounds allow.
struct AxisBounds {
  double slope = 0;             // m, |dx/dxi| is no larger
  double contact_distance = 0;  // m, the gap is the distance to a body minus this; 0: not known
  double bend = 0;              // m, |d²x/dxi²| is no larger
};

// The part of the axis between two intervals, without contact.
struct InactiveInterval {
  double from = 0, to = 0;
  double middle() const { return 0.5 * (from + to); }
};
std::vector<InactiveInterval> inactive_intervals(const std::vector<ContactInterval>& intervals);
std::vector<double> middles(const std::vector<InactiveInterval>& of);

// All intervals of contact, in order. Where contact cannot be excluded, the element is halved until pieces
// are 2^-levels of it (levels >= 1). A piece with an end that is not in contact is halved up to four times
// more: over the facets of a mesh the gap oscillates, and an interval that is missed on one piece would
// vanish when its end moves from the next piece into it. On each remaining piece the gap is taken to have at
// most one minimum or one maximum. Ends of intervals are roots to 1e-10. The gap is evaluated first at
// `places`, ascending.
std::vector<ContactInterval> contact_intervals(AxisGapFunction gap, const AxisBounds& bounds, int levels,
                                               const std::vector<double>& places = {});

// Where an interval splits in two, or two merge, the sum over the Gauss points jumps by the error of the
// rule. If it jumped within a step, there might be no equilibrium on either side of the jump. So during a
// step intervals are split where they were at its start: an inactive interval that is new is filled (no force
// acts in it; it is added to `filled`), and where an inactive interval has closed the contact interval is
// cut.
std::vector<ContactInterval> as_split_before(const std::vector<ContactInterval>& now,
                                             const std::vector<ContactInterval>& before,
                                             std::vector<InactiveInterval>& filled);

// Number of halvings after which pieces are no longer than 4 radii, from 1/4 to 1/32 of the element: two
// places of contact on one piece would be nearer to each other than the line is thick.
int contact_levels(double length, double radius);
// The same from 1/2 of the element on, for panels on which contact neither begins nor ends.
int panel_levels(double length, double radius);

// Intervals cut at the multiples of 2^-levels into panels, each integrated by one Gauss rule. The cuts are
// fixed, so that the integral is continuous when an interval grows, and fine, so that it hardly changes when
// an interval splits in two.
std::vector<ContactInterval> split_intervals(const std::vector<ContactInterval>& intervals, int levels);

// Gauss-Legendre on (0, 1).
struct ContactRule {
  // One more than is exact for a parabolic pressure times Hermite's cubics. The number is even, so that no
  // point is in the middle of a panel, where in symmetric cases the integrand has its kink, at an edge of the
  // body.
  static constexpr int kPoints = 4;
  static const std::array<double, kPoints>& abscissae();
  static const std::array<double, kPoints>& weight();
};

}  // namespace hawser
