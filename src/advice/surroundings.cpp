// Consistency of water, bed, waves and duration with each other and with the lines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/geometry/surface.hpp"
#include "hawser/model/check.hpp"

namespace hawser::advice {

using namespace model;

namespace {

void bed_and_water(const Case& c, std::vector<InputWarning>& out) {
  const Seabed& bed = c.environment.seabed;
  const Water& w = c.environment.water;
  if (!bed.present || c.lines.empty()) return;
  if (!w.present && c.environment.gravity > 0 && bed.depth > 0) {
    add_warning(out, "environment", Effect::all,
                "there is a seabed {:.4g} m below z = 0 and no water, so the lines hang in air; add 'water: "
                "{{depth: {:.6g}}}' for the sea",
                bed.depth, bed.depth);
    return;
  }
  double highest = -bed.depth;
  if (bed.surface) highest = bed.surface->bounds().hi.z();
  const double lowest = bed.surface && std::isfinite(bed.depth) ? -2 * bed.depth - highest : highest;
  if (w.present && lowest > w.surface)
    add_warning(out, bed.surface ? "environment.seabed" : "environment.seabed.depth", Effect::all,
                "all of the seabed is {:.4g} m or more above the water: z points up{}", lowest - w.surface,
                bed.surface ? "; 'depths: true' is for a grid of depths, positive downwards" : "");
}

// 4 sqrt(m0) of an irregular sea by a formula or a table, m; 0 of other waves.
double significant_height(const WaveSystem& w) {
  if (w.kind == WaveSystem::Kind::spectrum) return w.height;
  double energy = 0;
  for (std::size_t i = 1; i < w.spectrum.size(); ++i)
    energy += 0.5 * (w.spectrum[i].omega - w.spectrum[i - 1].omega) *
              (w.spectrum[i].density + w.spectrum[i - 1].density);
  return 4 * std::sqrt(energy);
}

// Waves break when their height reaches the water depth.
void shallow_waves(const Case& c, std::vector<InputWarning>& out) {
  const Water& w = c.environment.water;
  double height = 0;
  for (const WaveSystem& system : w.waves.systems) height = std::hypot(height, significant_height(system));
  if (!(w.depth > 0) || height < 0.8 * w.depth) return;
  add_warning(out, "environment.waves", Effect::all,
              "a significant height of {:.4g} m is {:.2g} times the water depth of {:.4g} m: waves break at "
              "about 0.6",
              height, height / w.depth, w.depth);
}

// Significant height and peak of a tabulated spectrum, compared with the steepest seas (DNV-RP-C205 3.5.4,
// 1/15 at 8 s and below) and the longest swell.
void spectrum_rows(const WaveSystem& w, double gravity, std::vector<InputWarning>& out) {
  if (w.kind != WaveSystem::Kind::table) return;
  const double hs = significant_height(w);
  const double tp = w.peak_period;
  const double steepness = 2 * M_PI * hs / (gravity * tp * tp);
  constexpr double kSteepest = 1.0 / 12, kLongest = 40, kHighest = 25;
  if (steepness < kSteepest && tp < kLongest && hs < kHighest) return;
  add_warning(
      out, w.key, Effect::all,
      "its rows make waves of {:.3g} m with a peak at {:.3g} s, {}: is 'frequency' right (hz or rad_s)?", hs,
      tp,
      tp >= kLongest   ? "longer than any swell"
      : hs >= kHighest ? "higher than any sea"
                       : "which would break");
}

bool has_mean_drift(const Body& b) {
  return b.mass && b.mass->hydrodynamics && b.mass->hydrodynamics->second_order != SecondOrder::none;
}

// Ramps longer than the run, and waves without dynamics.
void ramps_and_duration(const Case& c, std::vector<InputWarning>& out) {
  const Water& w = c.environment.water;
  const bool waves = !w.waves.none();
  const auto ramp = [&](double length, const std::string& key) {
    if (length > c.dynamics.duration)
      add_warning(out, key, Effect::part,
                  "{:.4g} s is longer than the run of {:.4g} s, at the end of which it has reached {:.2g} %",
                  length, c.dynamics.duration, 100 * c.dynamics.duration / length);
  };
  if (!c.dynamics.enabled) {
    if (waves && std::none_of(c.bodies.begin(), c.bodies.end(), has_mean_drift))
      add_warning(out, "environment.waves", Effect::part,
                  "they act in dynamics only, and the case has no 'dynamics'");
    return;
  }
  if (waves && possible(w.waves)) ramp(w.waves.ramp, "environment.waves.ramp");
  if (!w.current.profile.empty()) ramp(w.current.ramp, "environment.current.ramp");
  for (const Body& b : c.bodies)
    if (b.motion.index() != 0) ramp(b.ramp, fmt::format("bodies.{}.motion.ramp", b.name));
}

}  // namespace

void warn_of_surroundings(const Case& c, std::vector<InputWarning>& out) {
  bed_and_water(c, out);
  shallow_waves(c, out);
  for (const WaveSystem& w : c.environment.water.waves.systems) spectrum_rows(w, c.environment.gravity, out);
  ramps_and_duration(c, out);
}

}  // namespace hawser::advice
