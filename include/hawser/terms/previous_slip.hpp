// Elastic slip of friction at a point of an axis at the start of a step.
#pragma once

#include <algorithm>

#include "hawser/kernels/contact_rates.hpp"

namespace hawser {

// Sets slip, normal and peak of `start` at xi, and on request their derivatives along the axis, from the
// contact points of the last accepted state, sorted by xi; between points of one interval they are
// interpolated. Returns false, without setting anything, if the material at xi did not touch. Points: vector
// or span of contact points with xi, from, to, slip, normal and peak.
template <class Points>
bool previous_slip(const Points& points, double xi, ContactStart& s, ContactRates* rates) {
  using Point = typename Points::value_type;
  const auto after = std::upper_bound(points.begin(), points.end(), xi,
                                      [](double place, const Point& p) { return place < p.xi; });
  const Point* b = after != points.end() ? &*after : nullptr;
  const Point* a = after != points.begin() ? &*(after - 1) : nullptr;
  // Intervals do not overlap, so the one at xi is that of a neighbour.
  const auto touched = [xi](const Point* p) { return p && p->from <= xi && xi <= p->to; };
  if (!touched(a) && !touched(b)) return false;
  if (a && b && a->from != b->from && a->to != b->from) (xi <= a->to ? b : a) = nullptr;
  if (!a || !b) {
    const Point* p = a ? a : b;
    if (!p) return false;
    s.slip = p->slip;
    s.normal = p->normal;
    s.peak = p->peak;
    return true;
  }
  // With peaks P the force P s of the springs is interpolated: its energy (P s)²/(2 P) is convex in P s and
  // P, so that none is generated.
  const double gap = b->xi - a->xi;
  const double t = (xi - a->xi) / gap;
  s.peak = (1 - t) * a->peak + t * b->peak;
  double of_b = t;
  double of_b_by_t = 1;
  if (s.peak > 0) {
    of_b *= b->peak / s.peak;
    of_b_by_t = a->peak * b->peak / (s.peak * s.peak);
  }
  const SlipBetween between = slip_between(a->slip, a->normal, b->slip, b->normal, of_b, rates != nullptr);
  s.slip = between.slip;
  s.normal = between.normal;
  if (rates) {
    rates->start_peak = (b->peak - a->peak) / gap;
    rates->start_slip = between.slip_by_t * (of_b_by_t / gap);
    rates->start_normal = between.normal_by_t * (of_b_by_t / gap);
  }
  return true;
}

}  // namespace hawser
