// Wind over the sea: mean by height, and spatially uniform gusts as a sum of components of a spectrum. See
// docs/theory/wind-and-current.md.
#pragma once

#include <cstdint>
#include <vector>

#include "hawser/kernels/current.hpp"

namespace hawser {

// iso: ISO 19901-1 (the spectrum of the Norwegian Petroleum Directorate); api: API RP 2A-WSD (1993).
enum class GustSpectrum { none, iso, api };

// One-sided spectral density [m²/s] of the speed along the wind at a frequency [Hz]. speed: hourly mean at
// the height [m], m/s; at_ten: that at 10 m above the sea.
double gust_density(GustSpectrum kind, double frequency, double speed, double at_ten, double height);

// Frequency range of gusts, Hz: from the hour of the mean to the end of the spectra.
inline constexpr double kSlowestGust = 1.0 / 3600, kFastestGust = 0.5;

struct Gust {
  double amplitude = 0, omega = 0, phase = 0;  // m/s, rad/s, rad
};
// Components with the energy of their bins, which widen with the frequency; equal for a seed everywhere.
std::vector<Gust> gusts(GustSpectrum kind, double speed, double at_ten, double height, int count,
                        std::uint64_t seed);

struct Wind {
  Vec3 mean = Vec3::Zero();  // m/s, at `height`
  double height = 10;        // m above the still water
  double exponent = 0;       // speed at z: mean times (z/height)^exponent
  double density = 0;        // kg/m³, of the air
  double ramp = 0;           // s, duration of the smooth start; 0: acts from the beginning
  TimeFactor factor;
  std::vector<Gust> gusts;
  double gust_ramp = 0;  // s

  // Factor on the mean: ramp times time factor.
  double strength(double time) const;
  // Mean velocity at a height [m] above the still water, m/s.
  Vec3 steady(double z, double time) const;
  // Gust velocity along the mean, equal everywhere, m/s.
  Vec3 gust(double time) const;
};

}  // namespace hawser
