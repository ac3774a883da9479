// Water motion at any point and time: current and waves, their ramps, the still surface.
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
  double current_ramp = 0;  // s, duration of the smooth start; 0: acts from the beginning
  TimeFactor current_factor;
  double current_scale = 1;  // factor in the present stage of statics and afterwards
  WaveField waves;
  double wave_ramp = 0;  // s

  bool at_rest() const { return current.none() && waves.none(); }
  // Water without waves at a height z [m].
  Water without_waves_at(double z, double time) const;
  // Motion of the waves alone. A term evaluates it once a step (docs/theory/waves.md#in-a-step).
  WaveMotion waves_at(const Vec3& x, double time) const;
  // Wave pressure over rho g at a point, m.
  double wave_head(const Vec3& x, double time) const;
};
// Adds the wave motion to the current.
Water operator+(Water water, const WaveMotion& wave);

Sea sea_of(const model::Case& c);
CurrentProfile current_profile(const model::Water& w, double factor = 1);

}  // namespace hawser
