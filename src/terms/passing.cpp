// What goes through a volume in a step and touches it neither at its start nor at its end, or comes to its
// other side: nothing acted on it, so the step is taken again, shorter.
#include <algorithm>

#include "hawser/kernels/axis_sweep.hpp"
#include "hawser/terms/body_contact.hpp"
#include "hawser/terms/line_contact.hpp"
#include "hawser/terms/volume_contact.hpp"

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

}  // namespace

Verdict Contact::judge(const Kinematics& trial) const {
  if (!(trial.step > 0)) return {};
  if (std::string why = deeper_than_allowed(trial); !why.empty())
    return {Verdict::Kind::shorter, std::move(why)};
  if (tunnels(trial)) return {Verdict::Kind::shorter, "in it a line would pass through a volume"};
  return {};
}

bool VolumeContact::tunnels(const Kinematics& trial) const {
  if (model_ == NodeContact::gap) return false;
  std::vector<RigidPose> poses;
  pose_bodies(trial, poses);
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
    if (pair.slot > 0) return false;
    const size_t n = static_cast<size_t>(pair.node);
    const Vec3 &from = pair.start.point, to = poses[body(pair.volume)].to_body(trial.x[n]);
    const double way = (to - from).norm();
    if (way <= nodes_[n].radius || (!pair.walls && still_clear(pair.clear, pair.centre, from, way)))
      return false;
    AxisPoints at, will_be;
    at.fill(from), will_be.fill(to);
    return goes_through(distance_to(*volumes_[static_cast<size_t>(pair.volume)].surface), at, will_be,
                        nodes_[n].radius);
  });
}

// Most are far away, or move less than they are thick.
bool LineContact::tunnels(const Kinematics& trial) const {
  std::vector<RigidPose> poses;
  pose_bodies(trial, poses);
  const auto way = [&](const Group& g, int node) {
    const size_t n = static_cast<size_t>(node);
    return (trial.x[n] - start_x_[n]).norm() + g.turn * (trial.q[n].coeffs() - start_q_[n].coeffs()).norm();
  };
  return std::any_of(groups_.begin(), groups_.end(), [&](const Group& g) {
    const Pair& pair = pairs_[g.first];
    const double radius = elements_[static_cast<size_t>(pair.element)].radius;
    if (still_[g.body] && std::max(way(g, g.nodes[0]), way(g, g.nodes[1])) < std::max(g.room, radius))
      return false;
    const AxisPoints from = points_of_part(pair, pair.start, start_poses_[g.body]),
                     to = points_of_part(pair, AxisShape(ends(trial, pair.element)), poses[g.body]);
    if (way_of(from, to) <= std::max(room_at_start(pair), radius)) return false;
    return goes_through(distance_to(*volumes_[static_cast<size_t>(pair.volume)].surface), from, to, radius);
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
