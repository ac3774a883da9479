// What only the end of a step shows of contact with volumes: what leaves in a step that was too long to
// follow it, for what pushed lay still at its start and a wave along the line came and took it away; and what
// a wave drove deeper than its speed at the start would have.
#include <algorithm>

#include "hawser/terms/line_contact.hpp"
#include "hawser/terms/volume_contact.hpp"

namespace hawser {
namespace {

// Twice what limit_depth() trusts a step with: what comes as foreseen stays clear of it.
bool sinks_too_far(double radius, double before, double after) {
  return after > std::max(before, 0.0) + radius;
}

void add(double made, int line, Unforeseen& to) {
  if (made > 0) to.partings.push_back({line, -1, made});
}

}  // namespace

void VolumeContact::unforeseen(const Kinematics& trial, Unforeseen& to) {
  if (model_ != NodeContact::elastic && model_ != NodeContact::gap) return;
  pose_bodies(trial, poses_);
  for (Pair& pair : pairs_) {
    const size_t n = static_cast<size_t>(pair.node);
    const double mass = nodes_[n].mass, radius = nodes_[n].radius;
    const History& was = pair.history;
    ContactTrial at;
    if (contact(pair, trial, false, false, at).normal.elastic != 0) {
      to.too_deep = to.too_deep || sinks_too_far(radius, was.touches ? was.depth : 0, -at.gap);
      continue;
    }
    if (!was.touches || follows(pair.law.normal, mass, trial.step)) continue;
    const RigidPose& pose = poses_[body(pair.volume)];
    const Vec3 normal = pose.rotation * was.normal;
    add(made(pair.law.normal, mass, 1, radius, was, was.normal.dot(at.point - pair.start.point),
             normal.dot(trial.v[n] - pose.velocity_at(trial.x[n]))),
        mesh_.nodes[static_cast<size_t>(global_[n])].line, to);
  }
}

// Of a contact that grows shorter, the places that it no longer reaches.
void LineContact::unforeseen(const Kinematics& trial, Unforeseen& to) {
  pose_bodies(trial, poses_);
  for (Pair& pair : pairs_) {
    const LineContactElement& element = elements_[static_cast<size_t>(pair.element)];
    const LocalElement& e = mesh_.elements[static_cast<size_t>(pair.element)];
    // What touched may be that of another of its walls; what touches was found when it was evaluated.
    if (!e.counted || (pair.history.empty() && !pair.walls && pair.found.panels.empty())) continue;
    const AxisShape shape(ends(trial, pair.element));
    const RigidPose &pose = poses_[body(pair.volume)], &before = start_poses_[body(pair.volume)];
    const Found& found = find(pair, shape, pose);
    double deepest = 0, was = 0;
    for (const SurfacePoint& p : found.points) deepest = std::max(deepest, element.radius - p.distance);
    for (const Point& p : pair.past()) was = std::max(was, -p.gap);
    to.too_deep = to.too_deep || sinks_too_far(element.radius, was, deepest);
    if (follows(pair.law.normal, element.mass_per_length, trial.step)) continue;
    for (const Point& p : pair.past()) {
      const auto holds = [&](const auto& s) { return s.from <= p.xi && p.xi <= s.to; };
      if (std::any_of(found.panels.begin(), found.panels.end(), holds) &&
          std::none_of(found.filled.begin(), found.filled.end(), holds))
        continue;
      const Vec3 x = shape.point(p.xi), normal = pose.rotation * p.normal;
      add(made(pair.law.normal, element.mass_per_length, p.weight, element.radius, p,
               p.normal.dot(pose.to_body(x) - before.to_body(pair.start.point(p.xi))),
               normal.dot(shape.velocity(p.xi) - pose.velocity_at(x))),
          mesh_.mesh->elements[static_cast<size_t>(e.global)].line, to);
    }
  }
}

}  // namespace hawser
