// Coefficients of Fenton's fifth-order theory, solution of its dispersion relation with a current, limits of
// validity, surface elevation and water motion.
#include "hawser/kernels/stokes_wave.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/AutoDiff>

namespace hawser {
namespace {

// Below this depth, in 1/k, the motion is zero to round-off.
constexpr double kDeep = 20;

using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;

// Coefficients of Table 1 of Fenton (1985) in the dispersion relation. S = sech 2kd.
template <class T>
struct Dispersion {
  T C0, C2, C4, D2, D4;
  explicit Dispersion(const T& kd) {
    using std::cosh, std::tanh, std::sqrt;
    const T S = 1.0 / cosh(T(2.0 * kd));
    const T C = 1.0 - S;
    const T t = tanh(kd);
    const T S2 = S * S;
    const T S3 = S2 * S;
    const T S4 = S2 * S2;
    const T S5 = S4 * S;
    const T C_2 = C * C;
    const T C_3 = C_2 * C;
    C0 = sqrt(t);
    C2 = C0 * (2.0 + 7.0 * S2) / (4.0 * C_2);
    C4 = C0 * (4.0 + 32.0 * S - 116.0 * S2 - 400.0 * S3 - 71.0 * S4 + 146.0 * S5) / (32.0 * C_2 * C_3);
    D2 = -0.5 / C0;
    D4 = (2.0 + 4.0 * S + S2 + 2.0 * S3) / (8.0 * C_3 * C0);
  }
};

// Eqs 21 (Eulerian mean velocity known) and 24 (Stokes' known), zero at the wave number.
template <class T>
T dispersion(const StokesInput& input, const T& k) {
  using std::sqrt;
  const bool deep = !(input.depth > 0);
  T kd = deep ? T(kDeep + 0.0 * k) : T(k * input.depth);
  const T all = kd;
  if (kd > kDeep) kd = T(kDeep + 0.0 * k);
  const Dispersion<T> f(kd);
  const T e = 0.5 * input.height * k;
  const T e2 = e * e;
  T C2 = f.C2;
  T C4 = f.C4;
  if (input.transport && !deep) {
    C2 = C2 + f.D2 / all;
    C4 = C4 + f.D4 / all;
  }
  return sqrt(T(k / input.gravity)) * input.current - 2 * M_PI / input.period / sqrt(T(k * input.gravity)) +
         f.C0 + e2 * C2 + e2 * e2 * C4;
}

double solve(const StokesInput& input) {
  const double omega = 2 * M_PI / input.period;
  double k = wave_number(omega, input.depth, input.gravity);
  // First small waves on the current, because the wave number of still water may be far off.
  for (const double height : {0.0, input.height}) {
    StokesInput now = input;
    now.height = height;
    bool converged = false;
    for (int i = 0; i < 60 && !converged; ++i) {
      const Dual f = dispersion(now, Dual(k, Eigen::Matrix<double, 1, 1>(1.0)));
      const double slope = f.derivatives()[0];
      const double step = std::clamp(-f.value() / slope, -0.5 * k, k);
      k += step;
      converged = std::abs(step) <= 4e-16 * k || f.value() == 0;
      if (i > 40) converged |= std::abs(step) <= 1e-13 * k;
      if (!(slope > 0) || !std::isfinite(k)) break;  // no wave can run against this current
    }
    if (!converged)
      throw std::invalid_argument("no wave of this height and period can run against a current of " +
                                  std::to_string(input.current) + " m/s");
  }
  return k;
}

// Remaining coefficients of Table 1, for surface and potential.
struct Shape {
  double A11, A22, A31, A33, A42, A44, A51, A53, A55;
  double B22, B31, B42, B44, B53, B55, E2, E4;
  explicit Shape(double kd) {
    const double S = 1 / std::cosh(2 * kd);
    const double C = 1 - S;
    const double sinh = std::sinh(kd);
    const double tanh = std::tanh(kd);
    const double S2 = S * S;
    const double S3 = S2 * S;
    const double S4 = S3 * S;
    const double S5 = S4 * S;
    const double S6 = S5 * S;
    const double S7 = S6 * S;
    const double S8 = S7 * S;
    const double C_2 = C * C;
    const double C_3 = C_2 * C;
    const double C_4 = C_3 * C;
    const double C_5 = C_4 * C;
    const double C_6 = C_5 * C;
    const double p = 3 + 2 * S;
    const double q = 4 + S;
    A11 = 1 / sinh;
    A22 = 3 * S2 / (2 * C_2);
    A31 = (-4 - 20 * S + 10 * S2 - 13 * S3) / (8 * sinh * C_3);
    A33 = (-2 * S2 + 11 * S3) / (8 * sinh * C_3);
    A42 = (12 * S - 14 * S2 - 264 * S3 - 45 * S4 - 13 * S5) / (24 * C_5);
    A44 = (10 * S3 - 174 * S4 + 291 * S5 + 278 * S6) / (48 * p * C_5);
    A51 = (-1184 + 32 * S + 13232 * S2 + 21712 * S3 + 20940 * S4 + 12554 * S5 - 500 * S6 - 3341 * S7 -
           670 * S8) /
          (64 * sinh * p * q * C_6);
    A53 = (4 * S + 105 * S2 + 198 * S3 - 1376 * S4 - 1302 * S5 - 117 * S6 + 58 * S7) / (32 * sinh * p * C_6);
    A55 = (-6 * S3 + 272 * S4 - 1552 * S5 + 852 * S6 + 2029 * S7 + 430 * S8) / (64 * sinh * p * q * C_6);
    B22 = (1 + 2 * S) / (2 * C * tanh);
    B31 = -3 * (1 + 3 * S + 3 * S2 + 2 * S3) / (8 * C_3);
    B42 = (6 - 26 * S - 182 * S2 - 204 * S3 - 25 * S4 + 26 * S5) / (6 * p * C_4 * tanh);
    B44 = (24 + 92 * S + 122 * S2 + 66 * S3 + 67 * S4 + 34 * S5) / (24 * p * C_4 * tanh);
    B53 = 9 * (132 + 17 * S - 2216 * S2 - 5897 * S3 - 6292 * S4 - 2687 * S5 + 194 * S6 + 467 * S7 + 82 * S8) /
          (128 * p * q * C_6);
    B55 = 5 *
          (300 + 1579 * S + 3176 * S2 + 2949 * S3 + 1188 * S4 + 675 * S5 + 1326 * S6 + 827 * S7 + 130 * S8) /
          (384 * p * q * C_6);
    E2 = tanh * (2 + 2 * S + 5 * S2) / (4 * C_2);
    E4 = tanh * (8 + 12 * S - 152 * S2 - 308 * S3 - 42 * S4 + 77 * S5) / (32 * C_5);
  }
};

}  // namespace

StokesWave::StokesWave(const StokesInput& input) : input_(input) {
  if (!(input.height > 0) || !(input.period > 0) || !(input.gravity > 0))
    throw std::invalid_argument("a wave needs a height, a period and gravity above 0");
  k_ = solve(input);
  omega_ = 2 * M_PI / input.period;
  const bool deep = !(input.depth > 0) || k_ * input.depth > kDeep;
  const double kd = deep ? kDeep : k_ * input.depth;
  depth_ = kd / k_;
  const double highest = highest_wave(length(), input.depth);
  if (input.height > highest)
    throw std::invalid_argument("a wave of " + std::to_string(length()) + " m length breaks at a height of " +
                                std::to_string(highest) + " m");
  constexpr double kLongest = 100;
  if (!deep && ursell() > kLongest)
    throw std::invalid_argument("the wave is too long for its depth: its Ursell number is " +
                                std::to_string(ursell()) + ", and Stokes' theory is valid up to 40");
  const Dispersion<double> f(kd);
  const Shape s(kd);
  const double e = 0.5 * k_ * input.height;
  const double e2 = e * e;
  const double e3 = e2 * e;
  const double e4 = e3 * e;
  const double e5 = e4 * e;
  const double speed = std::sqrt(input.gravity / k_);
  drift_ = omega_ / k_ - speed * (f.C0 + e2 * f.C2 + e4 * f.C4);
  head_ = input.gravity / k_ * (0.5 * f.C0 * f.C0 + kd + e2 * s.E2 + e4 * s.E4);
  surface_ = {0,
              (e + e3 * s.B31 - e5 * (s.B53 + s.B55)) / k_,
              (e2 * s.B22 + e4 * s.B42) / k_,
              (-e3 * s.B31 + e5 * s.B53) / k_,
              e4 * s.B44 / k_,
              e5 * s.B55 / k_};
  const double u = f.C0 * speed;
  potential_ = {0,
                u * (e * s.A11 + e3 * s.A31 + e5 * s.A51),
                2 * u * (e2 * s.A22 + e4 * s.A42),
                3 * u * (e3 * s.A33 + e5 * s.A53),
                4 * u * e4 * s.A44,
                5 * u * e5 * s.A55};
  cos_ = std::cos(input.direction);
  sin_ = std::sin(input.direction);
}

double StokesWave::length() const { return 2 * M_PI / k_; }

double StokesWave::ursell() const {
  if (!(input_.depth > 0)) return 0;
  return input_.height * length() * length() / (input_.depth * input_.depth * input_.depth);
}

WaveComponent StokesWave::component() const {
  return {input_.height / 2, omega_, k_, cos_, sin_, input_.phase};
}

double StokesWave::angle(double x, double y, double t) const {
  return k_ * (cos_ * x + sin_ * y) - omega_ * t + input_.phase;
}

double StokesWave::at_phase(double theta) const {
  double sum = 0;
  for (size_t j = 1; j <= 5; ++j) sum += surface_[j] * std::cos(static_cast<double>(j) * theta);
  return sum;
}

// theta: phase; y: height above the bed; w_x = u_z, w_z = -u_x.
StokesWave::Flow StokesWave::flow(double theta, double y) const {
  Flow f;
  f.u = drift_;
  for (size_t j = 1; j <= 5; ++j) {
    const double n = static_cast<double>(j);
    const double c = std::cos(n * theta);
    const double s = std::sin(n * theta);
    const double across = potential_[j] * std::cosh(n * k_ * y);
    const double up = potential_[j] * std::sinh(n * k_ * y);
    f.u += across * c;
    f.w += up * s;
    f.ux -= n * k_ * across * s;
    f.uz += n * k_ * up * c;
    f.ut += n * omega_ * across * s;
    f.wt -= n * omega_ * up * c;
  }
  return f;
}

// Height above the bed; in deep water above a depth without motion.
double StokesWave::over_bed(double z, double surface) const {
  return std::max(0.0, std::min(z, surface) + depth_);
}

WaveMotion StokesWave::at(const Vec3& x, double t, double factor, double rate) const {
  const double theta = angle(x.x(), x.y(), t);
  WaveMotion m;
  m.surface = factor * at_phase(theta);
  const Flow f = flow(theta, over_bed(x.z(), m.surface));
  const double convected = f.u * f.ux + f.w * f.uz;
  const double lifted = f.u * f.uz - f.w * f.ux;
  const auto vector = [this](double along, double z) { return Vec3(cos_ * along, sin_ * along, z); };
  m.velocity = factor * vector(f.u, f.w);
  m.acceleration =
      factor * vector(f.ut, f.wt) + rate * vector(f.u, f.w) + factor * factor * vector(convected, lifted);
  return m;
}

double StokesWave::head_at(const Vec3& x, double t, double factor) const {
  const double theta = angle(x.x(), x.y(), t);
  const Flow f = flow(theta, over_bed(x.z(), factor * at_phase(theta)));
  const double along = f.u - omega_ / k_;
  return factor * ((head_ - 0.5 * (along * along + f.w * f.w)) / input_.gravity - depth_);
}

double highest_wave(double length, double depth) {
  if (!(depth > 0)) return 0.141063 * length;
  const double r = length / depth;
  return depth * r * (0.141063 + r * (0.0095721 + r * 0.0077829)) /
         (1 + r * (0.0788340 + r * (0.0317567 + r * 0.0093407)));
}

}  // namespace hawser
