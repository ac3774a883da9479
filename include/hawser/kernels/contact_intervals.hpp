// Contact along the axis of an element: the intervals of xi in [0, 1] in which the gap to a surface is
// negative, and panels with Gauss points on them. Pure functions: the result depends on the gap alone.
#pragma once

#include <cstddef>
#include <vector>

#include "hawser/math/function_ref.hpp"
#include "hawser/math/gauss_points.hpp"

namespace hawser {

struct AxisGap {
  double gap = 0;    // m, negative: contact; the smoothing of the law is already subtracted
  double slope = 0;  // m, d gap / d xi
};

// Gap along the axis. It is 1-Lipschitz in space: |d gap / d xi| <= |dx / d xi|. Where the gap is larger than
// `within` [m, >= 0] the function may return {within, 0}.
using AxisGapFunction = FunctionRef<AxisGap(double xi, double within)>;

struct ContactInterval {
  double from = 0, to = 1;
  // True if the end is a root of the gap, which moves with the axis; false for an end of the element.
  bool from_moves = false, to_moves = false;
};

// Bounds that exclude contact of a piece of the axis (smallest_between()) from the gaps at its ends.
struct AxisBounds {
  double slope = 0;             // m, upper bound of |dx/dxi|
  double contact_distance = 0;  // m, the gap is the distance to a body minus this; 0: unknown
  double bend = 0;              // m, upper bound of |d²x/dxi²|
};

// Part of the axis between two intervals, without contact.
struct InactiveInterval {
  double from = 0, to = 0;
  double middle() const { return 0.5 * (from + to); }
};
std::vector<InactiveInterval> inactive_intervals(const std::vector<ContactInterval>& intervals);
std::vector<double> middles(const std::vector<InactiveInterval>& intervals);

// All intervals in contact, in order. Where contact cannot be excluded, the element is halved to pieces of
// 2^-levels (levels >= 1). A piece with an end out of contact is halved up to four times more: over the
// facets of a mesh the gap oscillates, and an interval that is missed on one piece would vanish when its end
// moves into it from the next piece. On each remaining piece the gap is assumed to have at most one minimum
// or maximum. Ends of intervals are roots to 1e-10. The gap is first evaluated at `places`, ascending.
std::vector<ContactInterval> contact_intervals(AxisGapFunction gap, const AxisBounds& bounds, int levels,
                                               const std::vector<double>& places = {});

// Where an interval splits or two merge, the sum over the Gauss points jumps by the error of the quadrature.
// After a jump within a step there might be no equilibrium on either side. During a step intervals are
// therefore split where they were at its start: a new inactive interval is filled (without force in it; it is
// added to `filled`), and the contact interval is cut where an inactive interval has closed.
std::vector<ContactInterval> as_split_before(const std::vector<ContactInterval>& now,
                                             const std::vector<ContactInterval>& before,
                                             std::vector<InactiveInterval>& filled);

// Number of halvings for pieces of at most 4 radii, from 1/4 to 1/32 of the element: two contacts on one
// piece would be closer than the line's thickness.
int contact_levels(double length, double radius);
// The same from 1/2 of the element, for panels in which contact neither begins nor ends.
int panel_levels(double length, double radius);

// Cuts intervals at the multiples of 2^-levels into panels, each with one ContactRule. The cuts are fixed, so
// that the integral is continuous when an interval grows, and fine, so that it hardly changes when an
// interval splits.
std::vector<ContactInterval> split_intervals(const std::vector<ContactInterval>& intervals, int levels);

// One point more than is exact for a parabolic pressure times Hermite's cubics. The number is even, so that
// no point is in the middle of a panel, where in symmetric cases the integrand has its kink at an edge of the
// body.
inline constexpr int kContactPoints = 4;
using ContactRule = GaussPoints<kContactPoints>;

// Gauss point of a panel [from, to], at xi = from + place (to - from). It has the part `weight` of the panel.
struct PanelPoint {
  double place = 0, weight = 1;

  // Derivatives by an end of the panel: of weight (to - from), and of xi.
  double length_by_end(bool at_to) const { return at_to ? weight : -weight; }
  double xi_by_end(bool at_to) const { return at_to ? place : 1 - place; }
};
constexpr PanelPoint panel_point(std::size_t q) { return {ContactRule::unit[q], ContactRule::weight[q]}; }

}  // namespace hawser
