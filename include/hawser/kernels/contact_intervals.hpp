// Where along the axis of an element there is contact: the intervals of xi in [0, 1] on which the gap to a
// surface is negative, and the Gauss points on them. Pure: same gap, same answer.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace hawser {

struct AxisGap {
  double gap = 0;    // m, here less than 0: contact (the smoothing of the law is already taken off)
  double slope = 0;  // m, d gap / d xi
};

// The gap along the axis. 1-Lipschitz in space: |d gap / d xi| <= |dx / d xi|. May answer {within, 0} where
// the gap is larger than `within` [m, >= 0].
using AxisGapFunction = std::function<AxisGap(double xi, double within)>;

struct ContactInterval {
  double from = 0, to = 1;
  bool from_moves = false, to_moves = false;  // that end is a root of the gap, not an end of the element
};

// What excludes contact of a piece of the axis: the gap is the distance to a body less `contact_distance`
// [m], and on a piece it stays above what its ends and |dx/dxi| <= slope, |d²x/dxi²| <= bend [m] allow
// (least_between()). contact_distance = 0: not known; only that no distance changes faster than its point
// moves.
struct AxisBounds {
  double slope = 0, contact_distance = 0, bend = 0;
};

// Between two intervals, where there is none.
struct InactiveInterval {
  double from = 0, to = 0;
  double middle() const { return 0.5 * (from + to); }
};
std::vector<InactiveInterval> inactive_intervals(const std::vector<ContactInterval>& intervals);
std::vector<double> middles(const std::vector<InactiveInterval>& of);

// All intervals of contact, in order. The element is halved where contact cannot be excluded until pieces are
// 2^-levels (levels >= 1) of it, and up to four times more where an end of a piece is out of touch: over the
// facets of a mesh the gap goes up and down, and a contact that was overlooked would vanish when its end
// passes from one piece into the next. On the pieces that are left the gap has one minimum or one maximum at
// most. Ends are roots to 1e-10. At `places`, ascending, the gap is asked first.
std::vector<ContactInterval> contact_intervals(const AxisGapFunction& gap, const AxisBounds& bounds,
                                               int levels, const std::vector<double>& places = {});

// Where an interval parts in two, or two grow together, the sum over the Gauss points jumps by the rule's
// error; were it to jump within a step, there might be no equilibrium on either side of the jump. So in a
// step intervals part where they did at its start: an inactive interval that opens where all touched then is
// filled (in it there is no force anyway, its place goes to `filled`), and where one closes the interval is
// cut.
std::vector<ContactInterval> as_split_before(const std::vector<ContactInterval>& now,
                                             const std::vector<ContactInterval>& before,
                                             std::vector<InactiveInterval>& filled);

// Levels at which pieces are no longer than 4 radii, from 1/4 to 1/32 of the element: two places of contact
// on one piece would be nearer to each other than the line is thick.
int contact_levels(double length, double radius);
// Likewise from 1/2: of panels where the gap is smooth and neither ends nor opens within the element.
int panel_levels(double length, double radius);

// Intervals cut where pieces of 2^-levels meet: what one Gauss rule integrates. Fixed cuts, so that the
// integral is continuous when an interval grows; fine ones, so that it hardly changes when an interval parts
// in two.
std::vector<ContactInterval> split_intervals(const std::vector<ContactInterval>& intervals, int levels);

// Gauss-Legendre on (0, 1).
struct ContactRule {
  // One more than a parabolic pressure times Hermite's cubics needs. An even number, so that no point is in
  // the middle of a panel: in symmetric cases the integrand has its kink there, at an edge of the body.
  static constexpr int kPoints = 4;
  static const std::array<double, kPoints>& abscissae();
  static const std::array<double, kPoints>& weight();
};

}  // namespace hawser
