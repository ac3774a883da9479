// Sums over the components of a sea, as loops over arrays without branches. This file is compiled with
// -ffast-math, which is necessary for reordering of sums and for the vector versions of sin, cos and exp in
// the C library (four units in the last place).
#include "hawser/kernels/wave_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/math/clones.hpp"

namespace hawser {
namespace {

constexpr std::size_t kVector = 8;
// At a depth d the motion is exp(-k d) + exp(-k (2 h - d)) times that at the mean water level without its
// term exp(-2 k h): at most 2 exp(-k d). For k d above this value it is less than kNegligible.
const double kNegligibleExponent = std::log(2 / WaveSums::kNegligible);
// exp(-kNothing) is below rounding.
constexpr double kNothing = 37;

// Sine and cosine of an angle in quarter turns, for which the reduction to an eighth of a turn is exact.
// Taylor series with an error below (pi/4)^15/15! = 2e-14, much less than kNegligible.
struct SineCosine {
  double sine, cosine;
};
inline SineCosine sine_cosine(double quarters) {
  const double whole = std::nearbyint(quarters);
  const double x = M_PI / 2 * (quarters - whole);
  const double y = x * x;
  const int quadrant = static_cast<int>(whole);
  double s = 1, c = 1;
  for (int n = 12; n > 0; n -= 2) {
    s = 1 - s * y / (n * (n + 1));
    c = 1 - c * y / ((n + 1) * (n + 2));
  }
  s *= x;
  c = 1 - 0.5 * y * c;
  const double first = quadrant & 1 ? c : s;
  const double second = quadrant & 1 ? s : c;
  return {quadrant & 2 ? -first : first, (quadrant + 1) & 2 ? -second : second};
}

// Parameters, because the compiler uses __restrict only for those.
double elevation(std::size_t n, const double* phase, const double* per_time, double t, const double* along_x,
                 double x, const double* along_y, double y, const double* amplitude, double* __restrict sine,
                 double* __restrict cosine) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const SineCosine angle = sine_cosine(along_x[i] * x + along_y[i] * y + (phase[i] - per_time[i] * t));
    sine[i] = angle.sine;
    cosine[i] = angle.cosine;
    sum += amplitude[i] * angle.cosine;
  }
  return sum;
}

}  // namespace

WaveSums::WaveSums(std::vector<WaveComponent> components, double depth) : depth_(depth) {
  std::stable_sort(components.begin(), components.end(),
                   [](const WaveComponent& a, const WaveComponent& b) { return a.number < b.number; });
  while (!components.empty() && components.size() % kVector != 0) {
    components.push_back(components.back());
    components.back().amplitude = 0;
  }
  for (const WaveComponent& c : components) {
    const double bottom = depth > 0 ? std::exp(-2 * c.number * depth) : 0;
    constexpr double kQuarters = 2 / M_PI;  // per radian
    number_.push_back(c.number);
    omega_.push_back(c.omega);
    amplitude_.push_back(c.amplitude);
    along_x_.push_back(kQuarters * c.number * c.x);
    along_y_.push_back(kQuarters * c.number * c.y);
    per_time_.push_back(kQuarters * c.omega);
    phase_.push_back(kQuarters * c.phase);
    x_.push_back(c.x);
    y_.push_back(c.y);
    speed_.push_back(c.amplitude * c.omega / (1 - bottom));
    head_.push_back(c.amplitude / (1 + bottom));
    bottom_.push_back(bottom);
  }
  height_beyond_.assign(components.size() + 1, 0);
  for (std::size_t i = components.size(); i-- > 0;)
    height_beyond_[i] = height_beyond_[i + 1] + components[i].amplitude;
}

std::size_t WaveSums::up_to(double largest_number) const {
  const auto end = std::upper_bound(number_.begin(), number_.end(), largest_number);
  return (static_cast<std::size_t>(end - number_.begin()) + kVector - 1) / kVector * kVector;
}

std::size_t WaveSums::components_over_bed(double z) const {
  const double above = std::max(depth_ + z, 0.0);  // above the bed
  return depth_ > 0 ? up_to(kNothing / std::max(2 * above, 1e-9)) : 0;
}

std::size_t WaveSums::significant_components(double z) const {
  return z < 0 ? up_to(kNegligibleExponent / -z) : number_.size();
}

HAWSER_CLONES void WaveSums::phases(double x, double y, double t, std::size_t n, Phases& out) const {
  out.sine.resize(n);
  out.cosine.resize(n);
  out.surface = elevation(n, phase_.data(), per_time_.data(), t, along_x_.data(), x, along_y_.data(), y,
                          amplitude_.data(), out.sine.data(), out.cosine.data());
}

// cosh k(z + h)/sinh kh and sinh k(z + h)/sinh kh without overflow. Both are exp kz in deep water.
HAWSER_CLONES void WaveSums::add_motion(const Phases& at, double z, Vec3& velocity,
                                        Vec3& acceleration) const {
  const std::size_t n = std::min(significant_components(z), at.sine.size());
  const std::size_t shallow = std::min(n, components_over_bed(z));
  const double* sine = at.sine.data();
  const double* cosine = at.cosine.data();
  double ux = 0, uy = 0, uz = 0, ax = 0, ay = 0, az = 0;
  const auto add = [&](std::size_t i, double across, double up) {
    const double forward = across * cosine[i];
    const double growing = omega_[i] * across * sine[i];
    ux += x_[i] * forward;
    uy += y_[i] * forward;
    uz += up * sine[i];
    ax += x_[i] * growing;
    ay += y_[i] * growing;
    az -= omega_[i] * up * cosine[i];
  };
  for (std::size_t i = 0; i < shallow; ++i) {
    // A vector with significant components may also contain waves so short that both are zero.
    const double e = std::exp(number_[i] * z);
    const double back = bottom_[i] / std::max(e, std::numeric_limits<double>::min());
    add(i, speed_[i] * (e + back), speed_[i] * (e - back));
  }
  for (std::size_t i = shallow; i < n; ++i) {
    const double speed = speed_[i] * std::exp(number_[i] * z);
    add(i, speed, speed);
  }
  velocity += Vec3(ux, uy, uz);
  acceleration += Vec3(ax, ay, az);
}

// cosh k(z + h)/cosh kh.
HAWSER_CLONES double WaveSums::head(const Phases& at, double z) const {
  const std::size_t n = std::min(significant_components(z), at.cosine.size());
  const std::size_t shallow = std::min(n, components_over_bed(z));
  const double* cosine = at.cosine.data();
  double sum = 0;
  for (std::size_t i = 0; i < shallow; ++i) {
    const double e = std::exp(number_[i] * z);
    const double back = bottom_[i] / std::max(e, std::numeric_limits<double>::min());
    sum += head_[i] * (e + back) * cosine[i];
  }
  for (std::size_t i = shallow; i < n; ++i) sum += head_[i] * std::exp(number_[i] * z) * cosine[i];
  return sum;
}

}  // namespace hawser
