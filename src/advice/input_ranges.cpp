// Plausible ranges of numbers: the strongest current, the deepest ocean, the density of water. A value
// outside suggests a wrong unit, decimal point or column. Also angles given in radians.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/radians.hpp"
#include "hawser/model/schema.hpp"
#include "unit_hint.hpp"

namespace hawser::advice {

using namespace model;

namespace {

// Range of a magnitude, SI; 0 is always accepted.
struct Range {
  std::string_view path;  // '*': names of the user's choice; []: list entries
  double lower, upper;
  const char* quantities;  // quantities in the range, for the message
};

// Currents: tidal streams of narrows have 5 m/s (Pentland Firth), ocean currents 2.5. Waves: hs of 20 m and
// single waves of 30 m were measured; swell has periods up to 25 s. Depth: Challenger Deep, 10.9 km. Density
// of water: 958 kg/m³ boiling to 1240 in the Dead Sea. Friction: chain on rock 1.2. Drag of chain and
// strakes: 2.6 and 3; added mass of a cylinder on a wall 2.3. Pressure: equipment of 20 000 psi is the
// strongest there is. Thermal expansion of quartz 5e-7/K, of polymers 2e-4. Moduli: rubber 1 MPa, diamond
// 1200 GPa.
constexpr double kMostFriction = 2, kMostCurrent = 6, kDeepest = 11000;
constexpr double kHighestSea = 25, kHighestWave = 40, kLongestSea = 30, kLongestWave = 40, kShortest = 0.3;
constexpr double kLongestComponent = 1.5 * kLongestWave;  // of a sea of long waves
constexpr auto kRanges = std::to_array<Range>({
    {"environment.gravity", 9.7, 10, "gravity on Earth"},
    {"environment.water.density", 900, 1300, "the density of water"},
    {"environment.water.depth", 0, kDeepest, "the depth of the oceans"},
    {"environment.seabed.depth", 0, kDeepest, "the depth of the oceans"},
    {"environment.seabed.slope_deg", 0, 45 * M_PI / 180, "the slope of soils"},
    {"environment.seabed.friction", 0, kMostFriction, "friction on a seabed"},
    {"environment.seabed.friction.axial", 0, kMostFriction, "friction on a seabed"},
    {"environment.seabed.friction.lateral", 0, kMostFriction, "friction on a seabed"},
    {"environment.seabed.friction.mobilisation_length", 0, 2, "the mobilisation length of soils"},
    {"environment.seabed.smoothing", 0, 1, "the roughness of a seabed"},
    {"environment.current.speed", 0, kMostCurrent, "currents at sea"},
    {"environment.current.profile[].speed", 0, kMostCurrent, "currents at sea"},
    {"environment.current.profile[].depth", 0, kDeepest, "the depth of the oceans"},
    {"environment.wind.speed", 0, 100, "winds"},
    {"environment.wind.density", 0.9, 1.6, "the density of air"},
    {"environment.waves.stokes.current", 0, kMostCurrent, "currents at sea"},
    {"environment.waves.jonswap.hs", 0.001, kHighestSea, "significant heights of seas"},
    {"environment.waves.jonswap.tp", kShortest, kLongestSea, "peak periods of seas"},
    {"environment.waves.pierson_moskowitz.hs", 0.001, kHighestSea, "significant heights of seas"},
    {"environment.waves.pierson_moskowitz.tp", kShortest, kLongestSea, "peak periods of seas"},
    {"environment.waves.regular.height", 0.001, kHighestWave, "heights of waves"},
    {"environment.waves.regular.period", kShortest, kLongestWave, "periods of waves"},
    {"environment.waves.stokes.height", 0.001, kHighestWave, "heights of waves"},
    {"environment.waves.stokes.period", kShortest, kLongestWave, "periods of waves"},
    {"environment.waves.components[].height", 0, kHighestWave, "heights of waves"},
    {"environment.waves.components[].period", kShortest, kLongestComponent, "periods of waves"},
    {"line_types.*.Cd_normal", 0, 5, "drag coefficients across a line"},
    {"line_types.*.Cd_axial", 0, 1.5, "drag coefficients along a line, on its skin"},
    {"line_types.*.Ca_normal", 0, 5, "added mass coefficients of lines"},
    {"line_types.*.Ca_axial", 0, 5, "added mass coefficients of lines"},
    {"line_types.*.contents.pressure", 1e4, 1.5e8, "operating pressures of pipes"},
    {"line_types.*.marine_growth.thickness", 0, 0.5, "marine growth"},
    {"line_types.*.marine_growth.density", 900, 3000, "the density of marine growth"},
    {"line_types.*.stiffness_damping", 0, 1, "stiffness-proportional damping of lines (0.001 to 0.1 s)"},
    {"line_types.*.thermal_expansion", 1e-7, 1e-3, "the thermal expansion of materials"},
    {"line_types.*.pipe.material.E", 1e6, 1.3e12, "moduli of elasticity"},
    {"line_types.*.pipe.material.density", 500, 20000, "the density of walls"},
    {"line_types.*.pipe.coatings[].density", 50, 8000, "the density of coatings"},
    {"line_types.*.weight.full_of", 1, 5000, "the density of contents"},
    {"line_types.*.weight.water_density", 900, 1300, "the density of water"},
    {"bodies.*.motion.velocity", 0, 30, "the speed of vessels"},
    {"bodies.*.motion.rotation.rate", 0, 10, "turning rates (10 rad/s are 95 turns a minute)"},
    {"bodies.*.motion.harmonic.rotation_amplitude_deg", 0, M_PI, "amplitudes of rotation"},
    {"bodies.*.floating.velocity", 0, 50, "velocities of bodies"},
    {"bodies.*.floating.angular_velocity", 0, 30, "turning rates of bodies"},
    {"bodies.*.floating.in_water.Cd", 0, 10, "drag coefficients of bodies"},
    {"bodies.*.floating.in_water.Ca", 0, 20, "added mass coefficients of bodies"},
    {"volumes.*.friction", 0, kMostFriction, "friction of surfaces"},
    {"volumes.*.friction.axial", 0, kMostFriction, "friction of surfaces"},
    {"volumes.*.friction.lateral", 0, kMostFriction, "friction of surfaces"},
    {"contact.between_lines.friction", 0, kMostFriction, "friction between lines"},
    {"contact.between_lines.pairs[].friction", 0, kMostFriction, "friction between lines"},
    {"lines.*.temperature_change", 0, 400, "changes of temperature of lines"},
    {"lines.*.end_a.feed.speed", 0, 20, "speeds of winches"},
    {"lines.*.end_b.feed.speed", 0, 20, "speeds of winches"},
    {"lines.*.end_a.feed.max_speed", 0, 20, "speeds of winches"},
    {"lines.*.end_b.feed.max_speed", 0, 20, "speeds of winches"},
    {"events[].feed.speed", 0, 20, "speeds of winches"},
    {"lines.*.masses[].Ca", 0, 5, "added mass coefficients of buoys"},
    {"dynamics.error_tolerance", 0, 0.1, "local errors that do not affect results"},
});

// In the base unit of the key; degrees for angles.
std::string in_unit(double si, Dimension d) {
  const double number = d == Dimension::angle ? si * 180 / M_PI : si;
  return fmt::format("{:.4g}{}{}", number, d == Dimension::none ? "" : " ",
                     d == Dimension::none ? "" : base_unit(d));
}

bool plain(const Value& v) {
  const Quantity q = parse_quantity(v.text, Dimension::none);
  return q.status == Quantity::Status::ok;
}

bool written_in_radians(const Value& v) {
  const Quantity q = parse_quantity(v.text, Dimension::none);
  return q.status == Quantity::Status::ok && v.text.find('.') != std::string::npos && is_in_radians(q.si);
}

// For a number in place of a period of the kind `quantities`, whose inverse `fits`.
std::string frequency_hint(const Value& v, std::string_view quantities, FunctionRef<bool(double)> fits) {
  const bool period = quantities.find("periods") != std::string_view::npos;
  if (!period || !plain(v) || !fits(1 / v.number)) return "";
  return fmt::format("; is it a frequency in Hz? ('{:.4g} s')", 1 / v.number);
}

class Walk {
 public:
  explicit Walk(std::vector<InputWarning>& out) : out_(out) {}

  void visit(const Value& v, const std::string& path) {
    if (!v.given || !v.schema) return;
    switch (v.kind) {
      case Value::Kind::map: {
        const bool names = v.schema->type == Key::Type::map_by_name;
        for (std::size_t i = 0; i < v.items.size(); ++i)
          visit(*Entry(v, i), path + (path.empty() ? "" : ".") + (names ? "*" : v.keys[i]));
        return;
      }
      case Value::Kind::list:
        if (v.schema->type == Key::Type::vec3) {
          const std::size_t before = out_.size();
          for (const Value& x : v.items)
            if (out_.size() == before) number(x, *v.schema, path, v.where);  // one note for all three
        } else {
          // The wave systems of a sum have the keys of a sea of one system.
          const std::string of_items = path == "environment.waves.sum" ? "environment.waves" : path + "[]";
          for (const Value& x : v.items) visit(x, of_items);
        }
        return;
      case Value::Kind::scalar:
        if (v.schema->type == Key::Type::number) number(v, *v.schema, path, v.where);
        return;
      case Value::Kind::null:
      case Value::Kind::packed:
        return;
    }
  }

 private:
  void number(const Value& v, const Key& key, const std::string& path, const std::string& where) {
    if (key.unit == Dimension::angle && written_in_radians(v))
      add_warning(out_, where, Effect::all,
                  "{} deg is small; if radians are meant, which is {:.4g} deg, write '{} rad'", v.text,
                  parse_quantity(v.text, Dimension::none).si * 180 / M_PI, v.text);
    const auto range =
        std::find_if(kRanges.begin(), kRanges.end(), [&](const Range& r) { return r.path == path; });
    if (range == kRanges.end() || v.number == 0) return;
    const double size = std::abs(v.number);
    if (size >= range->lower && size <= range->upper) return;
    const auto fits = [&](double si) { return std::abs(si) >= range->lower && std::abs(si) <= range->upper; };
    std::string hint = frequency_hint(v, range->quantities, fits);
    if (hint.empty()) hint = unit_hint(v, key.unit, fits);
    out_.push_back(
        {where,
         fmt::format(
             "{} is {} {}, {}{}{}", plain(v) ? in_unit(v.number, key.unit) : v.text,
             size < range->lower ? "below" : "above", range->quantities,
             range->lower > 0 ? fmt::format("{} to ", in_unit(range->lower, Dimension::none)) : "at most ",
             in_unit(range->upper, key.unit), hint),
         std::string(range->quantities), Effect::all});
  }

  std::vector<InputWarning>& out_;
};

}  // namespace

std::string unit_hint(const Value& v, Dimension d, FunctionRef<bool(double)> fits) {
  if (!plain(v)) return "";
  for (const Unit& u : units_of(d)) {
    const Quantity q = parse_quantity(fmt::format("{} {}", v.text, u.name), d);
    if (u.name != units_of(d).front().name && q.status == Quantity::Status::ok && fits(q.si))
      return fmt::format("; is it in {}? ('{} {}')", u.name, v.text, u.name);
  }
  return "";
}

std::string unit_hint(const Case& c, const std::vector<std::string>& keys, FunctionRef<bool(double)> fits) {
  const Entry entry = keys.size() > 1 ? entry_of(c, keys[0], keys[1]) : Entry();
  const Value* v = entry ? &*entry : nullptr;
  for (std::size_t i = 2; i < keys.size(); ++i) v = v ? v->find(keys[i]) : nullptr;
  return v && v->kind == Value::Kind::scalar && v->schema ? unit_hint(*v, v->schema->unit, fits) : "";
}

bool possible(const Waves& waves) {
  const auto row = [](const WaveSystem::Row& r) {
    return r.height <= kHighestWave && r.period >= kShortest && r.period <= kLongestComponent;
  };
  return std::all_of(waves.systems.begin(), waves.systems.end(), [&](const WaveSystem& w) {
    if (w.irregular())
      return w.height <= kHighestSea && w.peak_period >= kShortest && w.peak_period <= kLongestSea;
    return std::all_of(w.rows.begin(), w.rows.end(), row);
  });
}

void warn_of_ranges(const Case& c, std::vector<InputWarning>& out) {
  if (c.tree) Walk(out).visit(*c.tree, "");
  if (!c.farm) return;
  for (const FarmPart& part : c.farm->parts) {
    if (const Value* types = part.tree->find("line_types")) Walk(out).visit(*types, "line_types");
    for (const char* kind : kPlaced) {
      const std::size_t before = out.size();
      if (const Value* objects = part.tree->find(kind)) Walk(out).visit(*objects, kind);
      for (std::size_t i = before; i < out.size(); ++i)
        out[i].key = placed_key(part.places.front(), out[i].key);
    }
  }
}

}  // namespace hawser::advice
