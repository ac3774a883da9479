// What goes through a volume in a step and touches it neither at its start nor at its end, or comes to its
// other side: nothing acted on it, so the step is taken again, shorter.
#include <algorithm>
#include <array>

#include "hawser/kernels/axis_sweep.hpp"
#include "hawser/terms/body_contact.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {
namespace {

// All of it, whatever its walls.
DistanceField distance_to(const Surface& surface) {
  return [&surface, hint = -1](const Vec3& x, double within, Vec3& normal) mutable -> std::optional<double> {
    const auto p = surface.query(x, within, hint);
    if (!p) return std::nullopt;
    hint = p->triangle, normal = p->normal;
    return p->distance;
  };
}

constexpr std::array<double, 2> kEnds{0, 1};  // of an element

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

Verdict LineVolumeContact::judge(const Kinematics& trial) const {
  if (!(trial.step > 0)) return {};
  if (std::string why = deeper_than_allowed(trial); !why.empty())
    return {Verdict::Kind::shorter, std::move(why)};
  if (tunnels(trial)) return {Verdict::Kind::shorter, "in it a line would pass through a volume"};
  return {};
}

// Most are far away, or move less than they are thick. What is looked for at the nodes only passes between
// them as it likes, and a gap spring sees no surface.
bool LineVolumeContact::tunnels(const Kinematics& trial) const {
  if (finder_.by_gap()) return false;
  return std::any_of(groups_.begin(), groups_.end(), [&](const Group& g) {
    const Pair& pair = pairs_[g.first];
    const double radius = pair.radius;
    if (volumes_.still(g.volume) && way(trial, g) < std::max(g.room, radius)) return false;
    const AxisShape shape(ends(trial, pair.element));
    const RigidPose pose = volumes_.pose_of(g.volume, trial);
    const DistanceField field = distance_to(volumes_.surface(g.volume));
    const auto passes = [&](const AxisPoints& from, const AxisPoints& to, double free) {
      return way_of(from, to) > std::max(free, radius) && goes_through(field, from, to, radius);
    };
    if (!finder_.at_nodes())
      return passes(part_of(pair, pair.start.shape, pair.start.pose), part_of(pair, shape, pose),
                    LineVolumeFinder::room_at_start(pair));
    return std::any_of(kEnds.begin(), kEnds.end(), [&](double xi) {
      AxisPoints from, to;
      from.fill(pair.start.pose.to_body(pair.start.shape.point(xi))), to.fill(pose.to_body(shape.point(xi)));
      return finder_.takes_part(pair, xi) && passes(from, to, 0);
    });
  });
}

// Corners, edges and balls, in the frame of the other body; a corner is taken for as round as the ramp of its
// law is wide.
bool BodyContactTerm::passes(const Pair& pair, const Kinematics& trial) const {
  const Side &sa = sides_[pair.a], &sb = sides_[pair.b];
  const BodyFrame A = frame(sa, trial), B = frame(sb, trial);
  const Vec3 ca = sa.global < 0 ? Vec3(Vec3::Zero()) : sa.centre,
             cb = sb.global < 0 ? Vec3(Vec3::Zero()) : sb.centre;
  const auto before = [&](const Vec3& y) { return Vec3(pair.at.B.to_body(pair.at.A.to_space(y - ca)) + cb); };
  const auto after = [&](const Vec3& y) { return Vec3(B.to_body(A.to_space(y - ca)) + cb); };
  const Surface& surface = *volumes_[pair.b].surface;
  const Box& box = boxes_[pair.b];
  const BodySkeleton& skeleton = volumes_[pair.a].skeleton;
  const auto near = [&](const BodySkeleton::Bundle& b) {
    const Vec3 from = before(b.centre), to = after(b.centre), middle = 0.5 * (from + to);
    const double reach = b.radius + 0.5 * (to - from).norm() + pair.law.smoothing;
    return squared_distance(box, middle) <= reach * reach && surface.query(middle, reach);
  };
  const auto meets = [&](const Vec3& y0, const Vec3& y1, double radius) {
    return goes_through(distance_to(surface), BezierAxis::straight(before(y0), before(y1)).b,
                        BezierAxis::straight(after(y0), after(y1)).b, std::max(radius, pair.law.smoothing),
                        true);
  };
  const auto any = [&](const auto& bundles, const auto& list, const auto& passes) {
    for (const BodySkeleton::Bundle& b : bundles)
      if (near(b) && std::any_of(list.begin() + b.first, list.begin() + b.first + b.count, passes))
        return true;
    return false;
  };
  return any(skeleton.point_bundles, skeleton.points,
             [&](const SkeletonPoint& p) { return meets(p.at, p.at, p.radius); }) ||
         any(skeleton.edge_bundles, skeleton.edges,
             [&](const SkeletonEdge& e) { return meets(e.from, e.to, e.radius); });
}

Verdict BodyContactTerm::judge(const Kinematics& trial) const {
  const bool through = trial.step > 0 && std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
                         return pair.counted && passes(pair, trial);
                       });
  return through ? Verdict{Verdict::Kind::shorter, "in it a body would pass through another one"} : Verdict{};
}

}  // namespace hawser
