#include "hawser/model/wave_components.hpp"

#include <cmath>

namespace hawser::model {

WaveField wave_field(const Environment& e) {
  const Waves& waves = e.water.waves;
  std::vector<WaveComponent> components;
  if (waves.kind == Waves::Kind::spectrum) {
    components = irregular(jonswap(waves.height, waves.peak_period, waves.gamma), waves.direction,
                           waves.count, waves.seed, waves.spreading);
  } else {
    for (const Waves::Row& r : waves.rows) {
      WaveComponent one;
      one.amplitude = r.height / 2, one.omega = 2 * M_PI / r.period, one.phase = r.phase;
      one.x = std::cos(r.direction), one.y = std::sin(r.direction);
      components.push_back(one);
    }
  }
  return WaveField(std::move(components), e.water.depth, e.gravity, waves.stretching);
}

}  // namespace hawser::model
