// Wave field of a case from the rows and spectra of its wave systems, or from its Stokes wave, for
// hydrodynamics and vessel motions.
#include "hawser/model/wave_components.hpp"

#include <cmath>

#include "hawser/math/random.hpp"

namespace hawser::model {
namespace {

WaveComponent component(const WaveSystem::Row& r) {
  WaveComponent out;
  out.amplitude = r.height / 2;
  out.omega = 2 * M_PI / r.period;
  out.phase = r.phase;
  out.x = std::cos(r.direction);
  out.y = std::sin(r.direction);
  return out;
}

std::vector<WaveComponent> components(const WaveSystem& w, std::uint64_t seed) {
  if (w.kind == WaveSystem::Kind::spectrum)
    return irregular(Jonswap{w.height, w.peak_period, w.gamma}, w.direction, w.count, seed, w.spreading);
  if (w.kind == WaveSystem::Kind::table)
    return irregular(w.spectrum, w.direction, w.count, seed, w.spreading);
  std::vector<WaveComponent> out;
  for (const WaveSystem::Row& r : w.rows) out.push_back(component(r));
  return out;
}

}  // namespace

StokesInput stokes_input(const Environment& e) {
  const WaveSystem& w = e.water.waves.systems.front();
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
  if (waves.stokes()) return WaveField(std::make_shared<const StokesWave>(stokes_input(e)));
  std::vector<WaveComponent> all;
  for (size_t i = 0; i < waves.systems.size(); ++i) {
    // Systems of the same seed have different phases.
    const WaveSystem& system = waves.systems[i];
    const std::vector<WaveComponent> some = components(system, sequence_seed(system.seed, i));
    all.insert(all.end(), some.begin(), some.end());
  }
  return WaveField(std::move(all), e.water.depth, e.gravity, waves.stretching);
}

}  // namespace hawser::model
