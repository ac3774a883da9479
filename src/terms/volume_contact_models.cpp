// The other models of contact at the nodes: multipliers, nodes held on the surface, gap springs.
#include <algorithm>
#include <cmath>

#include "hawser/terms/volume_contact.hpp"

namespace hawser {
namespace {

constexpr double kLeft = 1e-4;    // of the radius: penetration that multipliers leave when nothing is said
constexpr double kHeld = 1e-8;    // of the radius: as near to the surface is a held node
constexpr double kNone = 1e-9;    // N/m: as good as no spring beside a multiplier
constexpr double kHolding = 1e4;  // stiffness in motion over m/h²: an update gains four digits

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
  if (model_ == NodeContact::elastic || model_ == NodeContact::gap) return law;
  law.normal.table = nullptr;
  if (step > 0) {
    const double mass = nodes_[static_cast<size_t>(pair.node)].mass;
    law.normal.stiffness = std::max(law.normal.stiffness, kHolding * mass / (step * step));
  }
  if (model_ == NodeContact::rigid && step > 0) {
    if (!pair.held) {
      law.normal = {};
      return law;
    }
    law.normal.holds = true;
    law.normal.damping = 0;
  }
  law.normal.ahead = pair.multiplier / law.normal.stiffness;
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
  pose_bodies(equilibrium.time, poses_);
  bool again = false;
  for (Pair& pair : pairs_) {
    const size_t n = static_cast<size_t>(pair.node), k = static_cast<size_t>(pair.volume);
    const Vec3 y = poses_[body(pair.volume)].to_body(equilibrium.x[n]);
    const auto p = volumes_[k].surface->query(y, pair.touch + 0.5 * element_[n], pair.hint);
    ContactTrial at;
    at.gap = p ? p->distance - nodes_[n].radius : element_[n];
    if (improve(pair, at, equilibrium.step)) again = true;
  }
  return again;
}

// Uzawa: the multiplier becomes the force of the law, lambda <- max(0, lambda - k g). A node held moves it
// both ways until it lies on the surface, and is let go when it then pulls; once a step, so that it ends.
bool VolumeContact::improve(Pair& pair, const ContactTrial& at, double step) {
  const double radius = nodes_[static_cast<size_t>(pair.node)].radius,
               k = in_force(pair, step).normal.stiffness;
  if (model_ == NodeContact::rigid && step > 0) {
    if (!pair.held) {
      if (at.gap >= 0 || pair.released) return false;
      pair.held = true;
      pair.multiplier = 0;
      return true;
    }
    const double next = pair.multiplier - k * at.gap;
    if (std::abs(at.gap) > kHeld * radius) {
      pair.multiplier = next;
      return true;
    }
    if (next >= 0) return false;
    pair.held = false, pair.released = true;
    pair.multiplier = 0;
    return true;
  }
  const double next = std::max(0.0, pair.multiplier - k * at.gap);
  const double allowed = allowed_ > 0 ? allowed_ : kLeft * radius;
  const bool good = std::abs(next - pair.multiplier) <= k * allowed;
  if (!good) pair.multiplier = next;
  // From here on, in a rigid run, this one is held.
  if (model_ == NodeContact::rigid) pair.held = pair.multiplier > 0;
  return !good;
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
  for (Pair& pair : pairs_) {
    pair.multiplier = pair.history.multiplier;
    pair.held = pair.history.held;
    pair.released = false;
  }
}

}  // namespace hawser
