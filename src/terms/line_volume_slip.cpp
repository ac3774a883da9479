// The class LineVolumeFinder: initial positions and slip of the points that touch in a trial.
#include "hawser/terms/line_volume_finder.hpp"
#include "hawser/terms/previous_slip.hpp"

namespace hawser {
// Material that did not touch at the start has a gap and no slip.
ContactStart LineVolumeFinder::start(LineVolumePair& pair, int group, double xi, ContactRates* rates) const {
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
  if (previous_slip(pair.previous(group), xi, s, rates)) return s;
  const double within = 2 * shape.slope_bound() + pair.length;
  const auto p = query(pair, group, xi, s.point, pair.contact_distance + within, true);
  s.gap = p ? p->distance - pair.radius : within + pair.smoothing();
  if (p && rates) rates->start_gap = p->normal.dot(slope);
  return s;
}

}  // namespace hawser
