// The sea, its bed, and what lines are in it, from the checked tree.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/io/case_reader_parts.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::io {
namespace {

using model::Value;

double number(const Value& v, const char* key, double otherwise = 0) {
  const Value* x = v.find(key);
  return x ? x->number : otherwise;
}

// Rows of t and factor, from a file or written there.
TimeFactor read_time_factor(const Value& v, const std::string& key, const CaseSource& source) {
  const GivenRows given = read_given_rows(v, key, source);
  const auto& [at, where, rows] = given;
  if (rows.size() < 2)
    source.bad(at, where, fmt::format("a table of factors needs at least 2 rows, found {}", rows.size()));
  std::vector<TimeFactor::Row> out;
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i];
    if (r.size() != 2)
      source.bad(at, where,
                 fmt::format("a row has 2 numbers, t and factor, but row {} has {}", i + 1, r.size()));
    check_time(given, i, source);
    out.emplace_back(r[0], r[1]);
  }
  return TimeFactor(std::move(out));
}

model::Current read_current(const Value& v, double water_depth, const CaseSource& source) {
  const std::string key = "environment.current";
  model::Current c;
  c.ramp = v["ramp"].number;
  if (const Value* f = v.find("time_factor"))
    c.time_factor = read_time_factor(*f, key + ".time_factor", source);
  if (v.has("speed")) {
    c.profile.push_back({0, v["speed"].number, v["direction_deg"].number});
    c.exponent = number(v, "exponent");
    if (c.exponent > 0 && !(water_depth > 0))
      source.bad(v["exponent"], key + ".exponent", "a power law needs 'depth' of the water or of the seabed");
    return c;
  }
  for (const Value& r : v["profile"].items) {
    const model::CurrentRow row{r["depth"].number, r["speed"].number, r["direction_deg"].number};
    if (!c.profile.empty() && !(row.depth > c.profile.back().depth))
      source.bad(
          r["depth"], fmt::format("{}.profile[{}].depth", key, c.profile.size()),
          fmt::format("rows go downwards, but {:g} m comes after {:g} m", row.depth, c.profile.back().depth));
    c.profile.push_back(row);
  }
  return c;
}

void read_components(const Value& s, model::Waves& w) {
  w.direction = s["direction_deg"].number, w.spreading = s["spreading"].number;
  w.count = static_cast<int>(s["components"].number);
  w.seed = static_cast<std::uint64_t>(s["seed"].number);
}

// Rows of a spectrum; the period [s] of its peak.
double read_spectrum(const Value& s, const CaseSource& source, model::Waves& w) {
  const auto [at, where, rows] = read_given_rows(s, "environment.waves.spectrum", source);
  const double unit = s["frequency"].is("hz") ? 2 * M_PI : 1;
  double energy = 0;
  SpectrumRow peak;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != 2)
      source.bad(at, where,
                 fmt::format("a row has 2 numbers, frequency and density, but row {} has {}", i + 1,
                             rows[i].size()));
    const SpectrumRow r{rows[i][0] * unit, rows[i][1] / unit};
    if (!(r.omega >= 0) || !(r.density >= 0))
      source.bad(at, where,
                 fmt::format("frequencies and densities must not be negative, but row {} has {:g} and {:g}",
                             i + 1, rows[i][0], rows[i][1]));
    if (!w.spectrum.empty()) {
      const SpectrumRow& last = w.spectrum.back();
      if (!(r.omega > last.omega))
        source.bad(at, where,
                   fmt::format("frequencies must grow, but row {} has {:g} after {:g}", i + 1, rows[i][0],
                               rows[i - 1][0]));
      energy += 0.5 * (r.omega - last.omega) * (r.density + last.density);
    }
    w.spectrum.push_back(r);
    if (r.density > peak.density) peak = r;
  }
  if (!(energy > 0)) source.bad(at, where, "the spectrum has no energy");
  return 2 * M_PI / std::max(peak.omega, w.spectrum.back().omega / 50);
}

model::Waves read_waves(const Value& v, const CaseSource& source) {
  model::Waves w;
  const auto row = [](const Value& r) {
    return model::Waves::Row{r["height"].number, r["period"].number, r["direction_deg"].number,
                             r["phase_deg"].number};
  };
  double longest = 0;
  const char* kinds[] = {"jonswap", "pierson_moskowitz"};
  for (const char* kind : kinds)
    if (const Value* s = v.find(kind)) {
      w.kind = model::Waves::Kind::spectrum;
      w.height = (*s)["hs"].number, w.peak_period = (*s)["tp"].number;
      w.gamma = number(*s, "gamma", 1);
      read_components(*s, w);
      longest = w.peak_period;
    }
  if (const Value* s = v.find("spectrum")) {
    w.kind = model::Waves::Kind::table;
    longest = w.peak_period = read_spectrum(*s, source, w);
    read_components(*s, w);
  }
  if (const Value* s = v.find("stokes")) {
    w.kind = model::Waves::Kind::stokes;
    w.rows.push_back(row(*s));
    w.current = (*s)["current"].number, w.transport = (*s)["current_is"].is("transport");
  }
  if (const Value* r = v.find("regular")) {
    w.kind = model::Waves::Kind::regular;
    w.rows.push_back(row(*r));
  }
  if (const Value* c = v.find("components")) {
    w.kind = model::Waves::Kind::components;
    for (const Value& r : c->items) w.rows.push_back(row(r));
  }
  for (const model::Waves::Row& r : w.rows) longest = std::max(longest, r.period);
  w.stretching = v["stretching"].is("none")       ? Stretching::none
                 : v["stretching"].is("vertical") ? Stretching::vertical
                                                  : Stretching::wheeler;
  w.ramp = number(v, "ramp", longest);
  return w;
}

model::Seabed read_seabed(const Value& v, double water_depth, const CaseSource& source) {
  const std::string key = "environment.seabed";
  model::Seabed b;
  b.present = true;
  b.depth = number(v, "depth", water_depth);
  read_bed_surface(v, source, b);
  if (!b.surface && !(b.depth > 0))
    source.bad(v, key + ".depth", "required key is missing: the depth, here or of the water");
  b.slope = v["slope_deg"].number, b.direction = v["slope_direction_deg"].number;
  b.normal_stiffness = 1e5;
  if (const Value* k = v.find("normal_stiffness"); k && k->has("table")) {
    b.force_table = read_force_table((*k)["table"], key + ".normal_stiffness.table", source);
    b.normal_stiffness = b.force_table->largest_slope();
    b.basis = (*k)["per"].is("length") ? model::StiffnessBasis::per_length : model::StiffnessBasis::per_area;
    if (v.has("smoothing"))
      source.bad(v["smoothing"], key + ".smoothing",
                 "a force table defines the whole law, so there is nothing to smooth");
  } else if (k) {
    b.basis = k->has("per_length") ? model::StiffnessBasis::per_length : model::StiffnessBasis::per_area;
    b.normal_stiffness = (*k)[k->has("per_length") ? "per_length" : "per_area"].number;
  }
  b.damping = v["damping"].number;
  b.smoothing = number(v, "smoothing", -1);
  if (const Value* s = v.find("suction"))
    b.suction = (*s)["limit"].number, b.suction_length = (*s)["length"].number;
  const Value& f = v["friction"];
  if (f.kind == Value::Kind::map)
    b.friction = read_friction(f, key + ".friction", source);
  else
    b.friction.axial = b.friction.lateral = f.number;
  b.full = v["friction_in_statics"].is("full");
  b.as_laid = b.full || v["friction_in_statics"].is("as_laid");
  return b;
}

}  // namespace

namespace {

void check_stokes(const Value& v, const model::Environment& e, const CaseSource& source,
                  std::vector<std::string>& notes) {
  const std::string key = "environment.waves.stokes";
  try {
    const StokesWave wave(model::stokes_input(e));
    constexpr double kGood = 40;  // Hedges (1995)
    if (wave.ursell() > kGood)
      notes.push_back(
          fmt::format("{}: the wave is long for its depth: its Ursell number is {:.3g}, and fifth-order "
                      "theory is good up to {:g}",
                      key, wave.ursell(), kGood));
  } catch (const std::invalid_argument& error) {
    source.bad(v["stokes"], key, error.what());
  }
  if (e.water.waves.current != 0 && !e.water.current.profile.empty())
    notes.push_back(key +
                    ".current: lines feel it beside 'environment.current', which does not change the wave");
}

// DNV-RP-C205, 3.5.4: steepness 2 pi Hs/(g Tp²) of the steepest seas, straight between 8 and 15 s.
void check_sea_steepness(const Value& v, const model::Environment& e, std::vector<std::string>& notes) {
  const model::Waves& w = e.water.waves;
  if (w.kind != model::Waves::Kind::spectrum || !(e.gravity > 0)) return;
  const double share = std::clamp((w.peak_period - 8) / 7, 0.0, 1.0);
  const double steepest = (1 - share) / 15 + share / 25;
  const double steepness = 2 * M_PI * w.height / (e.gravity * w.peak_period * w.peak_period);
  if (steepness > steepest)
    notes.push_back(fmt::format(
        "environment.waves.{}: waves of a sea of {:g} m at {:g} s would break: its steepness 2 pi hs/(g tp²) "
        "is {:.3g}, and seas of this period get to {:.3g}, {:.3g} m high (DNV-RP-C205)",
        v.find("jonswap") ? "jonswap" : "pierson_moskowitz", w.height, w.peak_period, steepness, steepest,
        w.height * steepest / steepness));
}

// Linear theory goes on where a wave would break (Miche 1944).
void check_steepness(const model::Environment& e, std::vector<std::string>& notes) {
  const model::Waves& w = e.water.waves;
  if (w.kind != model::Waves::Kind::regular && w.kind != model::Waves::Kind::components) return;
  if (!(e.gravity > 0)) return;
  for (size_t i = 0; i < w.rows.size(); ++i) {
    const double k = wave_number(2 * M_PI / w.rows[i].period, e.water.depth, e.gravity);
    const double length = 2 * M_PI / k;
    const double highest = 0.142 * length * (e.water.depth > 0 ? std::tanh(k * e.water.depth) : 1);
    if (w.rows[i].height > highest)
      notes.push_back(fmt::format(
          "environment.waves.{}: a wave of {:g} m would break: {:.3g} m long, it gets {:.3g} m high (Miche)",
          w.kind == model::Waves::Kind::regular ? "regular" : fmt::format("components[{}]", i),
          w.rows[i].height, length, highest));
  }
}

}  // namespace

model::Environment read_environment(const Value& v, const CaseSource& source,
                                    std::vector<std::string>& notes) {
  model::Environment e;
  e.gravity = v["gravity"].number;
  if (const Value* w = v.find("water")) {
    e.water.present = true;
    e.water.density = (*w)["density"].number;
    e.water.depth = number(*w, "depth");
    e.water.surface = (*w)["surface"].number;
  }
  if (const Value* b = v.find("seabed")) {
    e.seabed = read_seabed(*b, e.water.depth, source);
    if (e.water.present && !(e.water.depth > 0) && !e.seabed.surface)
      e.water.depth = e.seabed.depth + e.water.surface;
  }
  if (const Value* c = v.find("current")) {
    if (!e.water.present) source.bad(*c, "environment.current", "needs 'water' beside it");
    e.water.current = read_current(*c, e.water.depth, source);
  }
  if (const Value* w = v.find("waves")) {
    if (!e.water.present) source.bad(*w, "environment.waves", "needs 'water' beside it");
    if (e.seabed.surface && !(e.water.depth > 0))
      source.bad(*w, "environment.waves",
                 "over a bed of a grid or a mesh waves need 'depth' of the water, which is one for all");
    e.water.waves = read_waves(*w, source);
    if (e.water.waves.kind == model::Waves::Kind::stokes) check_stokes(*w, e, source, notes);
    check_steepness(e, notes);
    check_sea_steepness(*w, e, notes);
  }
  return e;
}

namespace {

void read_bore(const Value& c, const std::string& key, const CaseSource& source, bool pipe, double& bore) {
  const Value* given = c.find("inner_diameter");
  if (given && pipe)
    source.bad(*given, key + ".inner_diameter", "'pipe' already says what it is; remove one of them");
  if (!given && !pipe)
    source.bad(c, key + ".inner_diameter", "required key is missing: the diameter of the bore");
  if (given) bore = given->number;
}

}  // namespace

void read_in_water(const Value& v, const std::string& key, const CaseSource& source,
                   const model::Water& water, model::LineType& t) {
  const bool known = t.drag_diameter > 0;  // from the library; what is given goes before it
  t.displaced_diameter =
      number(v, "displaced_diameter", t.displaced_diameter > 0 ? t.displaced_diameter : t.outer_diameter);
  t.drag_diameter = number(v, "drag_diameter", known ? t.drag_diameter : t.displaced_diameter);
  const auto take = [&](const char* name, double& x) {
    if (!known || v[name].given) x = v[name].number;
  };
  take("Cd_normal", t.Cd_normal), take("Cd_axial", t.Cd_axial);
  take("Ca_normal", t.Ca_normal), take("Ca_axial", t.Ca_axial);
  if (const Value* c = v.find("contents")) {
    read_bore(*c, key + ".contents", source, v.has("pipe"), t.inner_diameter);
    const Value& density = (*c)["density"];
    if (density.is("flooded") && !water.present)
      source.bad(density, key + ".contents.density", "is 'flooded', but there is no 'environment.water'");
    t.contents_density = density.is("flooded") ? water.density : density.number;
    t.contents_pressure = (*c)["pressure"].number;
    if (t.inner_diameter >= t.outer_diameter)
      source.bad(
          (*c)["inner_diameter"], key + ".contents.inner_diameter",
          fmt::format("{:g} m is not inside the outside of {:g} m", t.inner_diameter, t.outer_diameter));
    t.mass_per_length += t.contents_density * M_PI / 4 * t.inner_diameter * t.inner_diameter;
  }
  if (const Value* g = v.find("marine_growth")) {
    const double d = t.displaced_diameter, D = d + 2 * (*g)["thickness"].number;
    t.mass_per_length += (*g)["density"].number * M_PI / 4 * (D * D - d * d);
    t.displaced_diameter = D;
    t.drag_diameter += D - d;
  }
}

}  // namespace hawser::io
