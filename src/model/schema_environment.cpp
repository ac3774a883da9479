// Keys of the sea, the seabed and the hydrodynamic properties of lines.
#include <cmath>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

// Uniform current with one speed.
void uniform(Current& c, const Value& v) { c.profile = {{0, v.number, 0}}; }

// Field of a single wave.
Field only(double Waves::Row::*field) {
  return by<Waves>([field](Waves& w, const Value& v) {
    w.rows.resize(1);
    w.rows.front().*field = v.number;
  });
}

void friction_in_statics(Seabed& b, const Value& v) {
  b.full = v.is("full");
  b.as_laid = !v.is("none");
}

// Rows of time and factor of a flow.
Key time_factor(const std::string& of) {
  return map(
      "time_factor",
      {text("file",
            "text file beside the case: columns t [s] and factor; blanks or commas between, `#` starts "
            "a comment"),
       rows("rows", "the same, written here: `[[t, factor], ...]`", items(2))},
      "multiplies the " + of +
          ", below 0 turning it round, beside `ramp`: straight lines between rows, constant beyond "
          "them; in statics what it is at t = 0",
      either({"file", "rows"}), or_else_note("1 at all times"));
}

Key current() {
  return map(
      {"current", within(&Environment::water, &Water::current)},
      {number({"speed", by<Current>(uniform)}, velocity,
              "the same at all depths, or at the surface of a power law", at_least(0)),
       number("direction_deg", angle,
              "where it goes to, anticlockwise from +x; of a `profile` that of rows that give none",
              or_else("0")),
       number({"exponent", &Current::exponent}, none,
              "of the power law speed (1 - depth/water depth)^exponent, say 1/7", above(0), at_most(10),
              or_else_note("none: the same at all depths")),
       list({"profile", &Current::profile},
            map("", {number({"depth", &CurrentRow::depth}, length, "below the still water", at_least(0),
                            required),
                     number({"speed", &CurrentRow::speed}, velocity, "there", at_least(0), required),
                     number({"direction_deg", &CurrentRow::direction}, angle,
                            "where it goes to, anticlockwise from +x", or_else_note("that of `current`"))}),
            "instead: rows downwards, straight lines between them, constant beyond the ends", items(1)),
       number({"ramp", &Current::ramp}, time,
              "starts smoothly over this time in dynamics; 0: acts in statics already", at_least(0),
              or_else("0")),
       time_factor("current")},
      "current; needs `water`", either({{{"speed", "exponent"}, {"speed"}}, "profile"}));
}

Key water() {
  return map({"water", &Environment::water, set(&Environment::water, &Water::present, true)},
             {number({"density", &Water::density}, density, "density", above(0), or_else("1025")),
              number({"depth", &Water::depth}, length, "of the still water", above(0),
                     or_else_note("that of `seabed`")),
              number({"surface", &Water::surface}, length, "z of the still water", or_else("0"))},
             "the sea; without it lines hang in air");
}

// Keys common to all spectra.
std::vector<Key> component_keys() {
  return {number({"direction_deg", &Waves::direction}, angle, "where they go to, anticlockwise from +x",
                 or_else("0")),
          integer({"seed", &Waves::seed},
                  "of phases and frequencies: the same sea on any machine and any number of ranks",
                  in_range(0, 1e9), or_else("1")),
          integer({"components", &Waves::count}, "how many waves it is made of", in_range(1, 20000),
                  or_else("200")),
          number({"spreading", &Waves::spreading}, none,
                 "exponent s of cos^2s of half the angle off the direction; 0: long-crested",
                 in_range(0, 1000), or_else("0"))};
}

std::vector<Key> spectrum_keys(bool peaked) {
  std::vector<Key> keys = {
      number({"hs", &Waves::height, set(&Waves::kind, Waves::Kind::spectrum)}, length,
             "significant wave height", above(0), required),
      number({"tp", &Waves::peak_period}, time, "period of the spectrum's peak", above(0), required)};
  for (Key& k : component_keys()) keys.push_back(std::move(k));
  if (peaked)
    keys.push_back(number({"gamma", &Waves::gamma}, none, "peakedness", in_range(1, 10), or_else("3.3")));
  return keys;
}

Key spectrum() {
  std::vector<Key> keys = {
      text("file",
           "text file beside the case: columns frequency and density; blanks or commas between, `#` starts a "
           "comment"),
      rows("rows", "the same, written here: `[[frequency, density], ...]`", items(2)),
      word("frequency", {{"hz", 2 * M_PI}, {"rad_s", 1}},
           "what the columns are in: Hz and m²/Hz, or rad/s and m² s/rad", or_else("hz"))};
  for (Key& k : component_keys()) keys.push_back(std::move(k));
  return map("spectrum", std::move(keys), "irregular sea of a spectrum by rows, straight lines between them",
             either({"file", "rows"}));
}

Key stokes() {
  return map("stokes",
             {number({"height", only(&Waves::Row::height), set(&Waves::kind, Waves::Kind::stokes)}, length,
                     "from trough to crest", above(0), required),
              number({"period", only(&Waves::Row::period)}, time, "at a fixed place", above(0), required),
              number({"direction_deg", only(&Waves::Row::direction)}, angle,
                     "where it goes to, anticlockwise from +x", or_else("0")),
              number({"phase_deg", only(&Waves::Row::phase)}, angle,
                     "a crest is where k x - omega t + phase = 0", or_else("0")),
              number({"current", &Waves::current}, velocity,
                     "uniform, along the wave (against it: negative): the wave rides on it, and its water "
                     "moves with it; not `current` of the environment once more",
                     or_else("0")),
              word({"current_is", &Waves::transport}, {{"euler", false}, {"transport", true}},
                   "what `current` is: the mean velocity at a place under the troughs, or the mean over the "
                   "depth of what is carried along (0: nothing is, as in a closed tank)",
                   or_else("euler"))},
             "one wave of finite height by Stokes' theory of fifth order (Fenton 1985)");
}

Key waves() {
  const auto one = [] {
    return std::vector<Key>{
        number({"height", &Waves::Row::height}, length, "from trough to crest", above(0), required),
        number({"period", &Waves::Row::period}, time, "period", above(0), required),
        number({"direction_deg", &Waves::Row::direction}, angle, "where it goes to, anticlockwise from +x",
               or_else("0")),
        number({"phase_deg", &Waves::Row::phase}, angle, "elevation = height/2 cos(k x - omega t + phase)",
               or_else("0"))};
  };
  return map(
      {"waves", within(&Environment::water, &Water::waves)},
      {map({"regular", by<Waves>([](Waves& w, const Value& v) {
              w.kind = Waves::Kind::regular;
              take(v, w.rows.emplace_back());
            })},
           one(), "one linear (Airy) wave"),
       map("jonswap", spectrum_keys(true), "irregular sea, Hasselmann et al. 1973"),
       map("pierson_moskowitz", spectrum_keys(false), "irregular, fully developed sea"), spectrum(),
       list({"components", &Waves::rows, set(&Waves::kind, Waves::Kind::components)}, map("", one()),
            "given linear waves", items(1)),
       stokes(),
       word(
           {"stretching", &Waves::stretching},
           {{"wheeler", Stretching::wheeler}, {"vertical", Stretching::vertical}, {"none", Stretching::none}},
           "what linear theory is taken for above the still water: its profile stretched to the surface, "
           "what it is at the still water, or nothing",
           or_else("wheeler")),
       number({"ramp", &Waves::ramp}, time, "they grow smoothly over this time", at_least(0),
              or_else_note("the (longest or peak) period"))},
      "waves; they act in dynamics only, and need `water`",
      either({"regular", "jonswap", "pierson_moskowitz", "spectrum", "components", "stokes"}));
}

Key wind() {
  return map({"wind", &Environment::wind, set(&Environment::wind, &Wind::present, true)},
             {number({"speed", &Wind::speed}, velocity, "mean of an hour at `height`", at_least(0), required),
              number({"direction_deg", &Wind::direction}, angle, "where it goes to, anticlockwise from +x",
                     or_else("0")),
              number({"height", &Wind::height}, length, "above the still water, of `speed`", above(0),
                     or_else("10")),
              number({"exponent", &Wind::exponent}, none, "of the power law speed (z/height)^exponent",
                     at_least(0), at_most(1), or_else_note("1/7")),
              number({"density", &Wind::density}, density, "of the air", above(0), or_else("1.225")),
              number({"ramp", &Wind::ramp}, time,
                     "starts smoothly over this time in dynamics; 0: acts in statics already", at_least(0),
                     or_else("0")),
              time_factor("wind"),
              map("gusts",
                  {word({"spectrum", &Wind::gusts}, {{"iso", GustSpectrum::iso}, {"api", GustSpectrum::api}},
                        "ISO 19901-1 (NPD), or API RP 2A of 1993", required),
                   integer({"components", &Wind::components}, "how many frequencies they are made of",
                           in_range(1, 20000), or_else("200")),
                   integer({"seed", &Wind::seed},
                           "of phases and frequencies: the same gusts on any machine and any number of ranks",
                           in_range(0, 1e9), or_else("1")),
                   number({"ramp", &Wind::gust_ramp}, time, "they grow smoothly over this time", at_least(0),
                          or_else("60"))},
                  "speed that varies along the wind, the same at all places, in dynamics")},
             "wind: it acts on floating bodies with `wind` coefficients");
}

Key seabed() {
  return map(
      {"seabed", &Environment::seabed, set(&Environment::seabed, &Seabed::present, true)},
      {number({"depth", &Seabed::depth}, length, "of the bed below z = 0, at x = y = 0; negative above it",
              or_else_note("that of `water`")),
       number({"slope_deg", &Seabed::slope}, angle, "how steep it is", in_range(0, M_PI / 3), or_else("0")),
       number({"slope_direction_deg", &Seabed::direction}, angle,
              "where it goes down to, anticlockwise from +x", or_else("0")),
       map("grid",
           {text("file",
                 "text file beside the case: rows x, y, z [m], one for every x and every y, in any order; "
                 "blanks or commas between, `#` starts a comment",
                 required),
            boolean("depths", "z counts downwards from z = 0 and not upwards", or_else("false"))},
           "instead: a bed through measured heights, by a bicubic spline"),
       map("mesh",
           {text("file", "STL, OBJ or PLY file beside the case, an open sheet with one height at each place",
                 required),
            number("scale", none, "metres a unit of the file", above(0), or_else("1")),
            boolean("smooth", "curve the facets, so that the bed has no kinks", or_else("true")),
            number("crease_angle_deg", angle, "edges sharper than this stay", in_range(0, M_PI),
                   or_else("40"))},
           "instead: a bed of triangles; beyond its edge there is none"),
       map("normal_stiffness",
           {number({"per_length", &Seabed::normal_stiffness, set(&Seabed::basis, StiffnessBasis::per_length)},
                   line_stiffness, "per length of line", above(0)),
            number({"per_area", &Seabed::normal_stiffness, set(&Seabed::basis, StiffnessBasis::per_area)},
                   area_stiffness, "per projected area (length times contact diameter)", above(0)),
            force_rows(by<Seabed>(force_table<Seabed>)),
            word({"per", &Seabed::basis},
                 {{"length", StiffnessBasis::per_length}, {"area", StiffnessBasis::per_area}},
                 "what the forces of the table are of: N/m of line, N/m² of projected area")},
           "of the soil against penetration; without it 100 kN/m³",
           either({"per_length", "per_area", {{"table", "per"}, {"table", "per"}}})),
       number({"damping", &Seabed::damping}, none,
              "of the soil, in the unit of `normal_stiffness` times s; with a table it is that where the "
              "table is steepest, and goes with its slope",
              at_least(0), or_else("0")),
       number({"smoothing", &Seabed::smoothing}, length, "half width of the smooth start of the soil's force",
              at_least(0), or_else_note("a fifth of what the line at rest sinks in")),
       map("suction",
           {number({"limit", &Seabed::suction}, none,
                   "largest pull, in the unit of `normal_stiffness` times m", above(0), required),
            number({"length", &Seabed::suction_length}, length, "how far above its deepest place it lets go",
                   above(0), required)},
           "pull of the soil in dynamics on what is lifted out of it: 16 limit s²(1 - s)², s the lift over "
           "`length`; it takes hold again of what goes deeper or lands anew"),
       friction(&Seabed::friction),
       word({"friction_in_statics", by<Seabed>(friction_in_statics)}, {"as_laid", "full", "none"},
            "friction at rest: `as_laid`, it acts from where the line was laid without tension from its "
            "anchor "
            "(from its start shape, where the case gives one on the bed from end to end); `full`, likewise, "
            "but "
            "the smallest slip mobilises it, whatever the mobilisation length; `none`, in dynamics only",
            or_else("as_laid"))},
      "what lines lie on: level, sloping, or of a grid or mesh",
      at_most_one({{{"depth", "slope_deg", "slope_direction_deg"}, {}}, "grid", "mesh"}));
}

}  // namespace

Key environment() {
  return map({"environment", &Case::environment},
             {number({"gravity", &Environment::gravity}, acceleration, "acts along -z", at_least(0),
                     or_else("9.80665")),
              water(), current(), waves(), wind(), seabed()},
             "Surroundings.", or_else("{}"));
}

std::vector<Key> in_water() {
  return {
      number({"displaced_diameter", &LineType::displaced_diameter}, length,
             "of the volume that displaces water", above(0), or_else_note("`outer_diameter`")),
      number({"drag_diameter", &LineType::drag_diameter}, length, "that drag is computed with", above(0),
             or_else_note("`outer_diameter`")),
      number({"Cd_normal", &LineType::Cd_normal}, none,
             "drag coefficient across the line, on the drag diameter", in_range(0, 100), or_else("1.2")),
      number({"Cd_axial", &LineType::Cd_axial}, none,
             "drag coefficient along the line, on the skin: pi times the drag diameter", in_range(0, 100),
             or_else("0")),
      number({"Ca_normal", &LineType::Ca_normal}, none,
             "added mass coefficient across the line; the inertia coefficient is 1 + Ca", in_range(0, 100),
             or_else("1")),
      number({"Ca_axial", &LineType::Ca_axial}, none, "added mass coefficient along the line",
             in_range(0, 100), or_else("0")),
      map("contents",
          {number({"inner_diameter", &LineType::inner_diameter}, length, "of the bore", above(0),
                  or_else_note("that of `pipe`; else needed")),
           one_of("density",
                  {number({"", &LineType::contents_density}, density, at_least(0)), word("", {"flooded"})},
                  "of what fills it; `flooded`: the water of the sea", required),
           number({"pressure", &LineType::contents_pressure}, pressure,
                  "above the atmosphere, at the still water level", or_else("0"))},
          "what is in the bore: its mass is added to `mass_per_length`"),
      map("marine_growth",
          {number("thickness", length, "all round", above(0), required),
           number("density", density, "of the growth, in air", above(0), or_else("1325"))},
          "adds to the mass, to the displaced diameter and to the drag diameter")};
}

}  // namespace hawser::model::schema_build
