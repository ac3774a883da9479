// Normal force and friction with elastic slip at one point of a line against a volume or the seabed, and
// their derivatives by position, velocity and roll: of the normal force by formula, of friction by automatic
// differentiation. The scalar laws are in contact_law.hpp (normal force) and friction_law.hpp;
// terms/contact_along_axis.cpp sums along an element, terms/bed_contact.cpp over nodes and middles of
// elements.
#include "hawser/kernels/surface_contact_law.hpp"

#include <unsupported/Eigen/AutoDiff>

#include "point_friction.hpp"

namespace hawser {
namespace {

// Rotation `turn` [rad] in the directions of the columns of `by`.
template <int kTurns>
struct Rotation {
  Vec3 turn;
  Eigen::Matrix<double, 3, kTurns> by;
};

// Derivatives by point, velocity and rotation.
constexpr int kVelocity = 3, kTurn = 6;
template <int kTurns>
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, kTurn + kTurns, 1>>;

template <int kTurns>
PointState<Dual<kTurns>> dual(const ContactTrial& t, const NormalForce& n, const Rotation<kTurns>& r) {
  using D = Dual<kTurns>;
  const auto make_dual = [](double value, const Vec3& by_point, const Vec3& by_velocity) {
    D d(value, D::DerType::Zero());
    d.derivatives().template head<3>() = by_point;
    d.derivatives().template segment<3>(kVelocity) = by_velocity;
    return d;
  };
  const Vec3 none = Vec3::Zero();
  PointState<D> s;
  s.gap = make_dual(t.gap, t.normal, none);
  s.force =
      make_dual(n.force, n.by_gap * t.normal + n.by_rate * (t.curvature * t.velocity), n.by_rate * t.normal);
  for (int c = 0; c < 3; ++c) {
    s.point[c] = make_dual(t.point[c], Vec3::Unit(c), none);
    s.normal[c] = make_dual(t.normal[c], t.curvature.col(c), none);
    s.velocity[c] = make_dual(t.velocity[c], none, Vec3::Unit(c));
  }
  s.lever = t.lever;
  s.step = t.step;
  for (int c = 0; c < 3 && t.lever > 0; ++c) {
    s.turn[c] = make_dual(r.turn[c], none, none);
    s.turn[c].derivatives().template tail<kTurns>() = r.by.row(c).transpose();
  }
  return s;
}

// Adds friction to the normal force; by_turn: derivative of the force by the rotation.
// flatten: otherwise most operations on dual numbers are function calls.
template <int kTurns>
[[gnu::flatten]] void add_friction(const ContactLaw& law, const ContactStart& start,
                                   const ContactTrial& trial, const Rotation<kTurns>& rotation,
                                   bool derivatives, ContactForce& r,
                                   Eigen::Matrix<double, 3, kTurns>& by_turn) {
  if (derivatives) {
    const Friction<Dual<kTurns>> f = point_friction(law, start, dual(trial, r.along_normal, rotation));
    for (int c = 0; c < 3; ++c) {
      const auto& by = f.force[c].derivatives();
      r.friction[c] = f.force[c].value();
      r.slip[c] = f.slip[c].value();
      r.by_point.row(c) += by.template head<3>().transpose();
      r.by_velocity.row(c) += by.template segment<3>(kVelocity).transpose();
      by_turn.row(c) = by.template tail<kTurns>().transpose();
    }
    r.peak = f.peak.value();
    r.slides = f.slides;
  } else {
    const Friction<double> f =
        point_friction(law, start,
                       PointState<double>{trial.gap, r.along_normal.force, trial.lever, trial.step,
                                          rotation.turn, trial.point, trial.normal, trial.velocity});
    r.friction = f.force;
    r.slip = f.slip;
    r.peak = f.peak;
    r.slides = f.slides;
  }
  r.force += r.friction;
}

// F = N(g, r) n, with n = n(y), dn/dy = H and the gap rate r = n.u (docs/theory/contact.md; N:
// kernels/contact_law.hpp). Derivative by y: n (N_g n + N_r H u)^T + N H; by u: N_r n n^T.
ContactForce without_friction(const ContactLaw& law, const ContactTrial& trial, bool derivatives) {
  ContactForce r;
  const Vec3& n = trial.normal;
  r.along_normal = normal_force(law.normal, trial.gap, n.dot(trial.velocity));
  if (!(r.along_normal.force > 0)) return r;
  r.force = r.along_normal.force * n;
  if (derivatives) {
    r.by_point = n * (r.along_normal.by_gap * n + r.along_normal.by_rate * (trial.curvature * trial.velocity))
                         .transpose() +
                 r.along_normal.force * trial.curvature;
    r.by_velocity = r.along_normal.by_rate * n * n.transpose();
  }
  return r;
}

}  // namespace

ContactForce surface_contact(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                             bool derivatives) {
  ContactForce r = without_friction(law, trial, derivatives);
  if (!(r.along_normal.force > 0) || !law.friction.active()) return r;
  const Rotation<1> roll{trial.roll * start.tangent, start.tangent};
  add_friction(law, start, trial, roll, derivatives, r, r.by_roll);
  return r;
}

BallContact ball_contact(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                         const Vec3& turn, bool derivatives) {
  BallContact r{without_friction(law, trial, derivatives)};
  if (!(r.along_normal.force > 0) || !law.friction.active()) return r;
  add_friction(law, start, trial, Rotation<3>{turn, Mat3::Identity()}, derivatives, r, r.by_turn);
  return r;
}

}  // namespace hawser
