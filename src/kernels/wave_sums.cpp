// Loops over arrays without branches. This file is compiled with -ffast-math, without which neither are sums
// put in another order nor are sin, cos and exp those of the C library for vectors (four units in the last
// place).
#include "hawser/kernels/wave_sums.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/math/clones.hpp"

namespace hawser {
namespace {

constexpr std::size_t kVector = 8;
// exp of it is below the rounding of what is on the surface: components that short are not felt at a depth.
constexpr double kUnfelt = 37;

// Parameters, since the compiler believes __restrict only of those.
double elevation(std::size_t n, const double* phase, const double* omega, double t, const double* along_x,
                 double x, const double* along_y, double y, const double* amplitude, double* __restrict angle,
                 double* __restrict cosine) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    angle[i] = along_x[i] * x + along_y[i] * y + (phase[i] - omega[i] * t);
    cosine[i] = std::cos(angle[i]);
    sum += amplitude[i] * cosine[i];
  }
  return sum;
}

}  // namespace

WaveSums::WaveSums(std::vector<WaveComponent> components, double depth) {
  std::stable_sort(components.begin(), components.end(),
                   [](const WaveComponent& a, const WaveComponent& b) { return a.number < b.number; });
  while (!components.empty() && components.size() % kVector != 0) {
    components.push_back(components.back());
    components.back().amplitude = 0;
  }
  for (const WaveComponent& c : components) {
    const double bottom = depth > 0 ? std::exp(-2 * c.number * depth) : 0;
    number_.push_back(c.number), along_x_.push_back(c.number * c.x), along_y_.push_back(c.number * c.y);
    omega_.push_back(c.omega), phase_.push_back(c.phase), amplitude_.push_back(c.amplitude);
    x_.push_back(c.x), y_.push_back(c.y);
    speed_.push_back(c.amplitude * c.omega / (1 - bottom)), bottom_.push_back(bottom);
  }
}

HAWSER_CLONES WaveSums::Phases WaveSums::phases(double x, double y, double t) const {
  const std::size_t n = number_.size();
  Phases out;
  out.angle.resize(n), out.cosine.resize(n);
  out.surface = elevation(n, phase_.data(), omega_.data(), t, along_x_.data(), x, along_y_.data(), y,
                          amplitude_.data(), out.angle.data(), out.cosine.data());
  return out;
}

// cosh k(z + h)/sinh kh and sinh k(z + h)/sinh kh without overflow.
HAWSER_CLONES void WaveSums::add_motion(const Phases& at, double z, Vec3& velocity,
                                        Vec3& acceleration) const {
  std::size_t n = number_.size();
  if (z < 0) {
    const auto end = std::upper_bound(number_.begin(), number_.end(), kUnfelt / -z);
    n = std::min(n, (static_cast<std::size_t>(end - number_.begin()) + kVector - 1) / kVector * kVector);
  }
  const double *angle = at.angle.data(), *cosine = at.cosine.data();
  double ux = 0, uy = 0, uz = 0, ax = 0, ay = 0, az = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double e = std::exp(number_[i] * z), back = bottom_[i] / e;
    const double across = speed_[i] * (e + back), up = speed_[i] * (e - back), sine = std::sin(angle[i]);
    const double forward = across * cosine[i], growing = omega_[i] * across * sine;
    ux += x_[i] * forward, uy += y_[i] * forward, uz += up * sine;
    ax += x_[i] * growing, ay += y_[i] * growing, az -= omega_[i] * up * cosine[i];
  }
  velocity += Vec3(ux, uy, uz);
  acceleration += Vec3(ax, ay, az);
}

}  // namespace hawser
