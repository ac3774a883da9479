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

  // Of all components at a place and a time.
  struct Phases {
    std::vector<double> sine, cosine;
    double surface = 0;  // m above the still water
  };
  void phases(double x, double y, double t, Phases& out) const;
  // Adds velocity [m/s] and its derivative in time [m/s²] at the height z [m] from the still water.
  // Components that are not felt there are left out: what all of these would add is less than kLeftOut times
  // the sum of the sizes that velocities, or accelerations, of the components have in the mean water level.
  static constexpr double kLeftOut = 1e-6;
  void add_motion(const Phases& at, double z, Vec3& velocity, Vec3& acceleration) const;

 private:
  // By growing wave number, to whole vectors: what is added has no amplitude.
  std::vector<double> number_, omega_, amplitude_;
  std::vector<double> along_x_, along_y_, per_time_, phase_;  // of the angle, in quarter turns
  std::vector<double> x_, y_;                                 // direction
  std::vector<double> speed_;                                 // m/s: a omega/(1 - exp(-2 k h))
  std::vector<double> bottom_;                                // exp(-2 k h)
  double depth_ = 0;                                          // m; <= 0: infinite
};

}  // namespace hawser
