// Normal force and friction with elastic slip at one point of a line against a volume or the seabed, and
// their derivatives by position, velocity and roll by automatic differentiation. The scalar laws are in
// contact_law.hpp (normal force) and friction_law.hpp; terms/contact_along_axis.cpp sums along an element,
// terms/seabed.cpp over nodes.
#include "hawser/kernels/surface_contact_law.hpp"

#include <unsupported/Eigen/AutoDiff>

#include "point_friction.hpp"

namespace hawser {
namespace {

// Derivatives are by point, velocity and roll.
constexpr int kInputs = 7, kVelocity = 3, kRoll = 6;
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, kInputs, 1>>;

PointState<Dual> dual(const ContactTrial& t, const NormalForce& n) {
  const auto made = [](double value, const Vec3& by_point, const Vec3& by_velocity) {
    Dual d(value, Eigen::Matrix<double, kInputs, 1>::Zero());
    d.derivatives().head<3>() = by_point;
    d.derivatives().segment<3>(kVelocity) = by_velocity;
    return d;
  };
  const Vec3 none = Vec3::Zero();
  PointState<Dual> s;
  s.gap = made(t.gap, t.normal, none);
  s.force = made(n.force, n.by_gap * t.normal + n.by_rate * (t.curvature * t.velocity), n.by_rate * t.normal);
  for (int c = 0; c < 3; ++c) {
    s.point[c] = made(t.point[c], Vec3::Unit(c), none);
    s.normal[c] = made(t.normal[c], t.curvature.col(c), none);
    s.velocity[c] = made(t.velocity[c], none, Vec3::Unit(c));
  }
  s.roll = Dual(t.roll, kInputs, kRoll);
  s.lever = t.lever;
  return s;
}

}  // namespace

// F = N(g, g') n + T(s, N): normal force and friction, with n = n(y), dn/dy = H and g' = n.u
// (docs/theory/contact.md). By y: n (N_g n + N_g' H u)' + N H of the normal force, by u: N_g' n n'.
PointContact volume_contact(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                            bool derivatives) {
  PointContact r;
  const Vec3& n = trial.normal;
  r.normal = normal_force(law.normal, trial.gap, n.dot(trial.velocity));
  if (!(r.normal.force > 0)) return r;
  r.force = r.normal.force * n;
  if (derivatives) {
    r.by_point =
        n * (r.normal.by_gap * n + r.normal.by_rate * (trial.curvature * trial.velocity)).transpose() +
        r.normal.force * trial.curvature;
    r.by_velocity = r.normal.by_rate * n * n.transpose();
  }
  if (law.friction.active() && derivatives) {
    const Friction<Dual> f = point_friction(law, start, dual(trial, r.normal));
    for (int c = 0; c < 3; ++c) {
      const auto& by = f.force[c].derivatives();
      r.friction[c] = f.force[c].value();
      r.slip[c] = f.slip[c].value();
      r.by_point.row(c) += by.head<3>().transpose();
      r.by_velocity.row(c) += by.segment<3>(kVelocity).transpose();
      r.by_roll[c] = by[kRoll];
    }
    r.slides = f.slides;
  } else if (law.friction.active()) {
    const Friction<double> f =
        point_friction(law, start,
                       PointState<double>{trial.gap, r.normal.force, trial.roll, trial.lever, trial.point, n,
                                          trial.velocity});
    r.friction = f.force;
    r.slip = f.slip;
    r.slides = f.slides;
  }
  r.force += r.friction;
  return r;
}

}  // namespace hawser
