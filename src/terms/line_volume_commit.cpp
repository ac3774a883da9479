// The class LineVolumeContact: contact points, energies and work of an accepted step.
#include <algorithm>

#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {

void LineVolumeContact::commit(const Kinematics& accepted) {
  volumes_.pose_trial(accepted);
  find_near_pairs(accepted);
  auto near = near_.begin();
  for (size_t i = 0; i < pairs_.size(); ++i) {
    Pair& pair = pairs_[i];
    std::vector<AxisContactPoint> next;
    if (near != near_.end() && near->pair == i) {
      const bool moves = accepted.moves();
      if (pair.trial.evaluation != Pair::evaluation_of(moves)) contact(pair, near->shape, {moves});
      next = std::move(pair.trial.evaluated);
      ++near;
    }
    pair.trial.evaluation = Pair::Evaluation::none;
    pair.trial.evaluated.clear();
    for (const AxisContactPoint& p : next)
      accounts_[pair.element].reaches(-p.gap, accepted.time, pair.volume, p.xi < 0.5 ? 0 : 1);
    if (accepted.moves() && !(next.empty() && pair.start.points.empty()))
      account(pair, AxisShape(ends(accepted, pair.element)), next);
    pair.start.points = std::move(next);
  }
  volumes_.commit_raise();
}

// Work by the trapezoidal rule over the step: half with the forces at the start at their places, half with
// those at the end at theirs. If a point met or left the surface in the step, its normal force counts on the
// part of its path on which it touched, and friction on the whole path.
void LineVolumeContact::account(const Pair& pair, const AxisShape& shape,
                                const std::vector<AxisContactPoint>& next) {
  const AxisShape& start = pair.start.shape;
  const RigidPose& before = pair.start.pose;
  const RigidPose& after = volumes_.trial_pose(pair.volume);
  const StepOfBody step(before, after, !volumes_.floats(pair.volume));
  const double smoothing = pair.smoothing();
  ContactWork& sum = accounts_[pair.element];
  // Path of a point of the line (y0 to y1, body axes), and its displacement without sliding along the line
  // (lifted). A pipe that is pulled over a roller continuously makes and loses contact, yet the length in
  // contact does not change, so sliding does not count as separation. With contact at nodes it does.
  struct PointPath {
    Vec3 y0, y1, lifted, along;
  };
  const auto rolled = rolls(pair, shape);
  const auto path_of = [&](double xi) {
    PointPath w;
    w.y0 = before.to_body(start.point(xi));
    w.y1 = after.to_body(shape.point(xi));
    w.along = ((before.rotation.conjugate() * start.slope(xi)).normalized() +
               (after.rotation.conjugate() * shape.slope(xi)).normalized())
                  .normalized();
    const Vec3 moved = w.y1 - w.y0;
    w.lifted = finder_.at_nodes() ? moved : Vec3(moved - w.along * w.along.dot(moved));
    return w;
  };
  // If the stiffness was raised, the change of spring energy due to the raise counts as external work.
  const double raise = volumes_.raised(pair.volume) ? 1 : 0;
  const auto add = [&](const AxisContactPoint& p, const Mat3& R, const PointPath& w, double touching) {
    sum.add(step, p, R, w.y0, w.y1, touching);
    sum.work += raise * 0.5 * touching * p.weight * p.elastic_force() * p.normal.dot(w.y1 - w.y0);
    if (!rolled) return;
    // Displacement of the line's surface due to roll. Friction's work on it is added.
    const Vec3 surface = -pair.radius * rolled->angle(p.xi) * w.along.cross(p.normal);
    sum.friction -= 0.25 * p.weight * (R * p.friction).dot((step.R0 + step.R1) * surface);
  };
  for (const AxisContactPoint& p : pair.start.points) {
    const PointPath w = path_of(p.xi);
    const double separation = p.normal.dot(w.lifted);
    const double deep = std::max(smoothing - p.gap, 0.0);
    add(p, step.R0, w, separation > deep ? deep / separation : 1);
    sum.work -= raise * p.weight * p.potential;
  }
  for (const AxisContactPoint& p : next) {
    const PointPath w = path_of(p.xi);
    const double approach = -p.normal.dot(w.lifted);
    const double deep = smoothing - p.gap;
    add(p, step.R1, w, approach > deep ? deep / approach : 1);
    sum.work += raise * p.weight * p.potential;
  }
}

// After a step the energy of the committed state; in statics that of the trial, for the line search.
Energy LineVolumeContact::energy(const Kinematics& state) const {
  Energy e;
  std::vector<RigidPose> poses;
  if (!state.ends_step()) poses = volumes_.poses(state);
  for (const Pair& p : pairs_) {
    if (!local(p).counted) continue;
    if (state.ends_step()) {
      for (const AxisContactPoint& q : p.start.points) e.strain += q.weight * q.potential;
      continue;
    }
    const AxisShape shape(ends(state, p.element));
    const RigidPose& pose = poses[volumes_.body(p.volume)];
    if (LineVolumeFinder::certainly_clear(p, shape, pose)) continue;
    Pair pair = p;
    for (const QuadraturePoint& point : finder_.search(pair, shape, pose).quadrature)
      if (p.in_contact(point.surface))
        e.strain += point.weight *
                    normal_force(p.law(point.xi).normal, point.surface.distance - p.radius, 0).potential;
  }
  for (size_t i = 0; i < accounts_.size(); ++i) {
    if (!mesh_.elements[i].counted) continue;
    e.friction += accounts_[i].friction;
    e.damping += accounts_[i].damping;
    e.work += accounts_[i].work;
  }
  return e;
}

Penetration LineVolumeContact::largest_penetration() const {
  Penetration p;
  for (size_t i = 0; i < accounts_.size(); ++i) {
    const LocalElement& e = mesh_.elements[i];
    const ContactWork& a = accounts_[i];
    if (e.counted && a.depth > p.depth)
      p = {a.depth, mesh_.global[a.end ? e.second : e.first], a.volume, a.time};
  }
  return p;
}

}  // namespace hawser
