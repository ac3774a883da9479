// Mean wind by height, spectra of gusts and their components.
#include "hawser/kernels/wind.hpp"

#include <cmath>

#include "hawser/kernels/motion.hpp"
#include "hawser/math/random.hpp"

namespace hawser {
namespace {

double iso_density(double frequency, double at_ten, double height) {
  constexpr double n = 0.468;
  const double z = height / 10;
  const double U = at_ten / 10;
  const double f = 172 * frequency * std::pow(z, 2.0 / 3) * std::pow(U, -0.75);
  return 320 * U * U * std::pow(z, 0.45) / std::pow(1 + std::pow(f, n), 5 / (3 * n));
}

double api_density(double frequency, double speed, double height) {
  constexpr double kLayer = 20;  // m, of the surface layer
  const double exponent = height <= kLayer ? -0.125 : -0.275;
  const double deviation = 0.15 * std::pow(height / kLayer, exponent) * speed;
  const double peak = 0.025 * speed / height;
  return deviation * deviation / (peak * std::pow(1 + 1.5 * frequency / peak, 5.0 / 3));
}

}  // namespace

double gust_density(GustSpectrum kind, double frequency, double speed, double at_ten, double height) {
  if (kind == GustSpectrum::none || !(speed > 0)) return 0;
  return kind == GustSpectrum::iso ? iso_density(frequency, at_ten, height)
                                   : api_density(frequency, speed, height);
}

// The energy of a bin by Simpson's rule over the logarithm of the frequency.
std::vector<Gust> gusts(GustSpectrum kind, double speed, double at_ten, double height, int count,
                        std::uint64_t seed) {
  std::vector<Gust> out;
  if (kind == GustSpectrum::none || !(speed > 0)) return out;
  constexpr int kParts = 8;
  const double bin = std::log(kFastestGust / kSlowestGust) / count;
  const double part = bin / kParts;
  const auto density = [&](double log_f) {
    const double f = kSlowestGust * std::exp(log_f);
    return f * gust_density(kind, f, speed, at_ten, height);
  };
  Random random = random_of(seed);
  for (int i = 0; i < count; ++i) {
    const double from = bin * i;
    double energy = 0;
    for (int k = 0; k < kParts; ++k) {
      const double low = from + part * k;
      energy += part / 6 * (density(low) + 4 * density(low + 0.5 * part) + density(low + part));
    }
    Gust g;
    g.amplitude = std::sqrt(2 * energy);
    g.omega = 2 * M_PI * kSlowestGust * std::exp(from + (0.25 + 0.5 * random.next()) * bin);
    g.phase = 2 * M_PI * random.next();
    out.push_back(g);
  }
  return out;
}

double Wind::strength(double time) const {
  const double start = ramp > 0 ? quintic_ramp(time, ramp).value : 1;
  return start * factor.at(time);
}

Vec3 Wind::steady(double z, double time) const {
  return strength(time) * (exponent > 0 ? std::pow(z / height, exponent) : 1) * mean;
}

Vec3 Wind::gust(double time) const {
  if (gusts.empty() || mean.isZero(0)) return Vec3::Zero();
  double sum = 0;
  for (const Gust& g : gusts) sum += g.amplitude * std::cos(g.omega * time + g.phase);
  const double start = gust_ramp > 0 ? quintic_ramp(time, gust_ramp).value : 1;
  return start * strength(time) * sum * mean.normalized();
}

}  // namespace hawser
