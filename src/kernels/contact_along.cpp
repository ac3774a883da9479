// Derivatives along an element axis of the contact force with a volume and of the elastic slip, by automatic
// differentiation: what moving ends of a contact stretch add to the tangent.
#include "hawser/kernels/contact_along.hpp"

#include <unsupported/Eigen/AutoDiff>

namespace hawser {
namespace {

using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;

Dual dual(double value, double rate) { return {value, Eigen::Matrix<double, 1, 1>(rate)}; }
Vector3<Dual> dual(const Vec3& value, const Vec3& rate) {
  return {dual(value[0], rate[0]), dual(value[1], rate[1]), dual(value[2], rate[2])};
}
Vec3 value(const Vector3<Dual>& v) { return {v[0].value(), v[1].value(), v[2].value()}; }
Vec3 rate(const Vector3<Dual>& v) {
  return {v[0].derivatives()[0], v[1].derivatives()[0], v[2].derivatives()[0]};
}

// transport_slip with all three moving. It turns with its arguments, so it is looked at from axes that turn
// with `from`, in which that one stands still.
Vector3<Dual> transport(const Vec3& slip, const Vec3& slip_rate, const Vec3& from, const Vec3& from_rate,
                        const Vector3<Dual>& to) {
  const Vec3 turn = from.cross(from_rate), to0 = value(to);
  const Vector3<Dual> moved = transport_slip<Dual>(slip, from, dual(to0, Vec3(rate(to) - turn.cross(to0))));
  const Vec3 changed = transport_slip<double>(slip_rate - turn.cross(slip), from, to0);
  const Vec3 v = value(moved);
  return dual(v, Vec3(turn.cross(v) + rate(moved) + changed));
}

}  // namespace

Vec3 contact_force_along(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                         const ContactRates& by) {
  const Vec3& n = trial.normal;
  const NormalForce N = normal_force(law.normal, trial.gap, n.dot(trial.velocity));
  if (!(N.force > 0)) return Vec3::Zero();
  const Vec3 n_rate = trial.curvature * by.point;
  const double gap_rate = n.dot(by.point);
  const double N_rate = N.by_gap * gap_rate + N.by_rate * (n_rate.dot(trial.velocity) + n.dot(by.velocity));
  const Vec3 normal_part = N_rate * n + N.force * n_rate;
  if (!law.friction.active()) return normal_part;

  const Vector3<Dual> normal = dual(n, n_rate);
  Vector3<Dual> slip = dual(trial.point - start.point, by.point - by.start_point);
  slip -= normal * Dual(normal.dot(slip));
  if (trial.lever > 0)
    slip -= dual(start.tangent, by.start_tangent).cross(normal) *
            Dual(dual(trial.roll * trial.lever, by.roll * trial.lever));
  const double touch = law.normal.smoothing;
  if (start.gap > touch) {
    const Dual gap = dual(trial.gap, gap_rate), before = dual(start.gap, by.start_gap);
    slip *= Dual((touch - gap) / (before - gap));
  }
  if (!start.slip.isZero(0) || !by.start_slip.isZero(0))
    slip += transport(start.slip, by.start_slip, start.normal, by.start_normal, normal);
  // The law turns with its arguments: seen from axes that turn with the line its tangent stands still.
  const Vec3 turn = start.tangent.cross(by.start_tangent), s = value(slip);
  const auto seen = [&turn](const Vec3& v, const Vec3& v_rate) {
    return dual(v, Vec3(v_rate - turn.cross(v)));
  };
  const Vector3<Dual> slip_there = seen(s, rate(slip)), normal_there = seen(n, n_rate);
  const Dual force_there = dual(N.force, N_rate);
  Friction<Dual> f;
  if (law.friction.blends()) {
    const Vector3<Dual> v = seen(trial.velocity, by.velocity);
    const Vector3<Dual> along = v - normal_there * Dual(normal_there.dot(v));
    const Coulomb<Dual> mu = coulomb_at<Dual>(law.friction, along.squaredNorm());
    f = friction<Dual, Dual>(law.friction, mu, force_there, slip_there, normal_there, start.tangent);
  } else {
    f = friction<Dual>(law.friction, force_there, slip_there, normal_there, start.tangent);
  }
  Vec3 force, by_xi;
  for (int c = 0; c < 3; ++c) force[c] = f.force[c].value(), by_xi[c] = f.force[c].derivatives()[0];
  return normal_part + by_xi + turn.cross(force);
}

SlipBetween slip_between(const Vec3& slip_a, const Vec3& normal_a, const Vec3& slip_b, const Vec3& normal_b,
                         double t, bool derivatives) {
  SlipBetween out;
  const Vec3 mean = (1 - t) * normal_a + t * normal_b, apart = normal_b - normal_a;
  const double size = mean.norm();
  out.normal = mean / size;
  out.normal_by_t = (apart - out.normal * out.normal.dot(apart)) / size;
  if (!derivatives) {
    out.slip = (1 - t) * transport_slip<double>(slip_a, normal_a, out.normal) +
               t * transport_slip<double>(slip_b, normal_b, out.normal);
    out.slip_by_t.setZero();
    return out;
  }
  const Vector3<Dual> to = dual(out.normal, out.normal_by_t);
  const Vector3<Dual> a = transport_slip<Dual>(slip_a, normal_a, to),
                      b = transport_slip<Dual>(slip_b, normal_b, to);
  out.slip = (1 - t) * value(a) + t * value(b);
  out.slip_by_t = (1 - t) * rate(a) + t * rate(b) - value(a) + value(b);
  return out;
}

}  // namespace hawser
