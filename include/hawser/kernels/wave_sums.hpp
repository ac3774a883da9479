// Sums over the components of a sea (linear waves, docs/theory/waves.md), in arrays for vectorisation: a sea
// has hundreds of components, and every node evaluates them in every step.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct WaveComponent {
  double amplitude = 0;  // m
  double omega = 0;      // rad/s
  double number = 0;     // 1/m
  double x = 1, y = 0;   // unit direction in which it goes
  double phase = 0;      // rad: elevation = a cos(k·x - omega t + phase)
};

class WaveSums {
 public:
  WaveSums() = default;
  // Sets the wave numbers. depth: m; <= 0: infinite.
  WaveSums(std::vector<WaveComponent> components, double depth);

  // Number of leading components, sorted by wave number, that are significant at the height z [m] from the
  // still water: the contribution of all others is less than kNegligible times the sum of the magnitudes of
  // all components' velocities, or accelerations, at the mean water level.
  static constexpr double kNegligible = 1e-4;
  std::size_t significant_components(double z) const;
  std::size_t size() const { return number_.size(); }
  // Sum of the amplitudes of all components after the first n, m.
  double height_beyond(std::size_t n) const { return height_beyond_[n]; }

  // Phases of the leading components at a point and time.
  struct Phases {
    std::vector<double> sine, cosine;
    double surface = 0;  // m above the still water
  };
  void phases(double x, double y, double t, std::size_t components, Phases& out) const;
  // Adds velocity [m/s] and its time derivative [m/s²] at the height z [m] from the still water, from the
  // components that are significant there and have phases.
  void add_motion(const Phases& at, double z, Vec3& velocity, Vec3& acceleration) const;
  // Wave pressure over rho g [m] at the height z [m] from the still water, from the same components.
  double head(const Phases& at, double z) const;

 private:
  // Number of components with a wave number up to `largest_number`, in full vectors.
  std::size_t up_to(double largest_number) const;
  // Number of leading components that depend on the depth at the height z.
  std::size_t components_over_bed(double z) const;

  // By increasing wave number, padded to full vectors with zero amplitudes.
  std::vector<double> number_, omega_, amplitude_;
  std::vector<double> along_x_, along_y_, per_time_, phase_;  // of the phase, in quarter turns
  std::vector<double> x_, y_;                                 // direction
  std::vector<double> speed_;                                 // m/s: a omega/(1 - exp(-2 k h))
  std::vector<double> head_;                                  // m: a/(1 + exp(-2 k h))
  std::vector<double> bottom_;                                // exp(-2 k h)
  std::vector<double> height_beyond_ = {0};  // m, sum of the amplitudes from each component on; then 0
  double depth_ = 0;                         // m; <= 0: infinite
};

}  // namespace hawser
