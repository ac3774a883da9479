// Water waves of small height as sums of components: a regular wave has one, an irregular sea many. Linear
// theory (Airy), extended to the moving surface by a stretching. Alternatively one wave of finite height
// (stokes_wave.hpp). See docs/theory/waves.md.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hawser/kernels/wave_sums.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

class StokesWave;

// Wave number k of omega² = g k tanh(k h), 1/m, to round-off; depth <= 0: infinite.
double wave_number(double omega, double depth, double gravity);

// none: no motion above the still water, no change below; vertical: above the still water the motion at it;
// wheeler: the profile from bed to still water is stretched to the surface (Wheeler 1970).
enum class Stretching { none, vertical, wheeler };

struct WaveMotion {
  double surface = 0;                // m above the still water
  Vec3 velocity = Vec3::Zero();      // m/s
  Vec3 acceleration = Vec3::Zero();  // m/s², of the velocity at the point (linear) or of the water (Stokes)
};

class WaveField {
 public:
  WaveField() = default;
  // Sets the wave numbers of the components from their frequencies. depth <= 0: infinite.
  WaveField(std::vector<WaveComponent> components, double depth, double gravity, Stretching stretching);
  // components() then contains one linear wave of the same height, for uses that need linear components.
  explicit WaveField(std::shared_ptr<const StokesWave> wave);

  bool none() const { return components_.empty(); }
  const std::vector<WaveComponent>& components() const { return components_; }
  double depth() const { return depth_; }  // m; <= 0: infinite
  // z: from the still water. factor, rate: of a ramp, and its derivative, 1/s.
  WaveMotion at(const Vec3& x, double t, double factor = 1, double rate = 0) const;
  // Wave pressure over rho g [m]; above the surface it is the elevation. Without stretching the pressure
  // above the still water is that at the still water.
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

// Spectrum by rows of increasing frequency, linear between them, zero beyond.
struct SpectrumRow {
  double omega = 0, density = 0;  // rad/s, m² s/rad
};

// `count` components with the energy of frequency bins from 0.35 to 10 times the peak frequency. For a
// spreading cos^(2s)((theta - direction)/2) with s > 0 each has its own direction, such that the energy by
// direction is that of the spreading. Phases, positions in the bins and directions follow from `seed`, equal
// on all machines and ranks.
std::vector<WaveComponent> irregular(const Jonswap& spectrum, double direction, int count, std::uint64_t seed,
                                     double spreading = 0);
// The same from rows: bins that grow geometrically from the first row to the last, or from 1/50 of the last
// if the first is lower; bins without energy are excluded.
std::vector<WaveComponent> irregular(const std::vector<SpectrumRow>& rows, double direction, int count,
                                     std::uint64_t seed, double spreading = 0);

}  // namespace hawser
