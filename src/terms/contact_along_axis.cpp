// Forces of contact on an axis and their tangent: the law at the Gauss points of each panel (a part of an
// interval in contact), what the ends of panels add as they move with the unknowns, and the roll of a beam
// about its own axis.
#include "hawser/terms/contact_along_axis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

constexpr size_t kTurns = AttachedForces::kPositions;

}  // namespace

// Ends of a panel that move with the unknowns: s is where gap(s, X) = smoothing, so ds = -n . dx(s) / (n .
// x'(s)), and the places and weights of the Gauss points follow it.
struct AxisContact::Moving {
  bool on = false;
  AxisShape::Weights H{};
  Vec3 by_axis = Vec3::Zero();                 // ds / dx(s), 1/m
  std::array<Vec3, AxisShape::kMost> force{};  // dF_j / ds
  std::array<double, 2> torque{};              // dT_i / ds
};

AxisContact::AxisContact(const AxisShape& shape, const RigidPose& pose, double radius, double length,
                         const AxisContactMode& mode, std::optional<Rolls> rolls)
    : shape_(shape),
      pose_(pose),
      radius_(radius),
      length_(length),
      mode_(mode),
      rolls_(std::move(rolls)),
      n_(static_cast<size_t>(shape.count())),
      R_(pose.rotation.toRotationMatrix()),
      back_(pose.rotation.conjugate()),
      spin_(hat(back_ * pose.angular_velocity)),
      g_(shape.count(), rolls_.has_value(), mode.tangent) {
  for (size_t i = 0; i < 2 && rolls_; ++i) about_[i] = shape_.axes(i) * rolls_->ends[i].by_turn;
}

void AxisContact::add(const ContactQuadrature& found, const Pair& pair,
                      std::vector<AxisContactPoint>* points) {
  for (size_t i = 0; i < found.panels.size(); ++i) add_panel(found, i, pair, points);
}

std::array<AxisContact::Moving, 2> AxisContact::moving_ends(const ContactPanel& s, const Pair& pair) const {
  std::array<Moving, 2> ends;
  for (size_t i = 0; i < 2; ++i) {
    if (!(i ? s.to_moves : s.from_moves)) continue;
    const double xi = i ? s.to : s.from;
    const auto p = pair.query(s, xi);
    if (!p) continue;
    const Vec3 normal = R_ * p->normal;
    const double slope = normal.dot(shape_.slope(xi));
    if (std::abs(slope) < 1e-9 * shape_.slope_bound()) continue;
    ends[i].on = true;
    ends[i].H = shape_.functions(xi);
    ends[i].by_axis = -normal / slope;
    ends[i].force.fill(Vec3::Zero());
  }
  return ends;
}

// The tangent is exact, moving ends included.
void AxisContact::add_panel(const ContactQuadrature& found, size_t panel, const Pair& pair,
                            std::vector<AxisContactPoint>* points) {
  const ContactPanel& s = found.panels[panel];
  const bool moves = mode_.moves;
  const double L = length_, span = s.to - s.from;
  const ContactLaw law = pair.law(s);
  const double contact_distance = radius_ + law.normal.smoothing;
  std::array<Moving, 2> ends;
  if (mode_.tangent && !mode_.convex) ends = moving_ends(s, pair);
  const bool moving = ends[0].on || ends[1].on;
  // Places lie by panel.
  auto place = std::partition_point(found.quadrature.begin(), found.quadrature.end(),
                                    [&](const QuadraturePoint& p) { return p.panel < panel; });
  for (; place != found.quadrature.end() && place->panel == panel; ++place) {
    const QuadraturePoint& there = *place;
    if (!(there.at.distance <= contact_distance)) continue;
    const double xi = there.xi, w = there.weight;
    const Vec3 x = shape_.point(xi);
    ContactTrial trial;
    trial.point = pose_.to_body(x);
    trial.gap = there.at.distance - radius_;
    trial.normal = there.at.normal;
    // -N H is the negative geometric stiffness of contact.
    if (!mode_.convex) trial.curvature = there.at.curvature;
    // Relative velocity in the body frame: u = R'(v - V) - omega x y.
    if (moves) trial.velocity = back_ * (shape_.velocity(xi) - pose_.velocity_at(x));
    ContactStart begin;
    ContactRates rates;
    if (law.friction.active()) begin = pair.start(s, xi, moving ? &rates : nullptr);
    if (rolls_) {
      trial.roll = rolls_->angle(xi);
      trial.lever = radius_;
    }
    const PointContact c = volume_contact(law, begin, trial, mode_.tangent);
    if (c.normal.elastic > 0 && points) {
      AxisContactPoint& p = points->emplace_back(c, trial.normal);
      p.xi = xi;
      p.from = s.from;
      p.to = s.to;
      p.group = s.group;
      p.weight = w;
      p.gap = trial.gap;
    }
    if (!(c.normal.force > 0)) continue;
    const AxisShape::Weights H = shape_.functions(xi);
    const Vec3 f = -(R_ * c.force);
    for (size_t j = 0; j < n_; ++j) g_.F[j] += w * H[j] * f;
    const Mat3 by_point = c.by_point - (moves ? 1.0 : 0.0) * c.by_velocity * spin_;
    if (rolls_) add_rolling(trial, begin, c, xi, w, by_point);
    if (!mode_.tangent) continue;
    const Mat3 K = -w * R_ * by_point * R_.transpose();
    const Mat3 C = moves ? Mat3(-w * R_ * c.by_velocity * R_.transpose()) : Mat3(Mat3::Zero());
    for (size_t j = 0; j < n_; ++j)
      for (size_t k = 0; k < n_; ++k) {
        block_of(g_.K, j, k) += H[j] * H[k] * K;
        if (moves) block_of(g_.C, j, k) += H[j] * H[k] * C;
      }
    if (!moving) continue;

    rates.point = back_ * shape_.slope(xi);
    if (moves)
      rates.velocity = back_ * (shape_.velocity_slope(xi) - pose_.angular_velocity.cross(shape_.slope(xi)));
    if (rolls_) rates.roll = rolls_->ends[1].angle - rolls_->ends[0].angle;
    const Vec3 along = contact_force_along(law, begin, trial, rates), slope = -(R_ * along);
    const Vec3 arm = -trial.lever * begin.tangent.cross(trial.normal),
               arm_along = -trial.lever * (rates.start_tangent.cross(trial.normal) +
                                           begin.tangent.cross(trial.curvature * rates.point));
    const double torque = -arm.dot(c.force), torque_along = -(arm_along.dot(c.force) + arm.dot(along));
    const AxisShape::Weights dH = shape_.derivatives(xi);
    const std::array<double, 2> N{1 - xi, xi};
    for (size_t i = 0; i < 2; ++i) {
      if (!ends[i].on) continue;
      const double interval = i ? there.part : -there.part,
                   shift = span * there.part * (i ? there.along : 1 - there.along);
      for (size_t j = 0; j < n_; ++j)
        ends[i].force[j] += L * ((interval * H[j] + shift * dH[j]) * f + shift * H[j] * slope);
      for (size_t j = 0; j < 2 && rolls_; ++j)
        ends[i].torque[j] +=
            L * ((interval * N[j] + (j ? shift : -shift)) * torque + shift * N[j] * torque_along);
    }
  }
  for (const Moving& m : ends) {
    if (!m.on) continue;
    for (size_t k = 0; k < n_; ++k) {
      for (size_t j = 0; j < 2 && rolls_; ++j)
        block_of(g_.K, kTurns + j, k) += m.H[k] * m.torque[j] * about_[j] * m.by_axis.transpose();
      for (size_t j = 0; j < n_; ++j) block_of(g_.K, j, k) += m.H[k] * m.force[j] * m.by_axis.transpose();
    }
  }
}

// A roll by da moves the line's surface by arm da: its work is the torque's. The ends roll about `about_`.
void AxisContact::add_rolling(const ContactTrial& trial, const ContactStart& begin, const PointContact& c,
                              double xi, double w, const Mat3& by_point) {
  const AxisShape::Weights H = shape_.functions(xi);
  const std::array<double, 2> N{1 - xi, xi};
  const Vec3 arm = -trial.lever * begin.tangent.cross(trial.normal);
  const double torque = -arm.dot(c.force);
  for (size_t i = 0; i < 2; ++i) {
    torque_[i] += w * N[i] * torque;
    g_.F[kTurns + i] += w * N[i] * torque * about_[i];
  }
  if (!mode_.tangent) return;
  const Vec3 by_x = -w * (R_ * (by_point.transpose() * arm +
                                trial.lever * trial.curvature * begin.tangent.cross(c.force))),
             by_v = mode_.moves ? Vec3(-w * (R_ * (c.by_velocity.transpose() * arm))) : Vec3(Vec3::Zero()),
             by_roll = -w * (R_ * c.by_roll);
  for (size_t i = 0; i < 2; ++i) {
    for (size_t k = 0; k < n_; ++k) {
      block_of(g_.K, kTurns + i, k) += N[i] * H[k] * about_[i] * by_x.transpose();
      block_of(g_.C, kTurns + i, k) += N[i] * H[k] * about_[i] * by_v.transpose();
      block_of(g_.K, k, kTurns + i) += N[i] * H[k] * by_roll * about_[i].transpose();
    }
    for (size_t k = 0; k < 2; ++k)
      block_of(g_.K, kTurns + i, kTurns + k) -=
          w * N[i] * N[k] * arm.dot(c.by_roll) * about_[i] * about_[k].transpose();
  }
}

// The axis of a roll turns with the node otherwise than a vector of its material does: by_turn_turn.
void AxisContact::to_blocks(const Stencil& stencil, double* f, double* K, double* C) {
  for (size_t i = 0; i < 2 && rolls_ && K && !mode_.convex; ++i) {
    const AxisRoll& roll = rolls_->ends[i];
    const Mat3 turned = torque_[i] * (roll.by_turn_turn - hat(roll.by_turn));
    block_of(g_.K, kTurns + i, kTurns + i) += shape_.axes(i) * turned * shape_.axes(i).transpose();
  }
  stencil.to_blocks(g_, !mode_.convex, f, K, C);
}

}  // namespace hawser
