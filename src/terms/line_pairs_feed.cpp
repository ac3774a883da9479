// The part of LinePairs that knows of lines that are paid out and hauled in: where the material of the
// element at a feeder's feed point was at the start of the step, and what the feeder does on it. See
// docs/theory/line-line.md.
#include "hawser/terms/line_pairs.hpp"

namespace hawser {

// Now, and at the start of the step: of a fed element its material, of which what is at the feeder now was
// inside of it then, or has come back. Of a beam that comes out of its clamp the turning of what was inside
// is taken to be that of the clamp.
PairAxis LinePairs::axis(const Kinematics& at, int segment) const {
  const AxisEnds now = ends(at, segment);
  const int fed = fed_end(segment);
  if (fed < 0) return {now, start(segment)};
  AxisEnds before = start(segment);
  const double part = now.length / before.length;
  (fed == 0 ? before.x1 : before.x2) = AxisShape(before).point(fed == 0 ? 1 - part : part);
  before.length = now.length;
  return {now, before};
}

// The place that material has in `axis` which was at xi at the start of the step.
double LinePairs::material_of_start(int segment, const PairAxis& axis, double xi) const {
  const int fed = fed_end(segment);
  if (fed < 0) return xi;
  const double part = start(segment).length / axis.ends.length;
  return fed == 0 ? 1 - part * (1 - xi) : part * xi;
}

// J: the forces act on nodes, and the material goes past them. What it does on that way the feeder has to do;
// it also brings the material in that is pressed where it is.
double LinePairs::fed_work(const Pair& pair, const PairAxis& A, const PairAxis& B,
                           const ContactPoints& next) const {
  if (fed_end(pair.a) < 0 && fed_end(pair.b) < 0) return 0;
  // How much farther than the place xi that the nodes take along the material goes.
  const auto way = [&](int segment, const PairAxis& axis, double xi, bool at_end) -> Vec3 {
    if (fed_end(segment) < 0) return Vec3::Zero();
    AxisEnds nodes = at_end ? start(segment) : axis.ends;  // of the length with which the forces act
    nodes.length = at_end ? axis.ends.length : start(segment).length;
    const Vec3 place = AxisShape(nodes).point(xi);
    return at_end ? Vec3(place - axis.start.point(xi))
                  : Vec3(axis.now.point(material_of_start(segment, axis, xi)) - place);
  };
  double work = 0;
  for (size_t k = 0; k < kParts; ++k) {
    const bool swapped = k >= 3;
    const PairAxis &slave = swapped ? B : A, &master = swapped ? A : B;
    const int a = swapped ? pair.b : pair.a, b = swapped ? pair.a : pair.b;
    const auto add = [&](const LinePairContactPoint& h, bool at_end) {
      const Vec3 force = h.friction + h.damping_force * h.normal;
      work -= 0.5 * h.weight * force.dot(way(a, slave, h.xi, at_end) - way(b, master, h.eta, at_end));
    };
    if (pair.points)
      for (const LinePairContactPoint& h : (*pair.points)[k]) {
        add(h, false);
        work += h.weight * h.potential * (slave.ends.length / start(a).length - 1);
      }
    for (const LinePairContactPoint& h : next[k]) add(h, true);
  }
  return work;
}

}  // namespace hawser
