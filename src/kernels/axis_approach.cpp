// Bisection of two moving element axes, with continuous collision detection of the chords of their pieces,
// for the check of a step of contact between lines.
#include "hawser/kernels/axis_approach.hpp"

#include <algorithm>

#include "hawser/geometry/segment_ccd.hpp"
#include "hawser/geometry/segment_distance.hpp"

namespace hawser {
namespace {

// Relative accuracy of the chords and of the search for the time, as fractions of the distance in question.
constexpr double kChord = 0.1, kSearch = 0.05;
constexpr double kBelow = 0.75;
// Any fraction of the initial distance, so that it is never the limit.
constexpr double kAnyPart = 1e9;
// Largest number of halvings of an axis, after which chords are within rounding of it.
constexpr int kMaxHalvings = 14;

// Axis at both ends of the step.
struct Moving {
  const AxisShape &from, &to;
  double bend;  // m, largest |d²x/dxi²| during the step

  Moving(const AxisShape& f, const AxisShape& t)
      : from(f), to(t), bend(std::max(f.bend_bound(), t.bend_bound())) {}
};

struct AxisInterval {
  double xi = 0;  // start
  int level = 0;  // length is 2^-level of the axis

  double span() const { return 1.0 / (1 << level); }
  AxisInterval half(int which) const { return {xi + 0.5 * which * span(), level + 1}; }
  MovingSegment chord(const Moving& m) const {
    const double end = xi + span();
    return {m.from.point(xi), m.from.point(end), m.to.point(xi), m.to.point(end)};
  }
  // m, upper bound of the axis's distance from its chord
  double error(const Moving& m) const { return 0.125 * span() * span() * m.bend; }
};

class Search {
 public:
  Search(const Moving& a, const Moving& b, const ApproachLimits& limits) : a_(a), b_(b), limits_(limits) {}

  Sides bisect(const AxisInterval& p, const AxisInterval& q) const {
    const MovingSegment A = p.chord(a_);
    const MovingSegment B = q.chord(b_);
    const double ea = p.error(a_);
    const double eb = q.error(b_);
    const double e = ea + eb;
    if (first_approach(A, B, limits_.min_distance + e, kSearch * limits_.min_distance) > 1)
      return Sides::kept;
    const double distance = closest_points_of_segments(A.from0, A.to0, B.from0, B.to0).distance;
    const bool finest = e == 0 || (ea >= eb ? p : q).level == kMaxHalvings;
    const bool test_crossing = limits_.no_side >= 0;
    if (finest && test_crossing && distance <= limits_.no_side + e) return Sides::crossing;
    double threshold = std::min(limits_.min_distance, limits_.part * std::max(distance - e, 0.0));
    threshold = std::max(threshold, limits_.floor);
    if (e <= kChord * threshold)
      return threshold > 0 && first_approach(A, B, threshold + e, kSearch * threshold) > 1 ? Sides::kept
                                                                                           : Sides::near;
    if (finest) return Sides::near;
    Sides all = Sides::kept;
    for (const int i : {0, 1}) {
      const Sides s = ea >= eb ? bisect(p.half(i), q) : bisect(p, q.half(i));
      if (s == Sides::crossing || (s == Sides::near && !test_crossing)) return s;
      if (s == Sides::near) all = s;
    }
    return all;
  }

 private:
  const Moving &a_, &b_;
  const ApproachLimits& limits_;
};

}  // namespace

Sides sides_kept(const AxisShape& a0, const AxisShape& a1, const AxisShape& b0, const AxisShape& b1,
                 const ApproachLimits& limits) {
  const Moving a(a0, a1);
  const Moving b(b0, b1);
  const Sides kept = Search(a, b, limits).bisect({}, {});
  if (kept != Sides::near || !(limits.floor > 0)) return kept;
  // Axes already nearer, by more than the error of the chords, only need to satisfy the other limits.
  const Moving start_a(a0, a0);
  const Moving start_b(b0, b0);
  const ApproachLimits below{kBelow * limits.floor, kAnyPart, 0, -1};
  if (Search(start_a, start_b, below).bisect({}, {}) == Sides::kept) return kept;
  ApproachLimits others = limits;
  others.floor = 0;
  return Search(a, b, others).bisect({}, {});
}

}  // namespace hawser
