// A role of force terms: their mass and damping in a harmonic motion are those of its frequency.
#pragma once

namespace hawser {

class DependsOnFrequency {
 public:
  virtual ~DependsOnFrequency() = default;
  // The derivatives by acceleration and velocity at rest become those of a harmonic motion of omega [rad/s];
  // 0: those of time integration, as at first.
  virtual void oscillate(double omega) = 0;
};

}  // namespace hawser
