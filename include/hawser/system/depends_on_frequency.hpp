// Role of force terms whose mass, damping and excitation in harmonic motion depend on its frequency.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hawser/kernels/platform_waves.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser {

class DependsOnFrequency {
 public:
  // Forces on a body, Re(F exp(i omega t)), on its unknowns: N, N m.
  struct Excitation {
    int block = 0;  // first of the two local blocks of an owned body
    std::vector<ComplexVec6> by_wave;
  };

  virtual ~DependsOnFrequency() = default;
  // Sets the derivatives by acceleration and velocity at rest to those of a harmonic motion with omega
  // [rad/s]; nothing, the initial value: those of time integration.
  virtual void set_frequency(std::optional<double> omega) = 0;
  // Linear forces of each of the waves on bodies in a state at rest, on the ranks that own them.
  virtual std::vector<Excitation> excitation(const std::vector<WaveComponent>& waves,
                                             const Kinematics& state) const = 0;
};

}  // namespace hawser
