// The other models of contact at the nodes: multipliers, nodes held on the surface, gap springs.
#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/terms/volume_contact.hpp"

namespace hawser {
namespace {

constexpr double kLeft = 1e-4;  // of the radius: penetration that multipliers leave when nothing is said
constexpr double kHeld = 1e-8;  // of the radius: as near to the surface is a held node
constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kKnown = 16 * kEps;  // of the coordinates: nearer than that no multiplier brings a gap
constexpr double kNone = 1e-9;        // N/m: as good as no spring beside a multiplier
constexpr double kStopping = 1e6;     // of the mass: what is left of a speed is its inverse
constexpr double kHolding = 1e2;      // stiffness in motion over m/h²: an update gains two digits

// N/m, beside a multiplier in motion.
double holding(const NormalLaw& law, double mass, double step) {
  return std::max(law.stiffness, kHolding * mass / (step * step));
}

}  // namespace

// In statics a rigid node is one with a multiplier: an equilibrium has no step in which it could be released.
ContactLaw VolumeContact::in_force(const Pair& pair, double step) const {
  ContactLaw law = applied(pair.law);
  if (exact_) {
    law.normal = {};
    if (!(pair.multiplier > 0)) return law;
    law.normal.holds = true;
    law.normal.stiffness = kNone;
    law.normal.ahead = pair.multiplier / kNone;
    return law;
  }
  if (model_ == NodeContact::elastic || model_ == NodeContact::gap || pair.fixed) return law;
  law.normal.table = nullptr;
  if (step > 0) {
    law.normal.damping = 0;  // a multiplier leaves nothing to swing
    law.normal.stiffness = holding(law.normal, nodes_[static_cast<size_t>(pair.node)].mass, step);
  }
  if (model_ == NodeContact::rigid && step > 0) {
    if (!pair.held) {
      law.normal = {};
      return law;
    }
    law.normal.holds = true;
  }
  law.normal.ahead = pair.multiplier / law.normal.stiffness + (step > 0 ? pair.history.rest : 0);
  return law;
}

// A node that may carry a multiplier is looked at from further away, and a gap spring looks at its plane.
bool VolumeContact::locate_held(Pair& pair, const Vec3& y, double reach, ContactTrial& trial) const {
  const size_t n = static_cast<size_t>(pair.node);
  trial.point = y;
  if (model_ == NodeContact::gap) {
    const History& h = pair.history;
    if (!h.paired) return false;
    trial.gap = h.direction.dot(y - h.anchor) - nodes_[n].radius;
    trial.normal = h.direction;
    trial.curvature.setZero();
    return trial.gap < pair.law.normal.smoothing;
  }
  const auto& p = look(pair, y, pair.touch + reach);
  if (!p) return false;
  pair.hint = p->triangle;
  trial.gap = p->distance - nodes_[n].radius;
  trial.normal = p->normal;
  trial.curvature = p->curvature;
  if (exact_) return pair.multiplier > 0;
  if (pair.held || pair.multiplier > 0) return true;
  return trial.gap < pair.law.normal.smoothing;
}

void VolumeContact::choose_gap(Pair& pair, const Vec3& y) const {
  const size_t k = static_cast<size_t>(pair.volume);
  const Box& box = boxes_[k];
  // Anywhere on the surface; a plane's box is of no size to speak of.
  const double far = distance(box, y) + std::min(box.extent().norm(), 1e6) + pair.touch;
  const auto p = volumes_[k].surface->query(y, far, -1);
  if (!p) return;
  pair.history.paired = true;
  pair.history.direction = p->normal;
  pair.history.anchor = y - p->distance * p->normal;
}

bool VolumeContact::augment(const Kinematics& equilibrium) {
  if (!augments()) return stiffen(equilibrium);
  pose_bodies(equilibrium.time, poses_);
  bool again = false;
  for (Pair& pair : pairs_) {
    const size_t n = static_cast<size_t>(pair.node), k = static_cast<size_t>(pair.volume);
    const Vec3 y = poses_[body(pair.volume)].to_body(equilibrium.x[n]);
    const auto p = volumes_[k].surface->query(y, pair.touch + 0.5 * element_[n], pair.hint);
    const double gap = p ? p->distance - nodes_[n].radius : element_[n];
    pair.speed.reset(), pair.impulse = 0;
    const double size = std::max(y.cwiseAbs().maxCoeff(), equilibrium.x[n].cwiseAbs().maxCoeff());
    if (improve(pair, gap, kKnown * size, equilibrium.step)) again = true;
  }
  return again;
}

bool VolumeContact::improve(Pair& pair, double gap, double known, double step) {
  if (pair.fixed) return false;
  if (step > 0) gap -= pair.history.rest;
  if (step > 0 && pair.moved_for == gap) return pair.fixed = true;
  pair.moved_for.reset();
  if (!move_multiplier(pair, gap, known, step)) return false;
  pair.moved_for = gap;
  return true;
}

// Uzawa: the multiplier becomes the force of the law, lambda <- max(0, lambda - k g). A node held moves it
// both ways until it lies on the surface, and is let go when it then pulls; once a step, so that it ends.
bool VolumeContact::move_multiplier(Pair& pair, double gap, double known, double step) const {
  const double radius = nodes_[static_cast<size_t>(pair.node)].radius,
               k = in_force(pair, step).normal.stiffness;
  if (model_ == NodeContact::rigid && step > 0) {
    if (!pair.held) {
      if (gap >= 0 || pair.released) return false;
      pair.held = true;
      pair.multiplier = 0;
      return true;
    }
    const double next = pair.multiplier - k * gap;
    if (std::abs(gap) > std::max(kHeld * radius, known)) {
      pair.multiplier = next;
      return true;
    }
    if (next >= 0) return false;
    pair.held = false, pair.released = true;
    pair.multiplier = 0;
    return true;
  }
  const double next = std::max(0.0, pair.multiplier - k * gap);
  const double left = step > 0       ? kHeld * radius
                      : allowed_ > 0 ? allowed_
                                     : kLeft * radius,
               allowed = std::max(left, known);
  const bool good = std::abs(next - pair.multiplier) <= k * allowed;
  if (!good) pair.multiplier = next;
  // From here on, in a rigid run, this one is held.
  if (model_ == NodeContact::rigid) pair.held = pair.multiplier > 0;
  return !good;
}

// Of what holds in motion, or may from this step on: a gap is known to a few eps of the place.
double VolumeContact::round_off(const Kinematics& at, double h) const {
  if (!(h > 0) || !augments()) return 0;
  double sum = 0;
  for (const Pair& pair : pairs_) {
    const size_t n = static_cast<size_t>(pair.node);
    const Vec3& x = at.x[n];
    const RigidPose& pose = start_poses_[body(pair.volume)];
    const double way = 2 * h * (at.v[n] - pose.velocity_at(x)).norm() + h * h * at.a[n].norm();
    if (!pair.history.held && !(pair.history.multiplier > 0) && pair.start.gap > way) continue;
    sum += std::pow(2 * holding(pair.law.normal, nodes_[n].mass, h) * kEps * x.cwiseAbs().maxCoeff(), 2);
  }
  return sum;
}

// In motion the force acts along the mean of the normals at both ends of the step, so that it does no work on
// what slides on a curved surface.
void VolumeContact::mean_direction(const Pair& pair, const ContactTrial& at, bool derivatives,
                                   PointContact& c) const {
  if (!pair.history.touches || c.normal.force == 0) return;
  const size_t k = body(pair.volume);
  const Vec3 before = poses_[k].rotation.conjugate() * (start_poses_[k].rotation * pair.history.normal),
             turned = 0.5 * (before - at.normal);
  c.force += c.normal.force * turned;
  if (!derivatives) return;
  c.by_point += c.normal.by_gap * turned * at.normal.transpose() - 0.5 * c.normal.force * at.curvature;
}

// Held to the surface in position, a node is held in speed too: else it would swing through it from step to
// step. After a round k u of what is left of the speed u is the impulse that took the rest. Where no
// multiplier can hold it the speed stays too, and no impulse is anything.
void VolumeContact::stop(const Kinematics& at, Sink& sink) {
  pose_bodies(at.time, poses_);
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  for (Pair& pair : pairs_) {
    if (pair.fixed) continue;
    const size_t n = static_cast<size_t>(pair.node);
    ContactTrial trial;
    if (!(contact(pair, at, false, false, trial).normal.elastic > 0)) continue;
    const RigidPose& pose = poses_[body(pair.volume)];
    const Vec3 normal = pose.rotation * trial.normal;
    const double k = kStopping * nodes_[n].mass;
    const double speed = normal.dot(at.v[n] - pose.velocity_at(at.x[n]));
    if (sink.wants_force() && pair.speed) pair.impulse -= k * speed;
    if (sink.wants_force() && !pair.speed) pair.speed = speed;
    const Vec3 force = k * speed * normal;
    const RowMajor mass = k * normal * normal.transpose();
    sink.add({&block_[n], 1}, force.data(), nullptr, nullptr, mass.data());
  }
}

void VolumeContact::constraints(const Kinematics& at, std::vector<Constraint>& out) {
  if (model_ == NodeContact::elastic || model_ == NodeContact::gap) return;
  pose_bodies(at.time, poses_);
  for (Pair& pair : pairs_) {
    const size_t n = static_cast<size_t>(pair.node), k = static_cast<size_t>(pair.volume);
    const RigidPose& pose = poses_[body(pair.volume)];
    Constraint c;
    c.block = block_[n];
    c.stiffness = pair.law.normal.stiffness;
    c.gap = element_[n];
    if (const auto p =
            volumes_[k].surface->query(pose.to_body(at.x[n]), pair.touch + element_[n], pair.hint)) {
      c.gap = p->distance - nodes_[n].radius;
      c.normal = pose.rotation * p->normal;
      c.force = normal_force(in_force(pair, 0).normal, c.gap, 0).elastic;
    }
    out.push_back(c);
  }
}

void VolumeContact::set_multipliers(std::span<const double> values) {
  exact_ = !values.empty();
  for (size_t i = 0; i < values.size() && i < pairs_.size(); ++i)
    pairs_[i].multiplier = std::max(0.0, values[i]), pairs_[i].held = values[i] > 0;
}

void VolumeContact::reset_multipliers() {
  if (forget_raise())
    for (Pair& pair : pairs_) pair.law = node_law(pair.node, pair.volume);
  for (Pair& pair : pairs_) {
    pair.multiplier = pair.history.multiplier;
    pair.held = pair.history.held;
    pair.released = pair.fixed = false;
    pair.moved_for.reset(), pair.speed.reset();
    pair.impulse = 0;
  }
}

}  // namespace hawser
