// Water waves of small height as sums of components: a regular wave is one, an irregular sea many. Linear
// theory (Airy); up to the moving surface by one of the known stretchings. Or one wave of finite height
// (stokes_wave.hpp). See docs/theory/waves.md.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hawser/kernels/wave_sums.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

class StokesWave;

// k of omega² = g k tanh(k h), 1/m; depth <= 0: infinite. To round-off.
double wave_number(double omega, double depth, double gravity);

// none: nothing above the still water, as it is below; vertical: above it what is at it; wheeler: the profile
// from bed to still water is stretched to the surface (Wheeler 1970).
enum class Stretching { none, vertical, wheeler };

struct WaveMotion {
  double surface = 0;                // m above the still water
  Vec3 velocity = Vec3::Zero();      // m/s
  Vec3 acceleration = Vec3::Zero();  // m/s², of the velocity at the place (linear) or of the water (Stokes)
};

class WaveField {
 public:
  WaveField() = default;
  // Numbers of the components are set from their frequencies. depth <= 0: infinite.
  WaveField(std::vector<WaveComponent> components, double depth, double gravity, Stretching stretching);
  // components() is then one, of half its height, for what answers to linear waves.
  explicit WaveField(std::shared_ptr<const StokesWave> wave);

  bool none() const { return components_.empty(); }
  const std::vector<WaveComponent>& components() const { return components_; }
  // z from the still water. `factor`, `rate`: of a ramp, and its derivative, 1/s.
  WaveMotion at(const Vec3& x, double t, double factor = 1, double rate = 0) const;
  // Pressure of the waves over rho g [m]; above the surface it is that of the surface, its elevation. Without
  // stretching the pressure above the still water is that in it.
  double head(const Vec3& x, double t, double factor = 1) const;

 private:
  std::size_t components_summed(double z) const;
  double stretched(double z, double surface) const;
  std::vector<WaveComponent> components_;
  WaveSums sums_;
  double depth_ = 0;
  Stretching stretching_ = Stretching::wheeler;
  std::shared_ptr<const StokesWave> stokes_;
};

// JONSWAP after Hasselmann et al. (1973), sigma 0.07 and 0.09, scaled so that the spectrum's m0 is Hs²/16;
// gamma = 1: Pierson-Moskowitz.
struct Jonswap {
  double height = 0, peak_period = 0, gamma = 3.3;  // Hs m, Tp s
};

// A spectrum by rows of growing frequency, straight lines between them, nothing beyond.
struct SpectrumRow {
  double omega = 0, density = 0;  // rad/s, m² s/rad
};

// `count` components with the energy of bins of frequency, from 0.35 to 10 times that of the peak; for a
// spreading cos^(2s)((theta - direction)/2) with s > 0 each has a direction of its own, such that the energy
// by direction is that of the spreading. Phases, places in the bins and directions from `seed`, the same on
// every machine and rank.
std::vector<WaveComponent> irregular(const Jonswap& spectrum, double direction, int count, std::uint64_t seed,
                                     double spreading = 0);
// The same from rows: bins that grow geometrically from the first row to the last, or from 1/50 of the last
// where the first is lower; those without energy are excluded.
std::vector<WaveComponent> irregular(const std::vector<SpectrumRow>& rows, double direction, int count,
                                     std::uint64_t seed, double spreading = 0);

}  // namespace hawser
