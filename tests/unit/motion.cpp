// Prescribed motions of bodies: rates against differences, ramps, tables, drift, and the motion of points.
#include "hawser/kernels/motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "hawser/math/so3.hpp"

namespace hawser::motion_test {
namespace {

// Derivatives against central differences with one Richardson step (error of order h⁴).
void expect_derivatives(const RigidMotion& m, double t, double tolerance) {
  const double h = 2e-3;
  auto difference = [&](auto value) {
    auto central = [&](double d) { return Vec3((value(t + d) - value(t - d)) / (2 * d)); };
    return Vec3((4 * central(h / 2) - central(h)) / 3);
  };
  const RigidPose p = m.at(t);
  const Vec3 v = difference([&](double s) { return m.at(s).position; });
  const Vec3 a = difference([&](double s) { return m.at(s).velocity; });
  const Vec3 w = difference([&](double s) { return log_so3(m.at(s).rotation * p.rotation.conjugate()); });
  const Vec3 alpha = difference([&](double s) { return m.at(s).angular_velocity; });
  EXPECT_LT((v - p.velocity).norm(), tolerance * (1 + v.norm())) << "velocity at " << t;
  EXPECT_LT((a - p.acceleration).norm(), tolerance * (1 + a.norm())) << "acceleration at " << t;
  EXPECT_LT((w - p.angular_velocity).norm(), tolerance * (1 + w.norm())) << "angular velocity at " << t;
  EXPECT_LT((alpha - p.angular_acceleration).norm(), tolerance * (1 + alpha.norm()))
      << "angular acc. at " << t;
}

TEST(Motion, RampIsSmoothAndIntegrates) {
  EXPECT_DOUBLE_EQ(quintic_ramp(3, 3).value, 1);
  EXPECT_DOUBLE_EQ(quintic_ramp(1.5, 3).value, 0.5);
  EXPECT_DOUBLE_EQ(quintic_ramp(5, 3).integral, 3.5);
  EXPECT_DOUBLE_EQ(quintic_ramp(0, 0).value, 1);
  EXPECT_DOUBLE_EQ(quintic_ramp(0, 2).value, 0);
  double sum = 0;  // midpoint rule
  for (int i = 0; i < 2000; ++i) sum += quintic_ramp((i + 0.5) * 1e-3, 3).value * 1e-3;
  EXPECT_NEAR(quintic_ramp(2, 3).integral, sum, 1e-7);
}

TEST(Motion, SteadyDerivatives) {
  const RigidMotion m({1, 2, 3}, {0.3, -0.2, 0.5}, SteadyLaw{{0.5, -1, 2}, {1, 2, -2}, 1.7}, 4);
  for (double t : {0.5, 1.3, 2.9, 3.7, 6.0, 40.0}) expect_derivatives(m, t, 1e-8);
  // After the ramp the motion is late by half the ramp. The angle, measured in turns, does not wrap.
  const RigidPose p = m.at(10);
  EXPECT_NEAR((p.position - Vec3(1 + 0.5 * 8, 2 - 8, 3 + 16)).norm(), 0, 1e-12);
  EXPECT_NEAR(p.angular_velocity.norm(), 1.7, 1e-12);
  const Quat expected = exp_so3(Vec3(1, 2, -2) / 3 * 1.7 * 8) * exp_so3(Vec3(0.3, -0.2, 0.5));
  EXPECT_NEAR(std::abs(expected.dot(p.rotation)), 1, 1e-13);
}

TEST(Motion, HarmonicDerivatives) {
  const HarmonicLaw law{{1, 0.4, -2}, {0.3, -0.9, 1.6}, 5, {0, 1, 2}, {0.2, -0.7, 1.1}};
  for (double ramp : {0.0, 7.0}) {
    const RigidMotion m({0, 0, 1}, {0, 0.1, 0}, law, ramp);
    for (double t : {0.1, 1.0, 2.2, 5.5, 6.9, 13.0}) expect_derivatives(m, t, 1e-8);
  }
  EXPECT_NEAR(RigidMotion({0, 0, 0}, {0, 0, 0}, law).at(2.5).position.y(),
              0.4 * std::sin(std::acos(-1.0) + 1), 1e-14);
}

TEST(Motion, TableDerivativesAndContinuity) {
  const std::vector<double> time{0, 1, 1.5, 3, 4.5, 5};
  std::vector<Vec3> offset, rotation;
  for (double t : time) {
    offset.emplace_back(std::sin(t), t * t, std::cos(2 * t));
    rotation.emplace_back(0.1 * t * t, std::sin(t), 1.4 * t);  // beyond pi: no wrapping
  }
  const RigidMotion m({0, 0, 0}, {0.4, 0, 0}, TableLaw{{time, offset}, {time, rotation}}, 0);
  for (double t : {0.3, 1.2, 2.0, 3.3, 4.8, 6.0}) expect_derivatives(m, t, 1e-8);
  for (size_t i = 0; i < time.size(); ++i) EXPECT_NEAR((m.at(time[i]).position - offset[i]).norm(), 0, 1e-13);
  for (double knot : {1.0, 1.5, 3.0, 4.5, 5.0}) {  // C2 at the knots and at the last row
    const RigidPose a = m.at(knot - 1e-9);
    const RigidPose b = m.at(knot + 1e-9);
    EXPECT_NEAR((a.velocity - b.velocity).norm(), 0, 1e-7);
    EXPECT_NEAR((a.acceleration - b.acceleration).norm(), 0, 1e-7);
    EXPECT_NEAR((a.angular_acceleration - b.angular_acceleration).norm(), 0, 1e-7);
  }
}

// A body moves by 1 m in a second and stops: a spline oscillates around these rows.
TEST(Motion, CurvesBetweenRows) {
  const std::vector<double> time{0, 1, 2, 3, 4.5, 6};
  std::vector<Vec3> offset, rotation;
  for (const double z : {0.0, 0.0, 1.0, 1.0, 0.4, 0.7}) offset.emplace_back(z, -2 * z, 0);
  for (const double t : time) rotation.emplace_back(0, 0.3 * t * t, 0.1 * t);
  const auto motion = [&](BetweenRows between) {
    return RigidMotion({0, 0, 0}, {0.4, 0, 0}, TableLaw{{time, offset, between}, {time, rotation, between}},
                       0);
  };
  for (const BetweenRows between : {BetweenRows::spline, BetweenRows::monotone, BetweenRows::linear}) {
    const RigidMotion m = motion(between);
    for (double t : {0.3, 1.2, 2.7, 3.3, 5.8, 6.5}) expect_derivatives(m, t, 1e-8);
    for (size_t i = 0; i < time.size(); ++i)
      EXPECT_NEAR((m.at(time[i]).position - offset[i]).norm(), 0, 1e-13);
    // The curve is between neighbouring rows, except for the spline.
    const RowCurve curve(time, offset, between);
    double out = 0;
    for (size_t i = 0; i + 1 < time.size(); ++i)
      for (double z = 0.01; z < 1; z += 0.01) {
        const double x = curve.at(time[i] + z * (time[i + 1] - time[i])).value.x();
        out = std::max({out, x - std::max(offset[i].x(), offset[i + 1].x()),
                        std::min(offset[i].x(), offset[i + 1].x()) - x});
      }
    const auto found = curve.overshoots(0.02);
    if (between == BetweenRows::spline) {
      double most = 0;
      for (const auto& o : found) most = std::max(most, o.component == 0 ? o.excess : 0);
      EXPECT_GT(out, 0.1);
      EXPECT_NEAR(most, out, 1e-3);
      // The reported place is the maximum of the curve, where the slope is zero.
      for (const auto& o : found) {
        EXPECT_NEAR(curve.at(o.time).value[o.component], o.value, 1e-14);
        EXPECT_NEAR(curve.at(o.time).rate[o.component], 0, 1e-12);
        EXPECT_TRUE(time[o.row] < o.time && o.time < time[o.row + 1]);
      }
    } else {
      EXPECT_LT(out, 1e-14);
      EXPECT_TRUE(found.empty());
    }
  }
  // The velocity of the monotone curve is continuous; that of the polyline jumps at a row to the value after
  // the row.
  const RigidMotion monotone = motion(BetweenRows::monotone);
  const RigidMotion linear = motion(BetweenRows::linear);
  for (const double row : {1.0, 2.0, 3.0, 4.5})
    EXPECT_NEAR((monotone.at(row - 1e-9).velocity - monotone.at(row + 1e-9).velocity).norm(), 0, 1e-7);
  EXPECT_EQ(linear.at(0.999).velocity.x(), 0);
  EXPECT_EQ(linear.at(1).velocity.x(), 1);
  EXPECT_EQ(linear.at(2).velocity.x(), 0);
  EXPECT_EQ(linear.at(1.5).acceleration.norm(), 0);
  EXPECT_NEAR(linear.at(1.5).position.y(), -1, 1e-14);
}

// Drift and the motion superposed on it: a body rolls about its own axis while it drifts and rotates.
TEST(Motion, DriftCarriesTheOtherMotion) {
  DriftLaw drift;
  drift.offset = Vec3(20, -5, 1);
  drift.rotation = Vec3(0.05, 0, 0.4);
  drift.harmonic = {{8, 3, 0}, {0, 0, 0.3}, 120, {0, 1, 0}, {0, 0, 0.5}};
  const std::vector<double> time{-1, 10, 25, 60};
  drift.table.offset = {time, {Vec3(0, 0, 0), Vec3(1, 2, 0), Vec3(4, -2, 0.5), Vec3(0, 1, 0)}};
  drift.table.rotation = {time, {Vec3(0, 0, 0), Vec3(0, 0, 0.2), Vec3(0.02, 0, -0.3), Vec3(0, 0, 0.1)}};
  const HarmonicLaw law{{1, 0.4, -2}, {0.3, -0.1, 0.2}, 5, {0, 1, 2}, {0.2, -0.7, 1.1}};
  for (const double ramp : {0.0, 30.0}) {
    drift.ramp = ramp;
    RigidMotion m({3, 1, 2}, {0.1, 0.2, -0.4}, law, 3);
    m.set_drift(drift);
    for (double t : {0.4, 1.0, 2.2, 5.5, 12.9, 29.0, 47.0}) expect_derivatives(m, t, 1e-8);
    // The pose equals that of two nested rigid motions.
    const RigidMotion carried({3, 1, 2}, {0.1, 0.2, -0.4}, law, 3);
    VectorMotion moved, turned;
    drift.at(7, moved, turned);
    const RigidPose p = m.at(7);
    const RigidPose q = carried.at(7);
    const Quat D = exp_so3(turned.value);
    EXPECT_LT((p.position - (Vec3(3, 1, 2) + moved.value + D * (q.position - Vec3(3, 1, 2)))).norm(), 1e-13);
    EXPECT_NEAR(std::abs((D * q.rotation).dot(p.rotation)), 1, 1e-14);
    // The body is at rest before the start; without a ramp the drift is present from statics on.
    EXPECT_EQ(m.at(-1).velocity.norm(), 0);
    EXPECT_NEAR((m.at(0).position - Vec3(3, 1, 2)).norm() > 15, ramp == 0, 0);
  }
  // Drift without another motion is the motion of the body.
  RigidMotion still({0, 0, 0}, {0, 0, 0});
  EXPECT_FALSE(still.moves());
  DriftLaw offset;
  offset.offset = Vec3(5, 0, 0);
  still.set_drift(offset);
  EXPECT_TRUE(still.moves());
  EXPECT_EQ(still.at(3).position, Vec3(5, 0, 0));
  offset.harmonic.period = 0;
  EXPECT_THROW(still.set_drift(offset), std::invalid_argument);
}

TEST(Motion, RatesAreContinuousAcrossTheSeriesSwitch) {
  const Vec3 u = Vec3(1, -2, 0.5).normalized();
  const Vec3 d(0.3, 0.7, -1.1);
  const Vec3 dd(-2, 0.4, 0.9);
  Vec3 w0, a0, w1, a1;
  angular_rates({(0.3 - 1e-12) * u, d, dd}, w0, a0);
  angular_rates({(0.3 + 1e-12) * u, d, dd}, w1, a1);
  EXPECT_LT((w0 - w1).norm(), 1e-11);
  EXPECT_LT((a0 - a1).norm(), 1e-11);
}

TEST(Motion, PointOfABody) {
  const RigidMotion m({1, 2, 3}, {0.3, -0.2, 0.5}, SteadyLaw{{0.5, -1, 2}, {1, 2, -2}, 1.7}, 4);
  const Vec3 y(0.3, 0.8, -1.1);
  const double t = 2.7, h = 1e-4;
  const RigidPose p = m.at(t);
  const Vec3 x = p.to_space(y);
  EXPECT_NEAR((p.to_body(x) - y).norm(), 0, 1e-14);
  const Vec3 before = m.at(t - h).to_space(y);
  const Vec3 after = m.at(t + h).to_space(y);
  EXPECT_NEAR((p.velocity_at(x) - (after - before) / (2 * h)).norm(), 0, 1e-6);
  EXPECT_NEAR((p.acceleration_at(x) - (after - 2 * x + before) / (h * h)).norm(), 0, 1e-5);
}

TEST(Motion, RestsBeforeTimeZeroAndRefusesNonsense) {
  const RigidMotion m({0, 0, 0}, {0, 0, 0}, SteadyLaw{{1, 0, 0}, {0, 0, 1}, 1});
  EXPECT_EQ(m.at(-1).velocity.norm(), 0);
  EXPECT_EQ(m.at(-1).position.norm(), 0);
  EXPECT_EQ(m.at(0).velocity.x(), 1);
  const Vec3 o = Vec3::Zero();
  EXPECT_THROW(RigidMotion(o, o, SteadyLaw{o, o, 1}), std::invalid_argument);
  EXPECT_THROW(RigidMotion(o, o, HarmonicLaw{o, o, 0, o, o}), std::invalid_argument);
  EXPECT_THROW(RowCurve({0, 0}, {o, o}), std::invalid_argument);
  EXPECT_THROW(RowCurve({0, 1}, {o}), std::invalid_argument);
}

}  // namespace
}  // namespace hawser::motion_test
