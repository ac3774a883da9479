// Normal force and friction with elastic slip at one point of a line against a volume or the seabed, and
// their derivatives by position, velocity and roll by automatic differentiation. The scalar laws are in
// contact_law.hpp (normal force) and friction_law.hpp; terms/axis_contact.cpp sums along an element,
// terms/seabed.cpp over nodes.
#include "hawser/kernels/volume_contact.hpp"

#include <unsupported/Eigen/AutoDiff>

#include "point_friction.hpp"

namespace hawser {
namespace {

// Derivatives by the three coordinates of the point and by the rate of the gap; where friction depends on the
// speed, by point and velocity.
using Dual = Eigen::AutoDiffScalar<Eigen::Vector4d>;
using Dual1 = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
using Dual6 = Eigen::AutoDiffScalar<Eigen::Matrix<double, 6, 1>>;

PointState<double> plain(const ContactTrial& t, const NormalForce& n) {
  return {t.gap, n.force, t.roll, t.lever, t.point, t.normal, t.velocity};
}

PointState<Dual> dual(const ContactTrial& t, const NormalForce& n) {
  const auto made = [](double value, const Vec3& by_point, double by_rate) {
    return Dual(value, Eigen::Vector4d(by_point.x(), by_point.y(), by_point.z(), by_rate));
  };
  PointState<Dual> l;
  l.gap = made(t.gap, t.normal, 0);
  l.force = made(n.force, n.by_gap * t.normal, n.by_rate);
  for (int c = 0; c < 3; ++c) {
    l.point[c] = made(t.point[c], Vec3::Unit(c), 0);
    l.normal[c] = made(t.normal[c], t.curvature.col(c), 0);
  }
  l.roll = made(t.roll, Vec3::Zero(), 0), l.lever = t.lever;
  return l;
}

PointState<Dual6> dual6(const ContactTrial& t, const NormalForce& n) {
  const auto made = [](double value, const Vec3& by_point, const Vec3& by_velocity) {
    Eigen::Matrix<double, 6, 1> d;
    d << by_point, by_velocity;
    return Dual6(value, d);
  };
  const Vec3 none = Vec3::Zero();
  PointState<Dual6> l;
  l.gap = made(t.gap, t.normal, none);
  l.force = made(n.force, n.by_gap * t.normal + n.by_rate * (t.curvature * t.velocity), n.by_rate * t.normal);
  for (int c = 0; c < 3; ++c) {
    l.point[c] = made(t.point[c], Vec3::Unit(c), none);
    l.normal[c] = made(t.normal[c], t.curvature.col(c), none);
    l.velocity[c] = made(t.velocity[c], none, Vec3::Unit(c));
  }
  l.roll = made(t.roll, none, none), l.lever = t.lever;
  return l;
}

// Only the roll changes.
PointState<Dual1> rolling(const ContactTrial& t, const NormalForce& n) {
  PointState<Dual1> l;
  l.gap = Dual1(t.gap), l.force = Dual1(n.force);
  l.roll = Dual1(t.roll, Eigen::Matrix<double, 1, 1>(1.0)), l.lever = t.lever;
  l.point = t.point.cast<Dual1>(), l.normal = t.normal.cast<Dual1>(), l.velocity = t.velocity.cast<Dual1>();
  return l;
}

template <class S>
void put(const Friction<S>& f, PointContact& r) {
  for (int c = 0; c < 3; ++c) r.friction[c] = f.force[c].value(), r.slip[c] = f.slip[c].value();
  r.slides = f.slides;
}

}  // namespace

PointContact volume_contact(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                            bool derivatives) {
  PointContact r;
  const Vec3& n = trial.normal;
  r.normal = normal_force(law.normal, trial.gap, n.dot(trial.velocity));
  if (!(r.normal.force > 0)) return r;
  r.force = r.normal.force * n;
  if (derivatives) {
    const Vec3 rate_by_point = trial.curvature * trial.velocity;
    r.by_point = n * (r.normal.by_gap * n + r.normal.by_rate * rate_by_point).transpose() +
                 r.normal.force * trial.curvature;
    r.by_velocity = r.normal.by_rate * n * n.transpose();
    if (law.friction.active() && law.friction.blends()) {
      const Friction<Dual6> f = point_friction(law, start, dual6(trial, r.normal));
      put(f, r);
      for (int c = 0; c < 3; ++c) {
        r.by_point.row(c) += f.force[c].derivatives().head<3>().transpose();
        r.by_velocity.row(c) += f.force[c].derivatives().tail<3>().transpose();
      }
    } else if (law.friction.active()) {
      const Friction<Dual> f = point_friction(law, start, dual(trial, r.normal));
      put(f, r);
      Vec3 by_rate;
      for (int c = 0; c < 3; ++c) {
        r.by_point.row(c) += f.force[c].derivatives().head<3>().transpose();
        by_rate[c] = f.force[c].derivatives()[3];
      }
      r.by_point += by_rate * rate_by_point.transpose();
      r.by_velocity += by_rate * n.transpose();
    }
    if (law.friction.active() && trial.lever > 0) {
      const Friction<Dual1> f = point_friction(law, start, rolling(trial, r.normal));
      for (int c = 0; c < 3; ++c) r.by_roll[c] = f.force[c].derivatives()[0];
    }
  } else if (law.friction.active()) {
    const Friction<double> f = point_friction(law, start, plain(trial, r.normal));
    r.friction = f.force;
    r.slip = f.slip;
    r.slides = f.slides;
  }
  r.force += r.friction;
  return r;
}

}  // namespace hawser
