// The water at any point and time: current and waves, their ramps, the still surface.
#pragma once

#include "hawser/kernels/current.hpp"
#include "hawser/kernels/line_water.hpp"
#include "hawser/kernels/waves.hpp"

namespace hawser {

namespace model {
struct Case;
struct Water;
}  // namespace model

struct Sea {
  double density = 1025, gravity = 9.80665;  // kg/m³, m/s²
  double surface = 0;                        // m, z of the still water
  CurrentProfile current;
  double current_ramp = 0;  // s, smooth start; 0: always there
  TimeFactor current_factor;
  double current_scale = 1;  // of a stage of statics, and from then on
  WaveField waves;
  double wave_ramp = 0;  // s

  bool calm() const { return current.none() && waves.none(); }
  // Without waves, at a height z.
  Water still_at(double z, double time) const;
  // Of the waves alone. A term evaluates them once a step (docs/theory/waves.md#in-a-step).
  WaveMotion waves_at(const Vec3& x, double time) const;
  // Pressure of the waves over rho g, m, at a place of space.
  double wave_head(const Vec3& x, double time) const;
};
// Velocity and acceleration of current and waves together.
Water operator+(Water still, const WaveMotion& wave);

Sea sea_of(const model::Case& c);
CurrentProfile current_profile(const model::Water& w, double factor = 1);

}  // namespace hawser
