// Prescribed motion as a function of time: smooth ramp, curves through the rows of a table, harmonics and
// drift; angular velocity and acceleration from a rotation vector; pose of a body.
#include "hawser/kernels/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hawser/math/gauss_points.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {

Ramp quintic_ramp(double t, double duration) {
  if (t <= 0 && duration > 0) return {0, 0, 0, 0};
  if (t < 0) return {0, 0, 0, 0};
  if (t >= duration) return {1, 0, 0, t - 0.5 * duration};
  const double z = t / duration;
  const double z2 = z * z;
  return {z2 * z * (10 + z * (6 * z - 15)), 30 * z2 * (1 - z) * (1 - z) / duration,
          60 * z * (1 - z) * (1 - 2 * z) / (duration * duration), duration * z2 * z2 * (2.5 + z * (z - 3))};
}

void angular_rates(const VectorMotion& psi, Vec3& omega, Vec3& alpha) {
  const Vec3& p = psi.value;
  const Vec3& d = psi.rate;
  const Vec3& dd = psi.second;
  const double t2 = p.squaredNorm();
  const double t = std::sqrt(t2);
  double a, b, a1, b1;  // a1 = (da/dp)/p, b1 = (db/dp)/p
  if (t2 < 0.09) {      // the closed forms lose digits as p⁻⁴
    a = 0.5 - t2 * (1.0 / 24 - t2 * (1.0 / 720 - t2 * (1.0 / 40320 - t2 / 3628800)));
    b = 1.0 / 6 - t2 * (1.0 / 120 - t2 * (1.0 / 5040 - t2 * (1.0 / 362880 - t2 / 39916800)));
    a1 = -1.0 / 12 + t2 * (1.0 / 180 - t2 * (1.0 / 6720 - t2 * (1.0 / 453600 - t2 / 47900160)));
    b1 = -1.0 / 60 + t2 * (1.0 / 1260 - t2 * (1.0 / 60480 - t2 * (1.0 / 4989600 - t2 / 622702080)));
  } else {
    const double c = std::cos(t);
    const double s = std::sin(t);
    a = (1 - c) / t2;
    b = (t - s) / (t2 * t);
    a1 = (t * s - 2 * (1 - c)) / (t2 * t2);
    b1 = (3 * s - 2 * t - t * c) / (t2 * t2 * t);
  }
  const Vec3 pd = p.cross(d);
  const Vec3 ppd = p.cross(pd);
  const Vec3 pdd = p.cross(dd);
  const double r = p.dot(d);
  omega = d + a * pd + b * ppd;
  alpha = dd + a * pdd + b * p.cross(pdd) + r * (a1 * pd + b1 * ppd) + b * d.cross(pd);
}

RowCurve::RowCurve(std::vector<double> time, std::vector<Vec3> value, BetweenRows between)
    : time_(std::move(time)), value_(std::move(value)) {
  if (time_.size() != value_.size()) throw std::invalid_argument("a motion table needs one value a time");
  for (size_t i = 1; i < time_.size(); ++i)
    if (!(time_[i] > time_[i - 1])) throw std::invalid_argument("the times of a motion table must increase");
  if (time_.size() < 2) return;
  bend_.assign(time_.size() - 1, {Vec3::Zero(), Vec3::Zero()});
  if (time_.size() < 3) return;
  if (between == BetweenRows::spline) bend_spline();
  if (between == BetweenRows::monotone) bend_monotone();
}

// Second derivatives m: h0 m[i-1] + 2 (h0 + h1) m[i] + h1 m[i+1] = 6 (slope1 - slope0), zero at both ends.
void RowCurve::bend_spline() {
  const size_t n = time_.size();
  std::vector<double> upper(n, 0);
  std::vector<Vec3> m(n, Vec3::Zero());
  for (size_t i = 1; i + 1 < n; ++i) {
    const double h0 = time_[i] - time_[i - 1];
    const double h1 = time_[i + 1] - time_[i];
    const Vec3 jump = (value_[i + 1] - value_[i]) / h1 - (value_[i] - value_[i - 1]) / h0;
    const double pivot = 2 * (h0 + h1) - h0 * upper[i - 1];
    upper[i] = h1 / pivot;
    m[i] = (6 * jump - h0 * m[i - 1]) / pivot;
  }
  for (size_t i = n - 2; i > 0; --i) m[i] -= upper[i] * m[i + 1];
  for (size_t i = 0; i + 1 < n; ++i) bend_[i] = {m[i], m[i + 1]};
}

// Slopes at the rows: weighted harmonic mean of the secants, zero where they differ in sign; at the ends that
// of a parabola, limited to what keeps the curve monotone.
void RowCurve::bend_monotone() {
  const size_t n = time_.size();
  std::vector<double> h(n - 1);
  std::vector<Vec3> secant(n - 1);
  std::vector<Vec3> slope(n, Vec3::Zero());
  for (size_t i = 0; i + 1 < n; ++i) {
    h[i] = time_[i + 1] - time_[i];
    secant[i] = (value_[i + 1] - value_[i]) / h[i];
  }
  const auto end = [](double chord, double next) {
    const double parabola = 2 * chord - next;
    return chord > 0 ? std::clamp(parabola, 0.0, 3 * chord) : std::clamp(parabola, 3 * chord, 0.0);
  };
  for (int c = 0; c < 3; ++c) {
    for (size_t i = 1; i + 1 < n; ++i) {
      const double before = secant[i - 1][c];
      const double after = secant[i][c];
      const double a = 2 * h[i] + h[i - 1];
      const double b = h[i] + 2 * h[i - 1];
      if (before * after > 0) slope[i][c] = (a + b) / (a / before + b / after);
    }
    slope[0][c] = end(secant[0][c], slope[1][c]);
    slope[n - 1][c] = end(secant[n - 2][c], slope[n - 2][c]);
  }
  for (size_t i = 0; i + 1 < n; ++i)
    bend_[i] = {(6 * secant[i] - 4 * slope[i] - 2 * slope[i + 1]) / h[i],
                (2 * slope[i] + 4 * slope[i + 1] - 6 * secant[i]) / h[i]};
}

VectorMotion RowCurve::at(double t) const {
  if (time_.empty()) return {};
  if (time_.size() == 1) return {value_[0], Vec3::Zero(), Vec3::Zero()};
  const auto above = std::upper_bound(time_.begin() + 1, time_.end() - 1, t);
  const size_t j = above - time_.begin();
  const size_t i = j - 1;
  const double h = time_[j] - time_[i];
  const double at = std::clamp(t, time_[i], time_[j]);
  const double v = (at - time_[i]) / h;
  const double u = 1 - v;
  const Vec3& p = value_[i];
  const Vec3& q = value_[j];
  const Vec3& m = bend_[i].first;
  const Vec3& n = bend_[i].second;
  VectorMotion r;
  r.value = u * p + v * q + h * h / 6 * ((u * u * u - u) * m + (v * v * v - v) * n);
  r.rate = (q - p) / h + h / 6 * ((1 - 3 * u * u) * m + (3 * v * v - 1) * n);
  if (at == t) r.second = u * m + v * n;
  r.value += (t - at) * r.rate;
  return r;
}

// The rate is a parabola in each interval and its square a quartic, for which Gauss's rule with three points
// is exact; the second derivative is linear.
RowCurve::Activity RowCurve::activity() const {
  Activity out;
  if (time_.size() < 2) return out;
  const Vec3 mean = (value_.back() - value_.front()) / (time_.back() - time_.front());
  using Rule = GaussPoints<3>;
  Vec3 slope_before = Vec3::Zero();
  for (size_t i = 0; i + 1 < time_.size(); ++i) {
    const double h = time_[i + 1] - time_[i];
    const auto& [m, n] = bend_[i];
    const Vec3 chord = (value_[i + 1] - value_[i]) / h;
    const auto rate = [&](double v) -> Vec3 {
      return chord + h / 6 * ((1 - 3 * (1 - v) * (1 - v)) * m + (3 * v * v - 1) * n);
    };
    for (int g = 0; g < 3; ++g) out.rate += h * Rule::weight[g] * (rate(Rule::unit[g]) - mean).squaredNorm();
    out.second += h / 3 * (m.squaredNorm() + m.dot(n) + n.squaredNorm());
    if (i > 0) out.second += (rate(0) - slope_before).squaredNorm() / (0.5 * (h + time_[i] - time_[i - 1]));
    slope_before = rate(1);
  }
  return out;
}

std::vector<RowCurve::Overshoot> RowCurve::overshoots(double fraction) const {
  std::vector<Overshoot> out;
  Vec3 lowest = Vec3::Constant(HUGE_VAL);
  Vec3 highest = -lowest;
  for (const Vec3& x : value_) {
    lowest = lowest.cwiseMin(x);
    highest = highest.cwiseMax(x);
  }
  for (size_t i = 0; i + 1 < time_.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double h = time_[i + 1] - time_[i];
      const double p = value_[i][c];
      const double q = value_[i + 1][c];
      const double m = bend_[i].first[c];
      const double n = bend_[i].second[c];
      // Roots 0 < v < 1 of the slope a v² + b v + d.
      const double a = 0.5 * h * (n - m);
      const double b = h * m;
      const double d = (q - p) / h - h / 6 * (2 * m + n);
      const double root = b * b - 4 * a * d;
      if (root < 0) continue;
      const double k = -0.5 * (b + std::copysign(std::sqrt(root), b));
      Overshoot furthest;
      for (const double v : {a != 0 ? k / a : -1, k != 0 ? d / k : -1}) {
        if (!(v > 0 && v < 1)) continue;
        const double t = time_[i] + v * h;
        const double x = at(t).value[c];
        const double excess = std::max(std::min(p, q) - x, x - std::max(p, q));
        if (excess > furthest.excess) furthest = {i, c, t, x, excess};
      }
      if (furthest.excess > fraction * (highest[c] - lowest[c])) out.push_back(furthest);
    }
  return out;
}

namespace {

VectorMotion sine(const Vec3& amplitude, const Vec3& phase, double frequency, double t) {
  VectorMotion m;
  for (int c = 0; c < 3; ++c) {
    const double angle = frequency * t + phase[c];
    m.value[c] = amplitude[c] * std::sin(angle);
    m.rate[c] = amplitude[c] * frequency * std::cos(angle);
    m.second[c] = -frequency * frequency * m.value[c];
  }
  return m;
}

VectorMotion operator+(const VectorMotion& a, const VectorMotion& b) {
  return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}

VectorMotion times(const Ramp& s, const VectorMotion& m) {
  return {s.value * m.value, s.rate * m.value + s.value * m.rate,
          s.second * m.value + 2 * s.rate * m.rate + s.value * m.second};
}

}  // namespace

void DriftLaw::at(double t, VectorMotion& moved, VectorMotion& turned) const {
  const Ramp s = quintic_ramp(t, ramp);
  const double f = 2 * std::numbers::pi / harmonic.period;
  const Vec3 zero = Vec3::Zero();
  moved = times(s, VectorMotion{offset, zero, zero} + sine(harmonic.amplitude, harmonic.phase, f, t) +
                       table.offset.at(t));
  turned =
      times(s, VectorMotion{rotation, zero, zero} +
                   sine(harmonic.rotation_amplitude, harmonic.rotation_phase, f, t) + table.rotation.at(t));
}

RigidMotion::RigidMotion(const Vec3& position, const Vec3& rotation, MotionLaw law, double ramp)
    : position_(position), rotation_(exp_so3(rotation).normalized()), law_(std::move(law)), ramp_(ramp) {
  if (!(ramp >= 0)) throw std::invalid_argument("the ramp of a motion must not be negative");
  if (auto* steady = std::get_if<SteadyLaw>(&law_)) {
    const double length = steady->axis.norm();
    if (steady->rate != 0 && !(length > 0))
      throw std::invalid_argument("the axis of a rotation must not be zero");
    if (length > 0) steady->axis /= length;
  }
  if (const auto* harmonic = std::get_if<HarmonicLaw>(&law_))
    if (!(harmonic->period > 0)) throw std::invalid_argument("the period of a motion must be positive");
}

void RigidMotion::set_drift(DriftLaw drift) {
  if (!(drift.ramp >= 0)) throw std::invalid_argument("the ramp of a drift must not be negative");
  if (!(drift.harmonic.period > 0)) throw std::invalid_argument("the period of a drift must be positive");
  drift_ = std::make_shared<const DriftLaw>(std::move(drift));
}

namespace {

// `pose` about `origin`, moved with a frame with the displacement `moved` and the rotation `turned` about it.
void move_with_frame(const Vec3& origin, const VectorMotion& moved, const VectorMotion& turned, bool rests,
                     RigidPose& pose) {
  const Quat D = exp_so3(turned.value);
  const Vec3 r = D * (pose.position - origin);
  pose.position = origin + moved.value + r;
  pose.rotation = (D * pose.rotation).normalized();
  if (rests) return;
  Vec3 spin, faster;
  angular_rates(turned, spin, faster);
  const Vec3 v = D * pose.velocity;
  const Vec3 w = D * pose.angular_velocity;
  pose.velocity = moved.rate + spin.cross(r) + v;
  pose.acceleration =
      moved.second + faster.cross(r) + spin.cross(spin.cross(r)) + 2 * spin.cross(v) + D * pose.acceleration;
  pose.angular_acceleration = faster + spin.cross(w) + D * pose.angular_acceleration;
  pose.angular_velocity = spin + w;
}

}  // namespace

RigidPose RigidMotion::at(double t) const {
  RigidPose pose{position_, rotation_, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  if (!moves()) return pose;
  const bool rests = t < 0;
  t = std::max(t, 0.0);
  const Ramp s = quintic_ramp(t, ramp_);
  VectorMotion offset, psi;
  if (const auto* steady = std::get_if<SteadyLaw>(&law_)) {
    const Vec3 turn = steady->rate * steady->axis;
    offset = {s.integral * steady->velocity, s.value * steady->velocity, s.rate * steady->velocity};
    psi = {s.integral * turn, s.value * turn, s.rate * turn};
  } else if (const auto* harmonic = std::get_if<HarmonicLaw>(&law_)) {
    const double f = 2 * std::numbers::pi / harmonic->period;
    offset = times(s, sine(harmonic->amplitude, harmonic->phase, f, t));
    psi = times(s, sine(harmonic->rotation_amplitude, harmonic->rotation_phase, f, t));
  } else if (const auto* table = std::get_if<TableLaw>(&law_)) {
    offset = times(s, table->offset.at(t));
    psi = times(s, table->rotation.at(t));
  }
  pose.position = position_ + offset.value;
  pose.rotation = (exp_so3(psi.value) * rotation_).normalized();
  if (!rests) {
    pose.velocity = offset.rate;
    pose.acceleration = offset.second;
    angular_rates(psi, pose.angular_velocity, pose.angular_acceleration);
  }
  if (!drift_) return pose;
  VectorMotion moved, turned;
  drift_->at(t, moved, turned);
  move_with_frame(position_, moved, turned, rests, pose);
  return pose;
}

}  // namespace hawser
