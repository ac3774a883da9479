// The class LineVolumeFinder: where the points that touch in a trial were at the start of the step, and their
// slip there.
#include <algorithm>

#include "hawser/terms/line_volume_finder.hpp"

namespace hawser {
namespace {

// Interpolates the slip between the contact points of one interval.
void take_slip(const std::vector<AxisContactPoint>& previous, double xi, ContactStart& s,
               ContactRates* rates) {
  const auto after =
      std::find_if(previous.begin(), previous.end(), [&](const AxisContactPoint& p) { return p.xi > xi; });
  const AxisContactPoint* b = after != previous.end() ? &*after : nullptr;
  const AxisContactPoint* a = after != previous.begin() ? &*(after - 1) : nullptr;
  if (a && b && a->from != b->from && a->to != b->from) (xi <= a->to ? b : a) = nullptr;
  if (!a && !b) return;
  if (!a || !b) {
    const AxisContactPoint& p = a ? *a : *b;
    s.slip = p.slip;
    s.normal = p.normal;
    return;
  }
  const double gap = b->xi - a->xi, t = (xi - a->xi) / gap;
  const SlipBetween between = slip_between(a->slip, a->normal, b->slip, b->normal, t, rates != nullptr);
  s.slip = between.slip;
  s.normal = between.normal;
  if (rates) {
    rates->start_slip = between.slip_by_t / gap;
    rates->start_normal = between.normal_by_t / gap;
  }
}

}  // namespace

// Material that did not touch at the start has no slip, and has a gap.
ContactStart LineVolumeFinder::start(const LineVolumePair& pair, int group, double xi,
                                     ContactRates* rates) const {
  const AxisShape& shape = pair.start.shape;
  const RigidPose& pose = pair.start.pose;
  const Quat back = pose.rotation.conjugate();
  ContactStart s;
  s.point = pose.to_body(shape.point(xi));
  const Vec3 slope = back * shape.slope(xi);
  s.tangent = slope.normalized();
  if (rates) {
    rates->start_point = slope;
    const Vec3 bend = back * shape.bend(xi);
    rates->start_tangent = (bend - s.tangent * s.tangent.dot(bend)) / slope.norm();
  }
  const std::vector<AxisContactPoint>& previous = pair.previous(group);
  if (std::any_of(previous.begin(), previous.end(),
                  [&](const auto& p) { return p.from <= xi && xi <= p.to; })) {
    take_slip(previous, xi, s, rates);
    return s;
  }
  const double within = 2 * shape.slope_bound() + pair.length;
  const auto p = query(pair, group, xi, s.point, pair.contact_distance + within, true);
  s.gap = p ? p->distance - pair.radius : within + pair.smoothing();
  if (p && rates) rates->start_gap = p->normal.dot(slope);
  return s;
}

}  // namespace hawser
