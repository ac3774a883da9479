// Wave field of a case from its rows, spectrum, tabulated spectrum or Stokes wave, for hydrodynamics and
// vessel motions.
#include "hawser/model/wave_components.hpp"

#include <cmath>

namespace hawser::model {

StokesInput stokes_input(const Environment& e) {
  const Waves& w = e.water.waves;
  StokesInput input;
  input.height = w.rows[0].height;
  input.period = w.rows[0].period;
  input.direction = w.rows[0].direction;
  input.phase = w.rows[0].phase;
  input.depth = e.water.depth;
  input.gravity = e.gravity;
  input.current = w.current;
  input.transport = w.transport;
  return input;
}

WaveField wave_field(const Environment& e) {
  const Waves& waves = e.water.waves;
  if (waves.kind == Waves::Kind::stokes)
    return WaveField(std::make_shared<const StokesWave>(stokes_input(e)));
  std::vector<WaveComponent> components;
  if (waves.kind == Waves::Kind::spectrum) {
    components = irregular(Jonswap{waves.height, waves.peak_period, waves.gamma}, waves.direction,
                           waves.count, waves.seed, waves.spreading);
  } else if (waves.kind == Waves::Kind::table) {
    components = irregular(waves.spectrum, waves.direction, waves.count, waves.seed, waves.spreading);
  } else {
    for (const Waves::Row& r : waves.rows) {
      WaveComponent one;
      one.amplitude = r.height / 2;
      one.omega = 2 * M_PI / r.period;
      one.phase = r.phase;
      one.x = std::cos(r.direction);
      one.y = std::sin(r.direction);
      components.push_back(one);
    }
  }
  return WaveField(std::move(components), e.water.depth, e.gravity, waves.stretching);
}

}  // namespace hawser::model
