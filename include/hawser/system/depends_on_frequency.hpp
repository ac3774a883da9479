// Role of force terms whose mass and damping in harmonic motion depend on its frequency.
#pragma once

namespace hawser {

class DependsOnFrequency {
 public:
  virtual ~DependsOnFrequency() = default;
  // Sets the derivatives by acceleration and velocity at rest to those of a harmonic motion with omega
  // [rad/s]; 0, the initial value: those of time integration.
  virtual void oscillate(double omega) = 0;
};

}  // namespace hawser
