// Line types by construction or weight: pipes by walls and coatings, hoses and umbilicals by the weights of
// their data sheets.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "hawser/io/case_values.hpp"

namespace hawser::io {
namespace {

using model::refuse;
using model::Value;

struct Material {
  double E, density, poisson;  // Pa, kg/m³, -
};
// Steel: DNV-ST-F101 (2021), 5.3 and 13. Titanium: grade 5 and 23 (Ti-6Al-4V), ASM Handbook vol. 2. HDPE:
// PE 4710 at 23 °C under loads of minutes, Plastics Pipe Institute, Handbook of PE Pipe (2008), ch. 3.
constexpr std::array<std::pair<std::string_view, Material>, 3> kMaterials = {
    {{"steel", {207e9, 7850, 0.3}}, {"titanium", {114e9, 4430, 0.34}}, {"hdpe", {0.9e9, 955, 0.45}}}};

Material material(const Value& v) {
  if (v.kind == Value::Kind::map) return {v["E"].number, v["density"].number, v["poisson"].number};
  for (const auto& [name, m] : kMaterials)
    if (v.is(name)) return m;
  return kMaterials.front().second;
}

// Area and polar second moment of a ring of inner and outer diameter d, D [m].
double area(double d, double D) { return M_PI / 4 * (D - d) * (D + d); }
double polar(double d, double D) { return area(d, D) / 8 * (D * D + d * d); }

void only(const Value& v, const char* given_key, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (const Value* k = v.find(key); k && k->given)
      refuse(*k, "'{}' already defines it; remove one of them", given_key);
}

// Properties for pipe code checks; unused without a grade.
void read_strength(const Value& p, const Material& m, bool uneven, model::LineType& t) {
  if (!p.has("grade")) {
    for (const char* key : {"safety_class", "fabrication", "ovality", "material_factor", "condition_factor"})
      if (const Value* k = p.find(key); k && k->given)
        refuse(*k, "is of the checks by codes, which need the 'grade' of the steel as well");
    return;
  }
  PipeSteel s;
  s.outer = p["outer_diameter"].number;
  s.wall = p["wall_thickness"].number;
  s.modulus = m.E;
  s.poisson = m.poisson;
  for (const PipeGrade& g : kPipeGrades)
    if (p["grade"].is(g.name)) {
      s.smys = g.smys;
      s.smts = g.smts;
    }
  s.safety_class = p["safety_class"].is("low") ? 1.04 : p["safety_class"].is("medium") ? 1.14 : 1.26;
  s.cold_expanded = p["fabrication"].is("UOE");
  s.fabrication = s.cold_expanded ? 0.85 : p["fabrication"].is("UO") ? 0.93 : 1;
  s.ovality = p["ovality"].number;
  s.material_factor = p["material_factor"].number;
  t.steel = s;
  constexpr double kUneven = 1.07;  // DNV-ST-F101 table 4-5
  if (uneven) t.conditions.seabed = kUneven;
}

}  // namespace

void read_pipe(const Value& v, bool uneven_bed, model::LineType& t) {
  only(v, "pipe",
       {"library", "diameter", "grade", "weight", "outer_diameter", "mass_per_length", "displaced_diameter",
        "EA", "EI", "GJ", "rotary_inertia"});
  const Value& p = v["pipe"];
  const double D = p["outer_diameter"].number;
  const double wall = p["wall_thickness"].number;
  const double d = D - 2 * wall;
  if (!(d > 0))
    refuse(p["wall_thickness"], "a wall of {:g} m fills the pipe of {:g} m; it must be below half of that",
           wall, D);
  const Material m = material(p["material"]);
  t.EA = m.E * area(d, D);
  t.EI2 = t.EI3 = m.E * polar(d, D) / 2;
  t.GJ = m.E / (2 * (1 + m.poisson)) * polar(d, D);
  t.mass_per_length = m.density * area(d, D);
  double inertia = m.density * polar(d, D);
  double outside = D;
  for (const Value& layer : p["coatings"].items) {
    const double next = outside + 2 * layer["thickness"].number;
    const double density = layer["density"].number;
    t.mass_per_length += density * area(outside, next);
    inertia += density * polar(outside, next);
    outside = next;
  }
  t.rotary_inertia = Vec3(inertia, inertia / 2, inertia / 2);
  t.outer_diameter = t.contact_diameter = outside;
  t.wall_diameter = D;
  t.inner_diameter = d;
  read_strength(p, m, uneven_bed, t);
}

void read_weight(const Value& v, double gravity, model::LineType& t) {
  only(v, "weight", {"library", "diameter", "grade", "mass_per_length", "displaced_diameter"});
  const Value& w = v["weight"];
  const double air = w["in_air"].number;
  const double submerged = w["submerged"].number;
  // Mass from weight uses standard gravity if the case has none.
  const double g = gravity > 0 ? gravity : 9.80665;
  if (!(air > submerged))
    refuse(
        w["submerged"],
        "{:g} N/m is not less than the weight in air of {:g} N/m, so that the line would displace no water",
        submerged, air);
  t.mass_per_length = air / g;
  t.displaced_diameter = std::sqrt(4 / M_PI * (air - submerged) / (g * w["water_density"].number));
  if (const Value* outer = v.find("outer_diameter"); outer && t.displaced_diameter > 1.02 * outer->number)
    refuse(w["submerged"],
           "with {:g} N/m in air and {:g} N/m under water the line displaces as much as a cylinder of {:.4g} "
           "m, but its outer_diameter is {:g} m",
           air, submerged, t.displaced_diameter, outer->number);
  const Value* contents = v.find("contents");
  const Value* bore = contents ? contents->find("inner_diameter") : nullptr;
  if (!w.has("full_of") || !bore) return;
  t.mass_per_length -= w["full_of"].number * area(0, bore->number);
  if (!(t.mass_per_length > 0))
    refuse(*bore, "what fills a bore of {:g} m weighs more than the line full of it, {:g} N/m", bore->number,
           air);
}

}  // namespace hawser::io
