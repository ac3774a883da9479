// Interpolation of the elastic slip of the last accepted state along an axis.
#include "hawser/terms/previous_slip.hpp"

#include <algorithm>

namespace hawser {

bool previous_slip(std::span<const AxisContactPoint> points, double xi, ContactStart& s,
                   ContactRates* rates) {
  if (std::none_of(points.begin(), points.end(),
                   [&](const AxisContactPoint& p) { return p.from <= xi && xi <= p.to; }))
    return false;
  const auto after =
      std::find_if(points.begin(), points.end(), [&](const AxisContactPoint& p) { return p.xi > xi; });
  const AxisContactPoint* b = after != points.end() ? &*after : nullptr;
  const AxisContactPoint* a = after != points.begin() ? &*(after - 1) : nullptr;
  if (a && b && a->from != b->from && a->to != b->from) (xi <= a->to ? b : a) = nullptr;
  if (!a || !b) {
    const AxisContactPoint& p = a ? *a : *b;
    s.slip = p.slip;
    s.normal = p.normal;
    return true;
  }
  const double gap = b->xi - a->xi, t = (xi - a->xi) / gap;
  const SlipBetween between = slip_between(a->slip, a->normal, b->slip, b->normal, t, rates != nullptr);
  s.slip = between.slip;
  s.normal = between.normal;
  if (rates) {
    rates->start_slip = between.slip_by_t / gap;
    rates->start_normal = between.normal_by_t / gap;
  }
  return true;
}

}  // namespace hawser
