// What goes through a volume in a step and touches it neither at its start nor at its end, or comes to its
// other side: nothing acted on it, so the step is taken again, shorter.
#include <algorithm>
#include <array>

#include "hawser/kernels/axis_sweep.hpp"
#include "hawser/terms/axis_distance.hpp"
#include "hawser/terms/contact_stiffness.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {
namespace {

constexpr std::array<double, 2> kEnds{0, 1};  // of an element
// Of the radius: shorter displacements are not tested for tunnelling in statics.
constexpr double kCreeps = 0.1;

// Of the part of the axis that may touch. De Casteljau's: the polar form of the cubic at all choices of the
// two ends.
AxisPoints part_of(const LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) {
  const AxisPoints b = axis_points(shape, pose);
  if (pair.part.all()) return b;
  const double from = pair.part.from, to = pair.part.to;
  const auto blossom = [&b](double r, double s, double t) {
    AxisPoints p = b;
    size_t n = 3;
    for (const double xi : {r, s, t}) {
      for (size_t i = 0; i < n; ++i) p[i] = (1 - xi) * p[i] + xi * p[i + 1];
      --n;
    }
    return p[0];
  };
  return {blossom(from, from, from), blossom(from, from, to), blossom(from, to, to), blossom(to, to, to)};
}

}  // namespace

Verdict LineVolumeContact::check_step(const Kinematics& trial) const {
  const bool rests = !(trial.step > 0);
  if (!rests)
    if (std::string why = deeper_than_allowed(trial); !why.empty())
      return {Verdict::Kind::shorter, std::move(why)};
  // Before the first evaluation none are known.
  const std::vector<PairBounds> made = bounds_.empty() ? pair_bounds() : std::vector<PairBounds>{};
  for (const PairBounds& g : bounds_.empty() ? made : bounds_) {
    const bool drawn = rests && is_drawn_in(trial, g);
    if (!drawn && !tunnels(trial, g)) continue;
    if (!rests) return {Verdict::Kind::shorter, "in it a line would pass through a volume"};
    const Pair& pair = pairs_[g.pair];
    const int node = mesh_.global[static_cast<size_t>(local(pair).first)];
    return {Verdict::Kind::shorter, volume_in_the_way(mesh_.mesh->place(node), volumes_.settings(pair.volume),
                                                      drawn && !volumes_.automatic(pair.volume))};
  }
  return {};
}

// Whether a group has not moved by as much as `room` [m] and its volume not at all. In motion the trial has
// been evaluated, and poses are known.
bool LineVolumeContact::near_start(const Kinematics& trial, const PairBounds& g, double clearance) const {
  if (!(clearance > 0) || way(trial, g) >= clearance) return false;
  return trial.step > 0 ? volumes_.still(g.volume)
                        : volumes_.still(g.volume, volumes_.pose_of(g.volume, trial));
}

// Where contact is too soft the axis of a line can reach the surface. Once it is inside, the nearest facet
// may be on the far side of the volume, and contact would push the line out there. An element that is inside
// at the start of the step may leave on any side.
bool LineVolumeContact::is_drawn_in(const Kinematics& trial, const PairBounds& g) const {
  const Pair& pair = pairs_[g.pair];
  if (near_start(trial, g, g.clearance) || finder_.by_gap() || is_held(pair)) return false;
  return is_inside(pair, AxisShape(ends(trial, pair.element)), volumes_.pose_of(g.volume, trial)) &&
         !is_inside(pair, pair.start.shape, pair.start.pose);
}

// Whether the element is deeper in the volume than its contact law is for: the radius of the line, or the
// last row of a table of forces.
bool LineVolumeContact::is_inside(const Pair& pair, const AxisShape& shape, const RigidPose& pose) const {
  if (!volumes_.has_back(pair.volume)) return false;
  const AxisGapFunction gap = axis_distance(volumes_.surface(pair.volume), pose, shape,
                                            pair.radius - volumes_.deepest(pair.volume, pair.radius));
  if (finder_.at_nodes())
    return std::any_of(kEnds.begin(), kEnds.end(),
                       [&](double xi) { return finder_.takes_part(pair, xi) && gap(xi, 0).gap < 0; });
  const auto intervals = contact_intervals(gap, {shape.reach(), 0, shape.bend_bound()}, pair.levels);
  return std::any_of(intervals.begin(), intervals.end(), [&](const ContactInterval& s) {
    return s.from < pair.part.to && pair.part.from < s.to;
  });
}

// Most are far away, or move less than they are thick. What is looked for at the nodes only passes between
// them as it likes, and a gap spring sees no surface. In statics, where a search creeps where it is blocked,
// shorter ways count as well.
bool LineVolumeContact::tunnels(const Kinematics& trial, const PairBounds& g) const {
  const Pair& pair = pairs_[g.pair];
  const double radius = pair.radius;
  const bool rests = !(trial.step > 0);
  const double least = rests ? kCreeps * radius : radius;
  if (near_start(trial, g, std::max(g.clearance, least)) || finder_.by_gap()) return false;
  if (rests && (!volumes_.has_back(pair.volume) || is_inside(pair, pair.start.shape, pair.start.pose)))
    return false;
  const AxisShape shape(ends(trial, pair.element));
  const RigidPose pose = volumes_.pose_of(g.volume, trial);
  const DistanceField field = distance_to(volumes_.surface(g.volume));
  const auto passes = [&](const AxisPoints& from, const AxisPoints& to, double free) {
    const double way = way_of(from, to);
    return way > std::max(free, least) && goes_through(field, from, to, way > radius ? radius : least, rests);
  };
  if (!finder_.at_nodes())
    return passes(part_of(pair, pair.start.shape, pair.start.pose), part_of(pair, shape, pose),
                  LineVolumeFinder::clearance_at_start(pair));
  return std::any_of(kEnds.begin(), kEnds.end(), [&](double xi) {
    AxisPoints from, to;
    from.fill(pair.start.pose.to_body(pair.start.shape.point(xi))), to.fill(pose.to_body(shape.point(xi)));
    return finder_.takes_part(pair, xi) && passes(from, to, 0);
  });
}

}  // namespace hawser
