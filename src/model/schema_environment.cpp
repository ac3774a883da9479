// Keys of the sea, the seabed and the hydrodynamic properties of lines.
#include <cmath>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

// Uniform current with one speed.
void uniform(Current& c, const Value& v) { c.profile = {{0, v.number, 0}}; }

// Field of a single wave.
Field only(double WaveSystem::Row::*field) {
  return set_by<WaveSystem>([field](WaveSystem& w, const Value& v) {
    w.rows.resize(1);
    w.rows.front().*field = v.number;
  });
}

void friction_in_statics(Seabed& b, const Value& v) {
  b.full = v.is("full");
  b.as_laid = !v.is("none");
}

// Rows of time and factor of a flow.
Key time_factor(const std::string& quantity) {
  return map(
      "time_factor",
      {text("file",
            "text file beside the case: columns t [s] and factor; blanks or commas between, `#` starts "
            "a comment"),
       rows("rows", "the same as a list in the case: `[[t, factor], ...]`", items(2))},
      "factor of the " + quantity +
          " against time, negative for the opposite direction, applied in addition to `ramp`: linear between "
          "rows, constant outside them; statics takes the value at t = 0",
      either({"file", "rows"}), or_else_note("1 at all times"));
}

Key current() {
  return map(
      {"current", within(&Environment::water, &Water::current)},
      {number({"speed", set_by<Current>(uniform)}, velocity,
              "speed at all depths, or at the surface for a power law", at_least(0)),
       number(
           "direction_deg", angle,
           "direction in which it flows, anticlockwise from +x; in a `profile` for rows without a direction",
           or_else("0")),
       number({"exponent", &Current::exponent}, none,
              "exponent of the power law speed (1 - depth/water depth)^exponent, for example 1/7", above(0),
              at_most(10), or_else_note("none: uniform over the depth")),
       list({"profile", &Current::profile},
            map("", {number({"depth", &CurrentRow::depth}, length, "below the still water level", at_least(0),
                            required),
                     number({"speed", &CurrentRow::speed}, velocity, "speed at this depth", at_least(0),
                            required),
                     number({"direction_deg", &CurrentRow::direction}, angle,
                            "direction in which it flows, anticlockwise from +x",
                            or_else_note("direction of `current`"))}),
            "rows by increasing depth, in place of `speed`: linear between rows, constant outside them",
            items(1)),
       number({"ramp", &Current::ramp}, time,
              "starts smoothly over this time in dynamics; 0: acts in statics as well", at_least(0),
              or_else("0")),
       time_factor("current")},
      "current; needs `water`", either({{{"speed", "exponent"}, {"speed"}}, "profile"}));
}

Key water() {
  return map({"water", &Environment::water, set(&Environment::water, &Water::present, true)},
             {number({"density", &Water::density}, density, "density", above(0), or_else("1025")),
              number({"depth", &Water::depth}, length, "depth of the still water", above(0),
                     or_else_note("depth of `seabed`")),
              number({"surface", &Water::surface}, length, "z of the still water level", or_else("0"))},
             "the sea; without it lines are in air");
}

// Fields of the key of a wave system, whatever its kind.
Field wave_system(WaveSystem::Kind kind) {
  return set_by<WaveSystem>([kind](WaveSystem& w, const Value& v) {
    w.kind = kind;
    w.key = v.where;
  });
}

// Keys common to all spectra.
std::vector<Key> component_keys() {
  return {
      number({"direction_deg", &WaveSystem::direction}, angle,
             "direction in which they travel, anticlockwise from +x", or_else("0")),
      integer({"seed", &WaveSystem::seed},
              "seed of phases and frequencies: the same sea on any machine and any number of ranks",
              in_range(0, 1e9), or_else("1")),
      integer({"components", &WaveSystem::count}, "number of wave components", in_range(1, 20000),
              or_else("200")),
      number({"spreading", &WaveSystem::spreading}, none,
             "exponent s of the spreading cos^2s of half the angle from the mean direction; 0: long-crested",
             in_range(0, 1000), or_else("0"))};
}

std::vector<Key> spectrum_keys(bool peaked) {
  std::vector<Key> keys = {
      number({"hs", &WaveSystem::height}, length, "significant wave height", above(0), required),
      number({"tp", &WaveSystem::peak_period}, time, "peak period", above(0), required)};
  for (Key& k : component_keys()) keys.push_back(std::move(k));
  if (peaked)
    keys.push_back(number({"gamma", &WaveSystem::gamma}, none, "peak enhancement factor", in_range(1, 10),
                          or_else("3.3")));
  return keys;
}

Key spectrum() {
  std::vector<Key> keys = {
      text("file",
           "text file beside the case: columns frequency and density; blanks or commas between, `#` starts a "
           "comment"),
      rows("rows", "the same as a list in the case: `[[frequency, density], ...]`", items(2)),
      word("frequency", {{"hz", 2 * M_PI}, {"rad_s", 1}},
           "units of the columns: Hz and m²/Hz, or rad/s and m² s/rad", or_else("hz"))};
  for (Key& k : component_keys()) keys.push_back(std::move(k));
  return map({"spectrum", wave_system(WaveSystem::Kind::table), itself<WaveSystem>()}, std::move(keys),
             "irregular sea by a tabulated spectrum, linear between rows", either({"file", "rows"}));
}

Key stokes() {
  return map(
      {"stokes", wave_system(WaveSystem::Kind::stokes), itself<WaveSystem>()},
      {number({"height", only(&WaveSystem::Row::height)}, length, "from trough to crest", above(0), required),
       number({"period", only(&WaveSystem::Row::period)}, time, "period at a fixed point", above(0),
              required),
       number({"direction_deg", only(&WaveSystem::Row::direction)}, angle,
              "direction in which it travels, anticlockwise from +x", or_else("0")),
       number({"phase_deg", only(&WaveSystem::Row::phase)}, angle,
              "phase: a crest is where k x - omega t + phase = 0", or_else("0")),
       number({"current", &WaveSystem::current}, velocity,
              "uniform current along the wave (negative: against it) on which the wave travels; its velocity "
              "is added to that of the water, so do not give it as `current` of the environment as well",
              or_else("0")),
       word({"current_is", &WaveSystem::transport}, {{"euler", false}, {"transport", true}},
            "definition of `current`: `euler`, the mean velocity at a fixed point below the troughs; "
            "`transport`, the mean mass transport velocity over the depth (0: no net flow, as in a closed "
            "tank)",
            or_else("euler"))},
      "one wave of finite height by Stokes' theory of fifth order (Fenton 1985)");
}

std::vector<Key> wave_systems() {
  using Kind = WaveSystem::Kind;
  const auto one = [] {
    return std::vector<Key>{
        number({"height", &WaveSystem::Row::height}, length, "from trough to crest", above(0), required),
        number({"period", &WaveSystem::Row::period}, time, "period", above(0), required),
        number({"direction_deg", &WaveSystem::Row::direction}, angle,
               "direction in which it travels, anticlockwise from +x", or_else("0")),
        number({"phase_deg", &WaveSystem::Row::phase}, angle,
               "phase: elevation = height/2 cos(k x - omega t + phase)", or_else("0"))};
  };
  return {map({"regular", wave_system(Kind::regular),
               set_by<WaveSystem>([](WaveSystem& w, const Value& v) { take(v, w.rows.emplace_back()); })},
              one(), "one linear (Airy) wave"),
          map({"jonswap", wave_system(Kind::spectrum), itself<WaveSystem>()}, spectrum_keys(true),
              "irregular sea by the JONSWAP spectrum, Hasselmann et al. 1973"),
          map({"pierson_moskowitz", wave_system(Kind::spectrum), itself<WaveSystem>()}, spectrum_keys(false),
              "irregular, fully developed sea by the Pierson-Moskowitz spectrum"),
          spectrum(),
          list({"components", &WaveSystem::rows, wave_system(Kind::components)}, map("", one()),
               "list of linear waves", items(1)),
          stokes()};
}

// A key of a wave system among those of waves that have this system only.
Key alone(Key key) {
  const std::vector<Put> fields = key.fields;
  key.fields = {[fields](const Target& to, const Value& v) {
    WaveSystem& system = to.as<Waves>().systems.emplace_back();
    for (const Put& field : fields) field(system, v);
  }};
  return key;
}

Key waves() {
  std::vector<Group> kinds;
  std::vector<Key> keys;
  for (Key& k : wave_systems()) {
    kinds.push_back(k.name.c_str());
    keys.push_back(alone(std::move(k)));
  }
  keys.push_back(
      list({"sum", &Waves::systems}, map("", wave_systems(), either(kinds)),
           "wave systems whose waves are added, such as wind sea and swell: each entry has one of "
           "the keys above (`stokes`, which is not linear, only alone); systems with the same `seed` "
           "have independent phases",
           items(1)));
  kinds.push_back("sum");
  keys.push_back(
      word({"stretching", &Waves::stretching},
           {{"wheeler", Stretching::wheeler}, {"vertical", Stretching::vertical}, {"none", Stretching::none}},
           "extrapolation of linear wave kinematics above the still water level: `wheeler`, the profile is "
           "stretched to the surface; `vertical`, the values at the still water level; `none`, zero",
           or_else("wheeler")));
  keys.push_back(number({"ramp", &Waves::ramp}, time, "duration over which the waves build up smoothly",
                        at_least(0), or_else_note("the longest period, or the peak period")));
  return map(
      {"waves", within(&Environment::water, &Water::waves)}, std::move(keys),
      "waves; they act in dynamics only and need `water`; the mean drift force of `second_order` acts in "
      "statics too, and in full from t = 0",
      either(kinds));
}

Key wind() {
  return map(
      {"wind", &Environment::wind, set(&Environment::wind, &Wind::present, true)},
      {number({"speed", &Wind::speed}, velocity, "hourly mean speed at `height`", at_least(0), required),
       number({"direction_deg", &Wind::direction}, angle,
              "direction towards which the wind goes, anticlockwise from +x", or_else("0")),
       number({"height", &Wind::height}, length, "height above the still water level at which `speed` holds",
              above(0), or_else("10")),
       number({"exponent", &Wind::exponent}, none, "exponent of the power law speed (z/height)^exponent",
              at_least(0), at_most(1), or_else_note("1/7")),
       number({"density", &Wind::density}, density, "density of the air", above(0), or_else("1.225")),
       number({"ramp", &Wind::ramp}, time,
              "starts smoothly over this time in dynamics; 0: acts in statics as well", at_least(0),
              or_else("0")),
       time_factor("wind"),
       map("gusts",
           {word({"spectrum", &Wind::gusts}, {{"iso", GustSpectrum::iso}, {"api", GustSpectrum::api}},
                 "gust spectrum: `iso`, ISO 19901-1 (NPD); `api`, API RP 2A of 1993", required),
            integer({"components", &Wind::components}, "number of frequency components", in_range(1, 20000),
                    or_else("200")),
            integer({"seed", &Wind::seed},
                    "seed of phases and frequencies: the same gusts on any machine and any number of ranks",
                    in_range(0, 1e9), or_else("1")),
            number({"ramp", &Wind::gust_ramp}, time, "duration over which the gusts build up smoothly",
                   at_least(0), or_else("60"))},
           "fluctuation of the wind speed, the same at all points, in dynamics")},
      "wind: it acts on floating bodies that have `wind` coefficients");
}

Key seabed() {
  return map(
      {"seabed", &Environment::seabed, set(&Environment::seabed, &Seabed::present, true)},
      {number({"depth", &Seabed::depth}, length,
              "depth of the bed below z = 0, at x = y = 0; negative: above z = 0",
              or_else_note("depth of `water`")),
       number({"slope_deg", &Seabed::slope}, angle, "angle of the slope", in_range(0, M_PI / 3),
              or_else("0")),
       number({"slope_direction_deg", &Seabed::direction}, angle, "downhill direction, anticlockwise from +x",
              or_else("0")),
       map("grid",
           {text("file",
                 "text file beside the case: rows x, y, z [m], one for each pair of an x and a y, in any "
                 "order; blanks or commas between, `#` starts a comment",
                 required),
            boolean("depths", "whether z is a depth below z = 0, positive downwards", or_else("false"))},
           "bed by a bicubic spline through measured heights, in place of a plane"),
       map("mesh",
           {text("file",
                 "STL, OBJ or PLY file beside the case: an open surface with one height at each point",
                 required),
            number("scale", none, "metres per unit of the file", above(0), or_else("1")),
            boolean("smooth", "curve the facets, so that the bed has no kinks", or_else("true")),
            number("crease_angle_deg", angle,
                   "edges between facets that differ by more than this angle stay sharp", in_range(0, M_PI),
                   or_else("40"))},
           "bed of triangles, in place of a plane; there is no bed beyond its boundary"),
       map("normal_stiffness",
           {number({"per_length", &Seabed::normal_stiffness, set(&Seabed::basis, StiffnessBasis::per_length)},
                   line_stiffness, "per length of line", above(0)),
            number({"per_area", &Seabed::normal_stiffness, set(&Seabed::basis, StiffnessBasis::per_area)},
                   area_stiffness, "per projected area (length times contact diameter)", above(0)),
            force_rows(set_by<Seabed>(force_table<Seabed>)),
            word({"per", &Seabed::basis},
                 {{"length", StiffnessBasis::per_length}, {"area", StiffnessBasis::per_area}},
                 "unit of the forces in the table: N/m of line, N/m² of projected area")},
           "stiffness of the soil against penetration; without it 100 kN/m³",
           either({"per_length", "per_area", {{"table", "per"}, {"table", "per"}}})),
       number({"damping", &Seabed::damping}, none,
              "damping of the soil, in the unit of `normal_stiffness` times s; with a table it applies where "
              "the table is steepest and is proportional to the slope of the table elsewhere",
              at_least(0), or_else("0")),
       number({"smoothing", &Seabed::smoothing}, length, "half width of the smooth onset of the soil's force",
              at_least(0),
              or_else_note("a fifth of the static penetration of the line, at least 0.2 % of its "
                           "contact radius")),
       map("suction",
           {number({"limit", &Seabed::suction}, none,
                   "largest suction, in the unit of `normal_stiffness` times m", above(0), required),
            number({"length", &Seabed::suction_length}, length,
                   "uplift from the deepest penetration at which the soil releases the line", above(0),
                   required)},
           "suction of the soil on a line that is lifted, in dynamics: 16 limit s²(1 - s)² with s the uplift "
           "over `length`; it acts again after the line penetrates deeper or touches down again"),
       friction(&Seabed::friction),
       word({"friction_in_statics", set_by<Seabed>(friction_in_statics)}, {"as_laid", "full", "none"},
            "friction of the bed in statics: `as_laid`, it acts from the position in which the line was laid "
            "without tension from its anchor (from its start shape, if the case gives one on the bed from "
            "end to end); `full`, the same, but the smallest slip mobilises it, whatever the mobilisation "
            "length; `none`, friction in dynamics only",
            or_else("as_laid"))},
      "the bed on which lines lie: level, sloping, by a grid or by a mesh",
      at_most_one_of({{{"depth", "slope_deg", "slope_direction_deg"}, {}}, "grid", "mesh"}));
}

}  // namespace

Key environment() {
  return map({"environment", &Case::environment},
             {number({"gravity", &Environment::gravity}, acceleration, "acceleration of gravity, along -z",
                     at_least(0), or_else("9.80665")),
              water(), current(), waves(), wind(), seabed()},
             "Water, current, waves, wind, gravity and seabed.", or_else("{}"));
}

std::vector<Key> in_water() {
  return {
      number({"displaced_diameter", &LineType::displaced_diameter}, length,
             "diameter of the displaced volume", above(0), or_else_note("`outer_diameter`")),
      number({"drag_diameter", &LineType::drag_diameter}, length, "reference diameter of the drag", above(0),
             or_else_note("`outer_diameter`")),
      number({"Cd_normal", &LineType::Cd_normal}, none, "transverse drag coefficient, on the drag diameter",
             in_range(0, 100), or_else("1.2")),
      number({"Cd_axial", &LineType::Cd_axial}, none,
             "axial drag coefficient, on the skin area: pi times the drag diameter", in_range(0, 100),
             or_else("0")),
      number({"Ca_normal", &LineType::Ca_normal}, none,
             "transverse added mass coefficient; the inertia coefficient is 1 + Ca", in_range(0, 100),
             or_else("1")),
      number({"Ca_axial", &LineType::Ca_axial}, none, "axial added mass coefficient", in_range(0, 100),
             or_else("0")),
      map("contents",
          {number({"inner_diameter", &LineType::inner_diameter}, length, "diameter of the bore", above(0),
                  or_else_note("that of `pipe`; needed without `pipe`")),
           one_of("density",
                  {number({"", &LineType::contents_density}, density, at_least(0)), word("", {"flooded"})},
                  "density of the contents; `flooded`: that of the sea water", required),
           number({"pressure", &LineType::contents_pressure}, pressure,
                  "gauge pressure at the still water level", or_else("0"))},
          "contents of the bore: their mass is added to `mass_per_length`"),
      map("marine_growth",
          {number("thickness", length, "thickness all around the line", above(0), required),
           number("density", density, "density of the growth, in air", above(0), or_else("1325"))},
          "marine growth, which increases the mass, the displaced diameter and the drag diameter")};
}

}  // namespace hawser::model::schema_build
