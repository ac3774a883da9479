// `line_types`: from the library, from the case, or both; pipes and types by weight: case_reader_pipe.cpp.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "hawser/io/case_values.hpp"
#include "hawser/io/line_library.hpp"

namespace hawser::io {
namespace {

using model::refuse;
using model::refuse_key;
using model::Value;

void read_plasticity(const Value& v, model::LineType& t) {
  constexpr double kStrain = 0.05;  // of the outer fibre: range of the curve
  constexpr int kRows = 21;         // 20 yield circles: within 0.5 % of the curve
  if (!v.has("plasticity")) return;
  const Value& p = v["plasticity"];
  const bool curve = p.has("ramberg_osgood");
  if (curve == p.has("table")) refuse(p, "needs either 'ramberg_osgood' or 'table'");
  if (t.moment_table || t.GA > 0 || t.EI2 != t.EI3)
    refuse(p, "cannot be combined with {}; remove one of them",
           t.moment_table ? "a table of EI"
           : t.GA > 0     ? "GA"
                          : "two values of EI");
  std::vector<PlasticBending::Row> rows;
  if (curve) {
    const Value& c = p["ramberg_osgood"];
    const double last = 2 * kStrain / t.outer_diameter;
    const double yield = c["yield_moment"].number / t.EI2;
    if (!(last > yield))
      refuse(c["yield_moment"],
             "is reached at a curvature of {:.3g} 1/m only, beyond {:g} % of strain; is it in N m?", yield,
             100 * kStrain);
    rows = ramberg_osgood(t.EI2, c["yield_moment"].number, c["A"].number, c["B"].number, last, kRows);
  } else {
    rows = p["table"].rows();
  }
  try {
    t.plastic_bending = std::make_shared<const PlasticBending>(rows);
  } catch (const std::invalid_argument& e) {
    refuse(p[curve ? "ramberg_osgood" : "table"], e.what());
  }
  const double slope = t.plastic_bending->initial();
  if (!curve && v.has("EI") && std::abs(slope - t.EI2) > 0.05 * t.EI2)
    refuse(p["table"], "its first row makes EI {:.4g} N m2, but the type has {:.4g}; they must agree to 5 %",
           slope, t.EI2);
  t.EI2 = t.EI3 = slope;
}

void finish_bending(const Value& v, model::LineType& t) {
  if (v.has("pipe")) return read_plasticity(v, t);
  const bool stiffness_by_table = v.has("plasticity") && v["plasticity"].has("table");
  for (const char* key : {"EI", "GJ"})
    if (!v.has(key) && !(stiffness_by_table && std::string_view(key) == "EI"))
      refuse_key(v, v.where + "." + key,
                 "required key is missing; a type that resists bending needs EI and GJ (otherwise set "
                 "'bending: false')");
  if (t.moment_table && t.GA > 0)
    refuse(v["GA"], "cannot be combined with a table of moments; remove one of them");
  read_plasticity(v, t);
  const double round = t.mass_per_length * t.outer_diameter * t.outer_diameter / 8;  // m r² / 2
  if (!v.has("rotary_inertia")) t.rotary_inertia = Vec3(round, round / 2, round / 2);
}

}  // namespace

model::LineType read_line_type(const std::string& name, const Value& v, const model::Environment& sea) {
  model::LineType t;
  const bool known = v.has("library");
  if (v.has("pipe"))
    read_pipe(v, sea.seabed.surface != nullptr, t);
  else if (v.has("weight"))
    read_weight(v, sea.gravity, t);
  if (known) {
    t = library_line_type(v);
  } else if (!v.has("pipe")) {
    for (const char* key : {"diameter", "grade"})
      if (v.has(key)) refuse(v[key], "applies with 'library' only; remove it");
    for (const char* key : {"outer_diameter", "mass_per_length", "EA"})
      if (!v.has(key) && !(v.has("weight") && std::string_view(key) == "mass_per_length"))
        refuse_key(v, v.where + "." + key,
                   "required key is missing: a type that is no 'pipe' and not from the 'library' needs "
                   "outer_diameter, mass_per_length (or weight) and EA");
  }
  t.name = name;
  model::take(v, t, known);  // library values precede defaults
  finish_in_water(v, sea.water, t);
  if (t.kind == model::LineKind::beam) {
    finish_bending(v, t);
    return t;
  }
  for (const char* key : {"EI", "GJ", "GA", "rotary_inertia", "plasticity"})
    if (v.has(key) && v[key].given)
      refuse(v[key], known && !v.has("bending")
                         ? "has no effect for a type of the library, which does not resist bending; set "
                           "'bending: true' as well"
                         : "has no effect for a type with 'bending: false'; remove one of them");
  return t;
}

}  // namespace hawser::io
