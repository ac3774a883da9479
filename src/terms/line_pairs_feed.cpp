// The class LinePairs for lines that are paid out and hauled in: positions at the start of the step of the
// material of the element at the feed point, and the work of the feeder on contact. See
// docs/theory/line-line.md.
#include "hawser/terms/line_pairs.hpp"

namespace hawser {

// Axis of a segment in `state` and of the same material at the start of the step. For an element at a feed
// point part of the material was then inside the feeder, or was outside and has returned. The rotation of a
// beam inside its clamp is taken as that of the clamp.
PairAxis LinePairs::axis(const Kinematics& state, int segment) const {
  const AxisEnds now = ends(state, segment);
  const int fed = fed_end(segment);
  if (fed < 0) return {now, start(segment)};
  AxisEnds before = start(segment);
  const double ratio = now.length / before.length;
  (fed == 0 ? before.x1 : before.x2) = AxisShape(before).point(fed == 0 ? 1 - ratio : ratio);
  before.length = now.length;
  return {now, before};
}

// Position xi in `axis` of the material that was at xi at the start of the step.
double LinePairs::material_of_start(int segment, const PairAxis& axis, double xi) const {
  const int fed = fed_end(segment);
  if (fed < 0) return xi;
  const double ratio = start(segment).length / axis.ends.length;
  return fed == 0 ? 1 - ratio * (1 - xi) : ratio * xi;
}

// Contact forces act on nodes while the material moves past them. The feeder does the work on the difference
// of the displacements, and supplies material that is already compressed. J.
double LinePairs::fed_work(const Pair& pair, const PairAxis& A, const PairAxis& B,
                           const ContactPoints& next) const {
  if (fed_end(pair.a) < 0 && fed_end(pair.b) < 0) return 0;
  // Displacement of the material minus that of the point at constant xi.
  const auto displacement = [&](int segment, const PairAxis& axis, double xi, bool step_end) -> Vec3 {
    if (fed_end(segment) < 0) return Vec3::Zero();
    AxisEnds nodes = step_end ? start(segment) : axis.ends;  // with the length for which the forces act
    nodes.length = step_end ? axis.ends.length : start(segment).length;
    const Vec3 place = AxisShape(nodes).point(xi);
    return step_end ? Vec3(place - axis.start.point(xi))
                    : Vec3(axis.now.point(material_of_start(segment, axis, xi)) - place);
  };
  double work = 0;
  for (size_t k = 0; k < kPasses; ++k) {
    const PassRoles pass = roles(k, pair, A, B);
    const auto add = [&](const LinePairContactPoint& h, bool step_end) {
      const Vec3 force = h.friction + h.damping_force * h.normal;
      work -= 0.5 * h.weight *
              force.dot(displacement(pass.slave_segment, pass.slave, h.xi, step_end) -
                        displacement(pass.master_segment, pass.master, h.eta, step_end));
    };
    if (pair.points)
      for (const LinePairContactPoint& h : (*pair.points)[k]) {
        add(h, false);
        work += h.weight * h.potential * (pass.slave.ends.length / start(pass.slave_segment).length - 1);
      }
    for (const LinePairContactPoint& h : next[k]) add(h, true);
  }
  return work;
}

}  // namespace hawser
