// Derivatives along an element axis of the contact force with a volume and of the elastic slip by automatic
// differentiation, for the contribution of moving interval ends to the tangent.
#include "hawser/kernels/contact_rates.hpp"

#include <unsupported/Eigen/AutoDiff>

#include "point_friction.hpp"

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

// turn, turn_rate: rotation of the surface at the arm trial.lever, and its derivative.
Vec3 force_along(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                 const ContactRates& by, const Vec3& turn, const Vec3& turn_rate) {
  const Vec3& n = trial.normal;
  const NormalForce N = normal_force(law.normal, trial.gap, n.dot(trial.velocity));
  if (!(N.force > 0)) return Vec3::Zero();
  const Vec3 n_rate = trial.curvature * by.point;
  const double gap_rate = n.dot(by.point);
  const double N_rate = N.by_gap * gap_rate + N.by_rate * (n_rate.dot(trial.velocity) + n.dot(by.velocity));
  const Vec3 normal_part = N_rate * n + N.force * n_rate;
  if (!law.friction.active()) return normal_part;

  PointState<Dual> state;
  state.gap = dual(trial.gap, gap_rate);
  state.force = dual(N.force, N_rate);
  state.lever = trial.lever;
  state.step = trial.step;
  state.turn = dual(turn, turn_rate);
  state.point = dual(trial.point, by.point);
  state.normal = dual(n, n_rate);
  state.velocity = dual(trial.velocity, by.velocity);
  const ContactStartOf<Dual> from{dual(start.point, by.start_point),     dual(start.gap, by.start_gap),
                                  dual(start.tangent, by.start_tangent), dual(start.slip, by.start_slip),
                                  dual(start.normal, by.start_normal),   dual(start.peak, by.start_peak)};
  return normal_part + rate(point_friction(law, from, state).force);
}

}  // namespace

Vec3 contact_force_along(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                         const ContactRates& by) {
  return force_along(law, start, trial, by, trial.roll * start.tangent,
                     trial.roll * by.start_tangent + by.roll * start.tangent);
}

Vec3 ball_force_along(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                      const Vec3& turn, const ContactRates& by) {
  return force_along(law, start, trial, by, turn, Vec3::Zero());
}

SlipBetween slip_between(const Vec3& slip_a, const Vec3& normal_a, const Vec3& slip_b, const Vec3& normal_b,
                         double t, bool derivatives) {
  SlipBetween out;
  const Vec3 mean = (1 - t) * normal_a + t * normal_b;
  const Vec3 difference = normal_b - normal_a;
  const double size = mean.norm();
  out.normal = mean / size;
  out.normal_by_t = (difference - out.normal * out.normal.dot(difference)) / size;
  if (!derivatives) {
    out.slip = (1 - t) * transport_slip<double>(slip_a, normal_a, out.normal) +
               t * transport_slip<double>(slip_b, normal_b, out.normal);
    out.slip_by_t.setZero();
    return out;
  }
  const Vector3<Dual> to = dual(out.normal, out.normal_by_t);
  const Vector3<Dual> a = transport_slip<Dual>(slip_a, normal_a, to);
  const Vector3<Dual> b = transport_slip<Dual>(slip_b, normal_b, to);
  out.slip = (1 - t) * value(a) + t * value(b);
  out.slip_by_t = (1 - t) * rate(a) + t * rate(b) - value(a) + value(b);
  return out;
}

}  // namespace hawser
