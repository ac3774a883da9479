// Wind over the sea: its mean by height, and gusts as a sum of components of a spectrum, the same everywhere.
// See docs/theory/wind-and-current.md.
#pragma once

#include <cstdint>
#include <vector>

#include "hawser/kernels/current.hpp"

namespace hawser {

// iso: ISO 19901-1 (the spectrum of the Norwegian Petroleum Directorate); api: API RP 2A-WSD (1993).
enum class GustSpectrum { none, iso, api };

// m²/s, one-sided, of the speed along the wind at a frequency [Hz]. speed [m/s]: the mean of an hour at the
// height [m]; at_ten: that 10 m above the sea.
double gust_density(GustSpectrum kind, double frequency, double speed, double at_ten, double height);

// The frequencies that gusts are made of, Hz: from the hour of the mean to where the spectra end.
inline constexpr double kSlowestGust = 1.0 / 3600, kFastestGust = 0.5;

struct Gust {
  double amplitude = 0, omega = 0, phase = 0;  // m/s, rad/s, rad
};
// Components with the energy of their bins, which grow with the frequency; the same for a seed on any
// machine.
std::vector<Gust> gusts(GustSpectrum kind, double speed, double at_ten, double height, int count,
                        std::uint64_t seed);

struct Wind {
  Vec3 mean = Vec3::Zero();  // m/s, at `height`
  double height = 10;        // m above the still water
  double exponent = 0;       // speed at z: times (z/height)^exponent
  double density = 0;        // kg/m³, of the air
  double ramp = 0;           // s, smooth start; 0: always there
  TimeFactor factor;
  std::vector<Gust> gusts;
  double gust_ramp = 0;  // s

  // Of the mean: its ramp times its factor.
  double strength(double time) const;
  // m/s, at a height [m] above the still water.
  Vec3 steady(double z, double time) const;
  // Along the mean, the same at all places.
  Vec3 gust(double time) const;
};

}  // namespace hawser
