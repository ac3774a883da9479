// The sums over the components of a sea (linear waves, docs/theory/waves.md), in arrays that the compiler
// turns into vector instructions: a sea has hundreds of components, and every node asks in every step.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct WaveComponent {
  double amplitude = 0;  // m
  double omega = 0;      // rad/s
  double number = 0;     // 1/m
  double x = 1, y = 0;   // direction it goes to, unit
  double phase = 0;      // rad: elevation = a cos(k·x - omega t + phase)
};

class WaveSums {
 public:
  WaveSums() = default;
  // With their wave numbers. depth <= 0: infinite, m.
  WaveSums(std::vector<WaveComponent> components, double depth);

  // Number of the first components, by wave number, that are significant at the height z [m] from the still
  // water: what all others would add is less than kNegligible times the sum of the sizes that velocities, or
  // accelerations, of the components have in the mean water level.
  static constexpr double kNegligible = 1e-4;
  std::size_t significant_components(double z) const;
  std::size_t size() const { return number_.size(); }
  // Sum of the amplitudes of all components but the first n, m.
  double height_beyond(std::size_t n) const { return height_beyond_[n]; }

  // Of the first components at a place and a time.
  struct Phases {
    std::vector<double> sine, cosine;
    double surface = 0;  // m above the still water
  };
  void phases(double x, double y, double t, std::size_t components, Phases& out) const;
  // Adds velocity [m/s] and its derivative in time [m/s²] at the height z [m] from the still water, of what
  // is significant there and has phases.
  void add_motion(const Phases& at, double z, Vec3& velocity, Vec3& acceleration) const;
  // Pressure of the waves over rho g at the height z [m] from the still water, of the same: m.
  double head(const Phases& at, double z) const;

 private:
  // How many components have a number up to `most`, in whole vectors.
  std::size_t up_to(double most) const;
  // How many of the first depend on the depth at the height z.
  std::size_t components_over_bed(double z) const;

  // By growing wave number, to whole vectors: what is added has no amplitude.
  std::vector<double> number_, omega_, amplitude_;
  std::vector<double> along_x_, along_y_, per_time_, phase_;  // of the angle, in quarter turns
  std::vector<double> x_, y_;                                 // direction
  std::vector<double> speed_;                                 // m/s: a omega/(1 - exp(-2 k h))
  std::vector<double> head_;                                  // m: a/(1 + exp(-2 k h))
  std::vector<double> bottom_;                                // exp(-2 k h)
  std::vector<double> height_beyond_ = {0};                   // m, from each component on; then 0
  double depth_ = 0;                                          // m; <= 0: infinite
};

}  // namespace hawser
