// Sea and seabed, and properties of lines in water, from the checked tree.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/advice/waves.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/model/increasing.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::io {
namespace {

using model::refuse;
using model::refuse_key;
using model::Value;
using WaveKind = model::WaveSystem::Kind;

// Rows of time and factor, from a file or the case.
TimeFactor read_time_factor(const Value& v, const CaseSource& source) {
  const InputRows given = read_input_rows(v, source);
  const auto& rows = given.rows;
  if (rows.size() < 2) refuse_rows(given, "a table of factors needs at least 2 rows, found {}", rows.size());
  std::vector<TimeFactor::Row> out;
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i];
    if (r.size() != 2)
      refuse_rows(given, "a row has 2 numbers, t and factor, but row {} has {}", i + 1, r.size());
    check_increase(given, i, "times", "s");
    out.emplace_back(r[0], r[1]);
  }
  return TimeFactor(std::move(out));
}

void finish_current(const Value& v, double water_depth, const CaseSource& source, model::Current& c) {
  if (const Value* f = v.find("time_factor")) c.time_factor = read_time_factor(*f, source);
  if (c.exponent > 0 && !(water_depth > 0))
    refuse(v["exponent"], "a power law needs 'depth' of the water or of the seabed");
  const Value* rows = v.find("profile");
  for (size_t i = 0; i < c.profile.size(); ++i)
    if (!rows || !rows->items[i].has("direction_deg")) c.profile[i].direction = v["direction_deg"].number;
  for (size_t i = 1; i < c.profile.size(); ++i)
    if (const std::string fault =
            model::increase_fault("depths", "m", c.profile[i - 1].depth, c.profile[i].depth);
        !fault.empty())
      refuse(v["profile"].items[i]["depth"], "{}", fault);
}

// Rows of a spectrum; returns its peak period [s].
double read_spectrum(const Value& s, const CaseSource& source, model::WaveSystem& w) {
  const InputRows given = read_input_rows(s, source);
  const auto& rows = given.rows;
  const double unit = s["frequency"].number;
  double energy = 0;
  SpectrumRow peak;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != 2)
      refuse_rows(given, "a row has 2 numbers, frequency and density, but row {} has {}", i + 1,
                  rows[i].size());
    const SpectrumRow r{rows[i][0] * unit, rows[i][1] / unit};
    if (!(r.omega >= 0) || !(r.density >= 0))
      refuse_rows(given, "frequencies and densities must not be negative, but row {} has {:g} and {:g}",
                  i + 1, rows[i][0], rows[i][1]);
    if (!w.spectrum.empty()) {
      const SpectrumRow& last = w.spectrum.back();
      check_increase(given, i, "frequencies", "");
      energy += 0.5 * (r.omega - last.omega) * (r.density + last.density);
    }
    w.spectrum.push_back(r);
    if (r.density > peak.density) peak = r;
  }
  if (!(energy > 0)) refuse_rows(given, "the spectrum has no energy");
  return 2 * M_PI / std::max(peak.omega, w.spectrum.back().omega / 50);
}

// The keys of a wave system.
const Value& system_keys(const Value& waves, size_t index) {
  const Value* sum = waves.find("sum");
  return sum ? sum->items[index] : waves;
}

void finish_waves(const Value& v, const CaseSource& source, model::Waves& waves) {
  double longest = 0;
  for (size_t i = 0; i < waves.systems.size(); ++i) {
    model::WaveSystem& w = waves.systems[i];
    const Value& given = system_keys(v, i);
    if (w.kind == WaveKind::stokes && waves.systems.size() > 1)
      refuse(given["stokes"],
             "Stokes' wave is not linear, so that no other waves can be added to it: give it alone, or a "
             "linear wave, 'regular', in its place");
    if (const Value* s = given.find("spectrum")) w.peak_period = read_spectrum(*s, source, w);
    longest = std::max(longest, w.peak_period);
    for (const model::WaveSystem::Row& r : w.rows) longest = std::max(longest, r.period);
  }
  if (!v.has("ramp")) waves.ramp = longest;
}

void finish_seabed(const Value& v, double water_depth, const CaseSource& source, model::Seabed& b,
                   std::vector<std::string>& notes) {
  if (!v.has("depth")) b.depth = water_depth;
  read_bed_surface(v, source, b, notes);
  if (!b.surface && !v.has("depth") && !(water_depth > 0))
    refuse_key(v, v.where + ".depth", "required key is missing: the depth, here or of the water");
  if (!v.has("normal_stiffness")) b.normal_stiffness = 1e5;
  if (b.force_table && v.has("smoothing"))
    refuse(v["smoothing"], "a force table defines the whole law, so there is nothing to smooth");
}

void check_stokes(const Value& v, const model::Environment& e, std::vector<std::string>& notes) {
  const model::WaveSystem& stokes = e.water.waves.systems.front();
  try {
    const StokesWave wave(model::stokes_input(e));
    constexpr double kUrsellLimit = 40;  // Hedges (1995)
    if (wave.ursell() > kUrsellLimit)
      notes.push_back(advice::long_for_its_depth(stokes.key, wave.ursell(), kUrsellLimit));
  } catch (const std::invalid_argument& error) {
    refuse(system_keys(v, 0)["stokes"], error.what());
  }
  if (stokes.current != 0 && !e.water.current.profile.empty())
    notes.push_back(advice::current_of_wave(stokes.key));
}

// Steepness limit 2 pi Hs/(g Tp²) of DNV-RP-C205, 3.5.4, linear between 8 and 15 s.
void check_sea_steepness(const model::WaveSystem& w, double gravity, std::vector<std::string>& notes) {
  if (w.kind != WaveKind::spectrum) return;
  const double fraction = std::clamp((w.peak_period - 8) / 7, 0.0, 1.0);
  const double steepest = (1 - fraction) / 15 + fraction / 25;
  const double steepness = 2 * M_PI * w.height / (gravity * w.peak_period * w.peak_period);
  if (steepness > steepest) notes.push_back(advice::sea_breaks(w, steepness, steepest));
}

// Linear theory has no breaking limit (Miche 1944).
void check_steepness(const model::WaveSystem& w, const model::Environment& e,
                     std::vector<std::string>& notes) {
  if (w.kind != WaveKind::regular && w.kind != WaveKind::components) return;
  for (size_t i = 0; i < w.rows.size(); ++i) {
    const double k = wave_number(2 * M_PI / w.rows[i].period, e.water.depth, e.gravity);
    const double length = 2 * M_PI / k;
    const double highest = 0.142 * length * (e.water.depth > 0 ? std::tanh(k * e.water.depth) : 1);
    if (!(w.rows[i].height > highest)) continue;
    const std::string key = w.kind == WaveKind::regular ? w.key : fmt::format("{}[{}]", w.key, i);
    notes.push_back(advice::wave_breaks(key, w.rows[i].height, length, highest));
  }
}

}  // namespace

void finish_environment(const Value& v, const CaseSource& source, model::Environment& e,
                        std::vector<std::string>& notes) {
  if (const Value* b = v.find("seabed")) {
    finish_seabed(*b, e.water.depth, source, e.seabed, notes);
    if (e.water.present && !(e.water.depth > 0) && !e.seabed.surface)
      e.water.depth = e.seabed.depth + e.water.surface;
  }
  if (const Value* c = v.find("current")) {
    if (!e.water.present) refuse(*c, "requires 'water'");
    finish_current(*c, e.water.depth, source, e.water.current);
  }
  if (const Value* w = v.find("wind"))
    if (const Value* f = w->find("time_factor")) e.wind.time_factor = read_time_factor(*f, source);
  if (const Value* w = v.find("waves")) {
    if (!e.water.present) refuse(*w, "requires 'water'");
    if (!(e.gravity > 0)) refuse(*w, "without gravity there are no waves: 'environment.gravity' is 0");
    if (e.seabed.surface && !(e.water.depth > 0))
      refuse(*w, "with a seabed of a grid or a mesh, waves need one 'depth' of the water");
    finish_waves(*w, source, e.water.waves);
    if (e.water.waves.stokes()) check_stokes(*w, e, notes);
    if (!advice::possible(e.water.waves)) return;
    for (const model::WaveSystem& system : e.water.waves.systems) {
      check_steepness(system, e, notes);
      check_sea_steepness(system, e.gravity, notes);
    }
  }
}

void finish_in_water(const Value& v, const model::Water& water, model::LineType& t) {
  if (!(t.displaced_diameter > 0)) t.displaced_diameter = t.outer_diameter;
  if (!(t.drag_diameter > 0)) t.drag_diameter = t.outer_diameter;
  if (const Value* c = v.find("contents")) {
    const bool bore = c->has("inner_diameter");
    const bool pipe = v.has("pipe");
    if (bore && pipe) refuse((*c)["inner_diameter"], "'pipe' already defines it; remove one of them");
    if (!bore && !pipe)
      refuse_key(*c, c->where + ".inner_diameter", "required key is missing: the diameter of the bore");
    if (const Value& density = (*c)["density"]; density.is("flooded")) {
      if (!water.present) refuse(density, "is 'flooded', but there is no 'environment.water'");
      t.contents_density = water.density;
    }
    const Value& given = bore ? (*c)["inner_diameter"] : v["pipe"];
    if (t.inner_diameter >= t.outer_diameter)
      refuse(given, "{:g} m is not less than the outer diameter of {:g} m", t.inner_diameter,
             t.outer_diameter);
    // The bore must lie inside the displaced volume; otherwise its contents would have weight in water
    // without buoyancy.
    if (t.inner_diameter >= t.displaced_diameter)
      refuse(given, "a bore of {:g} m does not fit into the {:.4g} m that the line displaces{}",
             t.inner_diameter, t.displaced_diameter,
             v.has("weight")
                 ? " by its weights: if those are of the drained line in air and of the flooded line under "
                   "water leave 'contents' out, or give the weight of the empty line with closed ends as "
                   "'submerged'"
                 : ": 'displaced_diameter' is that of the closed line, with its bore");
    t.mass_per_length += t.contents_density * M_PI / 4 * t.inner_diameter * t.inner_diameter;
  }
  if (const Value* g = v.find("marine_growth")) {
    // Marine growth is added to the outer diameter, independent of the displaced diameter.
    const double d = t.outer_diameter;
    const double D = d + 2 * (*g)["thickness"].number;
    const double area = M_PI / 4 * (D * D - d * d);
    t.mass_per_length += (*g)["density"].number * area;
    t.displaced_diameter = std::sqrt(std::pow(t.displaced_diameter, 2) + 4 / M_PI * area);
    t.drag_diameter += D - d;
  }
}

}  // namespace hawser::io
