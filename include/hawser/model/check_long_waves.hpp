// Checks of wave forces against their limits in long waves.
#pragma once

#include <optional>

#include "hawser/model/check.hpp"

namespace hawser::model {

// Refuses phases of another convention, and a heave force of another scale than the hydrostatic stiffness.
// The body must have wave forces.
void check_long_waves(const Case& c, const Body& b, const Issues& issue);

// A quantity by the wave forces, and by the files or the case.
struct LongWaveDifference {
  enum class Quantity { heave_stiffness, volume, turning_stiffness };
  Quantity quantity = Quantity::heave_stiffness;
  int freedom = 2;                 // of the force or moment of the waves, from 0
  double by_waves = 0, given = 0;  // N/m, m³ or N m
  // Of a turning stiffness: given - by_waves over the contribution of the body's weight, -m g z; 0: this
  // contribution is negligible.
  double weight_contributions = 0;
};
// The first of heave stiffness, displaced volume and turning stiffness (roll or pitch) that differs by more
// than the accuracy of the limits; none: all agree, or the limits do not apply. The body must have wave
// forces.
std::optional<LongWaveDifference> long_wave_difference(const Case& c, const Body& b);

}  // namespace hawser::model
