// The sea of a case: water motion at a point and time.
#include "hawser/terms/sea.hpp"

#include <cmath>

#include "hawser/kernels/motion.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser {

Water Sea::without_waves_at(double z, double time) const {
  Water w;
  w.surface = surface;
  if (current.none()) return w;
  current.at(surface - z, w.velocity, w.by_height);
  const double ramp = current_ramp > 0 ? quintic_ramp(time, current_ramp).value : 1;
  const double factor = current_scale * ramp * current_factor.at(time);
  w.velocity *= factor;
  w.by_height *= -factor;
  return w;
}

WaveMotion Sea::waves_at(const Vec3& x, double time) const {
  const Ramp ramp = wave_ramp > 0 ? quintic_ramp(time, wave_ramp) : Ramp{1, 0, 0};
  return waves.at(x - surface * Vec3::UnitZ(), time, ramp.value, ramp.rate);
}

double Sea::wave_head(const Vec3& x, double time) const {
  const double factor = wave_ramp > 0 ? quintic_ramp(time, wave_ramp).value : 1;
  return waves.head(x - surface * Vec3::UnitZ(), time, factor);
}

Water operator+(Water water, const WaveMotion& wave) {
  water.surface += wave.surface;
  water.velocity += wave.velocity;
  water.acceleration = wave.acceleration;
  return water;
}

CurrentProfile current_profile(const model::Water& w, double factor) {
  const auto vector = [factor](const model::CurrentRow& r) {
    const double speed = factor * r.speed;
    return Vec3(speed * std::cos(r.direction), speed * std::sin(r.direction), 0);
  };
  const model::Current& current = w.current;
  if (current.exponent > 0) return CurrentProfile(vector(current.profile.front()), current.exponent, w.depth);
  std::vector<CurrentProfile::Row> rows;
  for (const model::CurrentRow& r : current.profile) rows.push_back({r.depth, vector(r)});
  return CurrentProfile(std::move(rows));
}

Sea sea_of(const model::Case& c) {
  const model::Water& w = c.environment.water;
  Sea sea;
  sea.density = w.density;
  sea.gravity = c.environment.gravity;
  sea.surface = w.surface;
  sea.current = current_profile(w);
  sea.current_ramp = w.current.ramp;
  sea.current_factor = w.current.time_factor;
  sea.waves = model::wave_field(c.environment);
  sea.wave_ramp = w.waves.ramp;
  return sea;
}

}  // namespace hawser
