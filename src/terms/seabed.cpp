#include "hawser/terms/seabed.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

PointContact SeabedTerm::contact(const Point& p, const Kinematics& at, bool derivatives) const {
  const size_t n = static_cast<size_t>(p.node);
  ContactTrial t;
  t.gap = plane_.gap(at.x[n]) - p.radius;
  if (t.gap >= p.law.normal.smoothing) return {};
  t.point = at.x[n];
  t.normal = plane_.normal;
  if (at.step > 0) t.velocity = at.v[n];
  if (friction_on_) return volume_contact(p.law, p.start, t, derivatives);
  return volume_contact({p.law.normal, FrictionLaw{}}, p.start, t, derivatives);
}

// Statics comes here before every iteration: a laid line keeps where its friction is reckoned from.
void SeabedTerm::prepare(const Kinematics& committed, double h) {
  const bool statics = h <= 0;
  if (!statics) laid_ = false;
  for (Point& p : points_) {
    const size_t n = static_cast<size_t>(p.node);
    if (!(statics && laid_)) {
      p.start.point = committed.x[n];
      p.start.gap = plane_.gap(committed.x[n]) - p.radius;
      p.start.slip = p.history.slip;
      p.start.normal = plane_.normal;
    }
    if (p.law.friction.active()) p.start.tangent = line_.tangent(committed, p.node);
    if (statics && friction_on_) p.pressed = contact(p, committed, false).normal.force;
  }
}

void SeabedTerm::evaluate(const Kinematics& trial, Sink& sink) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const bool tangent = sink.wants_tangent();
  for (const Point& p : points_) {
    if (plane_.gap(trial.x[static_cast<size_t>(p.node)]) - p.radius >= p.law.normal.smoothing) continue;
    const PointContact c = contact(p, trial, tangent);
    if (c.normal.force == 0) continue;
    const Vec3 residual = -c.force;
    if (!tangent) {
      sink.add({&p.block, 1}, residual.data(), nullptr, nullptr, nullptr);
      continue;
    }
    const RowMajor K = -c.by_point, C = -c.by_velocity;
    sink.add({&p.block, 1}, residual.data(), K.data(), trial.step > 0 ? C.data() : nullptr, nullptr);
  }
}

// Evaluated again at the accepted state. Energies: trapezoid over the step.
void SeabedTerm::commit(const Kinematics& accepted) {
  for (Point& p : points_) {
    const PointContact c = contact(p, accepted, false);
    History next;
    next.friction_work = p.history.friction_work, next.damping_work = p.history.damping_work;
    if (c.normal.elastic > 0) {
      next.touches = true;
      next.slip = c.slip, next.force = c.force, next.friction = c.friction;
      next.damping_force = c.normal.force - c.normal.elastic;
      next.potential = c.normal.potential;
    }
    if (accepted.step > 0 && (next.touches || p.history.touches)) {
      const Vec3 moved = accepted.x[static_cast<size_t>(p.node)] - p.start.point;
      next.friction_work -= 0.5 * (next.friction + p.history.friction).dot(moved);
      next.damping_work -= 0.5 * (next.damping_force + p.history.damping_force) * plane_.normal.dot(moved);
    }
    p.history = next;
  }
}

// What friction that grows from the start of a laid line has taken up, as if it were pressed by what presses
// it at the last iteration: convex, and exact for equal coefficients and lengths.
double SeabedTerm::friction_potential(const Point& p, const Vec3& x) const {
  const FrictionLaw& f = p.law.friction;
  const Vec3 slip = p.start.slip + (x - p.start.point);
  const double along = slip.dot(p.start.tangent), up = slip.dot(plane_.normal);
  const double across2 = std::max(0.0, slip.squaredNorm() - along * along - up * up);
  double force[2] = {f.axial * p.pressed, f.lateral * p.pressed};
  double length[2] = {f.axial_length, f.lateral_length};
  if (f.stiffness > 0)
    for (int i = 0; i < 2; ++i) length[i] = std::max(force[i] / f.stiffness, 1e-12);
  const double R2 = along * along / (length[0] * length[0]) + across2 / (length[1] * length[1]);
  const double a2 = along * along, all2 = a2 + across2;
  const double share = all2 > 0 ? a2 / all2 : 1;
  const double limit = share * force[0] * length[0] + (1 - share) * force[1] * length[1];
  return limit * (R2 < 1 ? 0.5 * R2 : std::sqrt(R2) - 0.5);
}

// In statics of trials: the line search goes down this.
Energy SeabedTerm::energy(const Kinematics& at) const {
  Energy e;
  for (const Point& p : points_) {
    e.friction += p.history.friction_work, e.damping += p.history.damping_work;
    if (at.step > 0) {
      e.strain += p.history.potential;
      continue;
    }
    const PointContact c = contact(p, at, false);
    e.strain += c.normal.potential;
    if (friction_on_ && laid_ && p.law.friction.active() && p.pressed > 0)
      e.strain += friction_potential(p, at.x[static_cast<size_t>(p.node)]);
  }
  return e;
}

Vec3 SeabedTerm::node_force(const Kinematics&, int node) const {
  for (const Point& p : points_)
    if (p.node == node) return p.history.force;
  return Vec3::Zero();
}

int SeabedTerm::touching() const {
  return static_cast<int>(
      std::count_if(points_.begin(), points_.end(), [](const Point& p) { return p.history.touches; }));
}

}  // namespace hawser
