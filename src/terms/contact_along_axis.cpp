// Contact forces on an axis and their tangent: the law at the Gauss points of each panel (a part of an
// interval in contact), the contribution of panel ends that move with the unknowns, and the roll of a beam
// about its axis.
#include "hawser/terms/contact_along_axis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

constexpr size_t kTurns = AttachedForces::kPositions;

}  // namespace

// End of a panel that moves with the unknowns X. It is at xi = s, the root of gap(s, X) = smoothing, so that
//   ds = -n . dx(s) / (n . x'(s)).
// Positions and weights of the Gauss points depend on s, so forces have the additional derivative dF/ds ds.
struct AxisContact::Moving {
  bool moves = false;
  AxisShape::Weights H{};
  Vec3 by_axis = Vec3::Zero();                         // ds / dx(s), 1/m
  std::array<Vec3, AxisShape::kMaxPositions> force{};  // dF_j / ds
  std::array<double, 2> torque{};                      // dT_i / ds
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
      R_inverse_(pose.rotation.conjugate()),
      spin_(hat(R_inverse_ * pose.angular_velocity)),
      g_(shape.count(), rolls_.has_value(), mode.tangent) {
  for (size_t i = 0; i < 2 && rolls_; ++i) about_[i] = shape_.axes(i) * rolls_->ends[i].by_turn;
}

void AxisContact::add(const ContactQuadrature& contact, const PanelFunctions& functions,
                      std::vector<AxisContactPoint>* points) {
  for (size_t i = 0; i < contact.panels.size(); ++i) add_panel(contact, i, functions, points);
}

std::array<AxisContact::Moving, 2> AxisContact::moving_ends(const ContactPanel& s,
                                                            const PanelFunctions& functions) const {
  std::array<Moving, 2> ends;
  for (size_t i = 0; i < 2; ++i) {
    if (!(i ? s.to_moves : s.from_moves)) continue;
    const double xi = i ? s.to : s.from;
    const auto p = functions.query(s, xi);
    if (!p) continue;
    const Vec3 normal = R_ * p->normal;
    const double slope = normal.dot(shape_.slope(xi));
    if (std::abs(slope) < 1e-9 * shape_.slope_bound()) continue;
    ends[i].moves = true;
    ends[i].H = shape_.functions(xi);
    ends[i].by_axis = -normal / slope;
    ends[i].force.fill(Vec3::Zero());
  }
  return ends;
}

// Contact at a Gauss point. H: shape functions; residual: minus the force on the line, space axes, N/m.
struct AxisContact::Sample {
  double xi = 0, weight = 0;
  AxisShape::Weights H{};
  ContactTrial trial;
  ContactStart begin;
  ContactRates rates;  // of `begin`, if ends of the panel move
  ContactForce contact;
  Vec3 residual = Vec3::Zero();

  // Displacement of the line's surface per unit roll, m, body frame.
  Vec3 arm() const { return -trial.lever * begin.tangent.cross(trial.normal); }
  double torque() const { return -arm().dot(contact.force); }  // residual of the roll, N m/m
};

AxisContact::Sample AxisContact::sample(const QuadraturePoint& q, const ContactPanel& s,
                                        const ContactLaw& law, const PanelFunctions& functions,
                                        bool ends_move) const {
  Sample p;
  p.xi = q.xi;
  p.weight = q.weight;
  const Vec3 x = shape_.point(p.xi);
  p.trial.point = pose_.to_body(x);
  p.trial.gap = q.surface.distance - radius_;
  p.trial.normal = q.surface.normal;
  // The stiffness is -dN/dg n n' - N d²g/dx². The second term, by the curvature of the surface, is negative.
  if (!mode_.convex) p.trial.curvature = q.surface.curvature;
  // Relative velocity in the body frame: u = R'(v - V) - omega x y.
  if (mode_.moves) p.trial.velocity = R_inverse_ * (shape_.velocity(p.xi) - pose_.velocity_at(x));
  if (law.friction.active()) p.begin = functions.start(s, p.xi, ends_move ? &p.rates : nullptr);
  if (rolls_) {
    p.trial.roll = rolls_->angle(p.xi);
    p.trial.lever = radius_;
  }
  p.contact = surface_contact(law, p.begin, p.trial, mode_.tangent);
  if (!(p.contact.along_normal.force > 0)) return p;
  p.H = shape_.functions(p.xi);
  p.residual = -(R_ * p.contact.force);
  return p;
}

// Sums the Gauss points of a panel. The tangent adds to this sum the motion of the panel's ends:
//   K_jk += dF_j/ds ds/dx H_k.
void AxisContact::add_panel(const ContactQuadrature& contact, size_t panel, const PanelFunctions& functions,
                            std::vector<AxisContactPoint>* points) {
  const ContactPanel& s = contact.panels[panel];
  const ContactLaw law = functions.law(s);
  const double contact_distance = radius_ + law.normal.smoothing;
  std::array<Moving, 2> ends;
  if (mode_.tangent && !mode_.convex) ends = moving_ends(s, functions);
  const bool ends_move = ends[0].moves || ends[1].moves;
  // Points are sorted by panel.
  auto q = std::partition_point(contact.quadrature.begin(), contact.quadrature.end(),
                                [&](const QuadraturePoint& p) { return p.panel < panel; });
  for (; q != contact.quadrature.end() && q->panel == panel; ++q) {
    if (!(q->surface.distance <= contact_distance)) continue;
    Sample p = sample(*q, s, law, functions, ends_move);
    if (p.contact.along_normal.elastic > 0 && points) {
      AxisContactPoint& point = points->emplace_back(p.contact, p.trial.normal, mode_.moves);
      point.xi = p.xi;
      point.from = s.from;
      point.to = s.to;
      point.group = s.group;
      point.weight = p.weight;
      point.gap = p.trial.gap;
    }
    if (!(p.contact.along_normal.force > 0)) continue;
    add_sample(p);
    if (ends_move) add_to_moving_ends(law, p, *q, s.to - s.from, ends);
  }
  for (const Moving& m : ends) {
    if (!m.moves) continue;
    for (size_t k = 0; k < n_; ++k) {
      for (size_t j = 0; j < 2 && rolls_; ++j)
        block_of(g_.K, kTurns + j, k) += m.H[k] * m.torque[j] * about_[j] * m.by_axis.transpose();
      for (size_t j = 0; j < n_; ++j) block_of(g_.K, j, k) += m.H[k] * m.force[j] * m.by_axis.transpose();
    }
  }
}

// With the force f on the line:
//   F_j -= w H_j f,  K_jk -= w H_j H_k ∂f/∂x,  C_jk -= w H_j H_k ∂f/∂v
void AxisContact::add_sample(const Sample& p) {
  for (size_t j = 0; j < n_; ++j) g_.F[j] += p.weight * p.H[j] * p.residual;
  const Mat3 by_point = p.contact.by_point - (mode_.moves ? 1.0 : 0.0) * p.contact.by_velocity * spin_;
  if (rolls_) add_rolling(p, by_point);
  if (!mode_.tangent) return;
  const Mat3 K = -p.weight * R_ * by_point * R_.transpose();
  const Mat3 C =
      mode_.moves ? Mat3(-p.weight * R_ * p.contact.by_velocity * R_.transpose()) : Mat3(Mat3::Zero());
  for (size_t j = 0; j < n_; ++j)
    for (size_t k = 0; k < n_; ++k) {
      block_of(g_.K, j, k) += p.H[j] * p.H[k] * K;
      if (mode_.moves) block_of(g_.C, j, k) += p.H[j] * p.H[k] * C;
    }
}

// Contribution of a Gauss point to dF_j/ds at both ends of its panel, with F_j = -w H_j(xi) f(xi). The ends
// determine w = L span weight and xi = from + span place, span = to - from. Torques likewise.
void AxisContact::add_to_moving_ends(const ContactLaw& law, Sample& p, const QuadraturePoint& q, double span,
                                     std::array<Moving, 2>& ends) const {
  const double L = length_;
  p.rates.point = R_inverse_ * shape_.slope(p.xi);
  if (mode_.moves)
    p.rates.velocity =
        R_inverse_ * (shape_.velocity_slope(p.xi) - pose_.angular_velocity.cross(shape_.slope(p.xi)));
  if (rolls_) p.rates.roll = rolls_->ends[1].angle - rolls_->ends[0].angle;
  const Vec3 along = contact_force_along(law, p.begin, p.trial, p.rates);
  const Vec3 slope = -(R_ * along);
  const Vec3 arm_along = -p.trial.lever * (p.rates.start_tangent.cross(p.trial.normal) +
                                           p.begin.tangent.cross(p.trial.curvature * p.rates.point));
  const double torque = p.torque();
  const double torque_along = -(arm_along.dot(p.contact.force) + p.arm().dot(along));
  const AxisShape::Weights dH = shape_.derivatives(p.xi);
  const std::array<double, 2> N{1 - p.xi, p.xi};
  for (size_t i = 0; i < 2; ++i) {
    if (!ends[i].moves) continue;
    const double by_length = q.in_panel.length_by_end(i == 1);
    const double by_xi = span * q.in_panel.weight * q.in_panel.xi_by_end(i == 1);
    for (size_t j = 0; j < n_; ++j)
      ends[i].force[j] += L * ((by_length * p.H[j] + by_xi * dH[j]) * p.residual + by_xi * p.H[j] * slope);
    for (size_t j = 0; j < 2 && rolls_; ++j)
      ends[i].torque[j] +=
          L * ((by_length * N[j] + (j ? by_xi : -by_xi)) * torque + by_xi * N[j] * torque_along);
  }
}

// A roll by da moves the line's surface by arm da, so the force f on the line does the work arm . f da, and
// the residual of the roll is -arm . f. It acts on the ends about the axes `about_`.
void AxisContact::add_rolling(const Sample& p, const Mat3& by_point) {
  const double w = p.weight;
  const double torque = p.torque();
  const AxisShape::Weights& H = p.H;
  const std::array<double, 2> N{1 - p.xi, p.xi};
  const Vec3 arm = p.arm();
  for (size_t i = 0; i < 2; ++i) {
    torque_[i] += w * N[i] * torque;
    g_.F[kTurns + i] += w * N[i] * torque * about_[i];
  }
  if (!mode_.tangent) return;
  const ContactForce& c = p.contact;
  const Vec3 by_x = -w * (R_ * (by_point.transpose() * arm +
                                p.trial.lever * p.trial.curvature * p.begin.tangent.cross(c.force)));
  const Vec3 by_v = mode_.moves ? Vec3(-w * (R_ * (c.by_velocity.transpose() * arm))) : Vec3(Vec3::Zero());
  const Vec3 by_roll = -w * (R_ * c.by_roll);
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

// The roll axis does not turn with the node like a material vector; by_turn_turn is its derivative.
void AxisContact::to_blocks(const Stencil& stencil, BlockVector& f, BlockMatrix* K, BlockMatrix* C) {
  for (size_t i = 0; i < 2 && rolls_ && K && !mode_.convex; ++i) {
    const AxisRoll& roll = rolls_->ends[i];
    const Mat3 turned = torque_[i] * (roll.by_turn_turn - hat(roll.by_turn));
    block_of(g_.K, kTurns + i, kTurns + i) += shape_.axes(i) * turned * shape_.axes(i).transpose();
  }
  stencil.to_blocks(g_, !mode_.convex, f, K, C);
}

}  // namespace hawser
