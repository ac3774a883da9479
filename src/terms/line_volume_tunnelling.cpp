// The class LineVolumeContact: detects elements that pass through a volume in a step without contact at its
// start and end, or that reach its other side. No force acted on them, so the step is repeated with a shorter
// length; likewise if a line is deeper in a volume than the range of its law. At rest such a depth is an
// error.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "hawser/advice/contact_stiffness.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/kernels/axis_sweep.hpp"
#include "hawser/terms/axis_distance.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {
namespace {

constexpr std::array<double, 2> kEnds{0, 1};  // positions along an element
// Smallest displacement, in radii, that statics tests for tunnelling; in motion it is one radius.
constexpr double kMinDisplacementInStatics = 0.1;

// Part of the axis that may touch.
BezierAxis part_of(const LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) {
  const BezierAxis axis = bezier_in(pose, shape);
  return pair.part.all() ? axis : axis.part(pair.part.from, pair.part.to);
}

}  // namespace

Verdict LineVolumeContact::check_step(const Kinematics& trial) const {
  const bool rests = !trial.moves();
  if (!rests)
    if (const auto deep = deeper_than_allowed(trial)) return {Verdict::Kind::shorter, *deep};
  const std::vector<RigidPose> poses = volumes_.poses(trial);
  std::optional<AxisShape> shape;
  int element = -1;  // element of `shape`; the pairs of an element are successive
  for (const Pair& pair : pairs_) {
    if (pair.element != element) {
      element = pair.element;
      shape.emplace(ends(trial, element));
    }
    const RigidPose& pose = poses[volumes_.body(pair.volume)];
    const bool pulled_in = rests && is_pulled_in(pair, *shape, pose);
    if (!pulled_in && !tunnels(pair, *shape, pose, rests)) continue;
    const advice::VolumeLaw law = volumes_.law_of(pair.volume);
    const std::string place = mesh_.mesh->place(mesh_.global[local(pair).first]);
    if (!rests) return {Verdict::Kind::shorter, advice::LinePassesVolume{place, law.volume}};
    return {Verdict::Kind::shorter,
            advice::PulledThrough{
                .law = law, .place = place, .too_soft = pulled_in && !volumes_.automatic(pair.volume)}};
  }
  return {};
}

void LineVolumeContact::check_at_rest(const Kinematics& equilibrium) {
  const auto deep = deeper_than_allowed(equilibrium);
  const std::string why = first_text(volumes_.comm(), deep ? advice::too_deep_at_rest(*deep) : "");
  if (!why.empty()) throw SolveError(why);
}

std::optional<advice::TooDeep> LineVolumeContact::deeper_than_allowed(const Kinematics& state) const {
  if (finder_.by_gap()) return std::nullopt;  // the compression of gap springs has no limit
  const Pair* deepest_pair = nullptr;
  double deepest = 0, xi = 0;
  for (const Pair& pair : pairs_) {
    if (is_held(pair) || pair.trial.contact.quadrature.empty()) continue;
    // A pair that has not moved since it was clear is not evaluated in a trial; its result is older.
    if (!pair.trial.contact.configuration.shape.same_axis(AxisShape(ends(state, pair.element)))) continue;
    const double limit = volumes_.depth_limit(pair.volume, pair.radius);
    for (const QuadraturePoint& point : pair.trial.contact.quadrature)
      if (const double depth = pair.radius - point.surface.distance; depth > std::max(limit, deepest)) {
        deepest_pair = &pair;
        deepest = depth;
        xi = point.xi;
      }
  }
  if (!deepest_pair) return std::nullopt;
  const LocalElement& e = local(*deepest_pair);
  const int node = mesh_.global[xi < 0.5 ? e.first : e.second];
  return advice::TooDeep{.law = volumes_.law_of(deepest_pair->volume),
                         .place = mesh_.mesh->place(node),
                         .depth = deepest,
                         .radius = deepest_pair->radius,
                         .time = state.time};
}

// Detects an axis that reached the surface because contact is too soft. Inside, the nearest facet may be on
// the far side of the volume, and contact would push the line out there. An element that is inside at the
// start of the step may leave on any side.
bool LineVolumeContact::is_pulled_in(const Pair& pair, const AxisShape& shape, const RigidPose& pose) const {
  if (finder_.by_gap() || is_held(pair)) return false;
  return !(pair.cache.clearance.radius_about(bezier_in(pose, shape)) > 0) && is_inside(pair, shape, pose) &&
         !is_inside(pair, pair.start.shape, pair.start.pose);
}

// True if the element is deeper in the volume than the range of its contact law: the radius of the line, or
// the last row of a table of forces.
bool LineVolumeContact::is_inside(const Pair& pair, const AxisShape& shape, const RigidPose& pose) const {
  if (!volumes_.has_back(pair.volume)) return false;
  auto gap = axis_distance(volumes_.surface(pair.volume), pose, shape,
                           pair.radius - volumes_.depth_limit(pair.volume, pair.radius));
  if (finder_.at_nodes())
    return std::any_of(kEnds.begin(), kEnds.end(),
                       [&](double xi) { return finder_.takes_part(pair, xi) && gap(xi, 0).gap < 0; });
  const auto intervals = contact_intervals(gap, {shape.slope_bound(), 0, shape.bend_bound()}, pair.levels);
  return std::any_of(intervals.begin(), intervals.end(), [&](const ContactInterval& s) {
    return s.from < pair.part.to && pair.part.from < s.to;
  });
}

// True if the element passes through the volume. Most elements are far away or move by less than their
// radius. With contact at nodes only the nodes are tested; gap springs have no surface and are not tested. In
// statics shorter displacements count as well, because a blocked solution advances in small steps.
bool LineVolumeContact::tunnels(const Pair& pair, const AxisShape& shape, const RigidPose& pose,
                                bool rests) const {
  if (finder_.by_gap()) return false;
  const double radius = pair.radius;
  const double min_displacement = rests ? kMinDisplacementInStatics * radius : radius;
  const BezierAxis from = part_of(pair, pair.start.shape, pair.start.pose);
  const BezierAxis to = part_of(pair, shape, pose);
  if (from.farthest_distance(to) <= std::max(min_displacement, LineVolumeFinder::clearance_at_start(pair)))
    return false;
  if (rests && (!volumes_.has_back(pair.volume) || is_inside(pair, pair.start.shape, pair.start.pose)))
    return false;
  auto field = distance_to(volumes_.surface(pair.volume));
  const auto passes = [&](const BezierAxis& before, const BezierAxis& after) {
    return passes_through(field, before, after,
                          before.farthest_distance(after) > radius ? radius : min_displacement, rests);
  };
  if (!finder_.at_nodes()) return passes(from, to);
  return std::any_of(kEnds.begin(), kEnds.end(), [&](double xi) {
    BezierAxis before, after;
    before.b.fill(pair.start.pose.to_body(pair.start.shape.point(xi)));
    after.b.fill(pose.to_body(shape.point(xi)));
    return finder_.takes_part(pair, xi) && passes(before, after);
  });
}

}  // namespace hawser
