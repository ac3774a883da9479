// `line_types`: from the library, from the case, or from both; a pipe, or by weights (case_reader_pipe.cpp).
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "hawser/io/case_reader_parts.hpp"
#include "hawser/io/line_library.hpp"

namespace hawser::io {
namespace {

using model::Value;

std::shared_ptr<const ResponseCurve> read_stiffness_table(const Value& table, const std::string& key,
                                                          bool odd, const CaseSource& source) {
  std::vector<ResponseCurve::Row> rows;
  for (const Value& r : table.items) rows.emplace_back(r.items[0].number, r.items[1].number);
  try {
    return std::make_shared<const ResponseCurve>(rows, odd);
  } catch (const std::invalid_argument& e) {
    source.bad(table, key, e.what());
  }
}

void read_plasticity(const Value& v, const std::string& path, const CaseSource& source, model::LineType& t) {
  constexpr double kStrain = 0.05;  // of the outer fibre: to where a curve is needed
  constexpr int kRows = 21;         // 20 yield circles: within 0.5 % of the curve
  if (!v.has("plasticity")) return;
  const Value& p = v["plasticity"];
  const std::string key = path + ".plasticity";
  const bool curve = p.has("ramberg_osgood");
  if (curve == p.has("table")) source.bad(p, key, "needs either 'ramberg_osgood' or 'table'");
  if (t.moment_table || t.GA > 0 || t.EI2 != t.EI3)
    source.bad(
        p, key,
        fmt::format("cannot be combined with {}; remove one of them", t.moment_table ? "a table of EI"
                                                                      : t.GA > 0     ? "GA"
                                                                                     : "two values of EI"));
  std::vector<PlasticBending::Row> rows;
  if (curve) {
    const Value& c = p["ramberg_osgood"];
    const double last = 2 * kStrain / t.outer_diameter, yield = c["yield_moment"].number / t.EI2;
    if (!(last > yield))
      source.bad(
          c["yield_moment"], key + ".ramberg_osgood.yield_moment",
          fmt::format("is reached at a curvature of {:.3g} 1/m only, beyond {:g} % of strain; is it in N m?",
                      yield, 100 * kStrain));
    rows = ramberg_osgood(t.EI2, c["yield_moment"].number, c["A"].number, c["B"].number, last, kRows);
  } else {
    for (const Value& r : p["table"].items) rows.emplace_back(r.items[0].number, r.items[1].number);
  }
  try {
    t.plastic_bending = std::make_shared<const PlasticBending>(rows);
  } catch (const std::invalid_argument& e) {
    source.bad(p[curve ? "ramberg_osgood" : "table"], key + (curve ? ".ramberg_osgood" : ".table"), e.what());
  }
  const double slope = t.plastic_bending->initial();
  if (!curve && std::abs(slope - t.EI2) > 0.05 * t.EI2)
    source.bad(
        p["table"], key + ".table",
        fmt::format("its first row makes EI {:.4g} N m2, but the type has {:.4g}; they must agree to 5 %",
                    slope, t.EI2));
  t.EI2 = t.EI3 = slope;
}

void read_bending(const Value& v, const std::string& path, const CaseSource& source, model::LineType& t) {
  t.GA = v["GA"].number;
  if (v.has("pipe")) return read_plasticity(v, path, source, t);
  for (const char* key : {"EI", "GJ"})
    if (!v.has(key))
      source.bad(
          v, path + "." + key,
          "required key is missing; a type that resists bending needs EI and GJ (a type that doesn't says "
          "'bending: false')");
  const Value& EI = v["EI"];
  t.GJ = v["GJ"].number;
  if (EI.kind == Value::Kind::map) {
    t.moment_table = read_stiffness_table(EI["table"], path + ".EI.table", true, source);
    t.EI2 = t.EI3 = t.moment_table->initial();
    if (t.GA > 0)
      source.bad(v["GA"], path + ".GA", "cannot be combined with a table of moments; remove one of them");
  } else {
    t.EI2 = EI.kind == Value::Kind::list ? EI.items[0].number : EI.number;
    t.EI3 = EI.kind == Value::Kind::list ? EI.items[1].number : EI.number;
  }
  read_plasticity(v, path, source, t);
  const double round = t.mass_per_length * t.outer_diameter * t.outer_diameter / 8;  // m r² / 2
  t.rotary_inertia =
      v.has("rotary_inertia") ? as_vec3(v["rotary_inertia"]) : Vec3(round, round / 2, round / 2);
}

}  // namespace

model::LineType read_line_type(const std::string& name, const Value& v, const CaseSource& source,
                               const model::Environment& sea) {
  const std::string path = "line_types." + name;
  model::LineType t;
  const bool known = v.has("library");
  if (v.has("pipe"))
    read_pipe(v, path, source, sea.seabed.surface != nullptr, t);
  else if (v.has("weight"))
    read_weight(v, path, source, sea.gravity, t);
  if (known) {
    t = library_line_type(v, path, source);
  } else if (!v.has("pipe")) {
    for (const char* key : {"diameter", "grade"})
      if (v.has(key)) source.bad(v[key], path + "." + key, "has a meaning with 'library' only");
    for (const char* key : {"outer_diameter", "mass_per_length", "EA"})
      if (!v.has(key) && !(v.has("weight") && std::string_view(key) == "mass_per_length"))
        source.bad(v, path + "." + key,
                   "required key is missing: a type that is no 'pipe' and not from the 'library' needs "
                   "outer_diameter, mass_per_length (or weight) and EA");
  }
  t.name = name;
  if (v.has("bending")) t.kind = v["bending"].number != 0 ? model::LineKind::beam : model::LineKind::cable;
  const auto take = [&v](const char* key, double& x) {
    const Value* k = v.find(key);
    if (k && k->given) x = k->number;
    return k && k->given;
  };
  if (take("outer_diameter", t.outer_diameter)) t.contact_diameter = t.outer_diameter;
  take("contact_diameter", t.contact_diameter);
  take("mass_per_length", t.mass_per_length);
  take("breaking_load", t.breaking_load);
  take("minimum_bend_radius", t.minimum_bend_radius);
  take("thermal_expansion", t.thermal_expansion);
  if (v.has("EA")) {
    const Value& EA = v["EA"];
    if (EA.kind == Value::Kind::map) {
      t.tension_table = read_stiffness_table(EA["table"], path + ".EA.table", false, source);
      t.EA = t.tension_table->initial();
    } else {
      t.EA = EA.number;
    }
  }
  read_in_water(v, path, source, sea.water, t);
  take("stiffness_damping", t.stiffness_damping);
  if (t.kind == model::LineKind::beam) {
    read_bending(v, path, source, t);
    return t;
  }
  for (const char* key : {"EI", "GJ", "GA", "rotary_inertia", "plasticity"})
    if (v.has(key) && v[key].given)
      source.bad(
          v[key], path + "." + key,
          known && !v.has("bending")
              ? "has no meaning for a type of the library, which does not resist bending; say 'bending: "
                "true' as well"
              : "has no meaning for a type with 'bending: false'; remove one of them");
  return t;
}

void read_bend_stiffener(const Value& v, const std::string& path, double at, double length,
                         const CaseSource& source, model::Line& line) {
  model::BendStiffener b;
  b.at = at;
  b.towards_a = v.has("towards") ? v["towards"].is("end_a") : v["at"].is("end_b");
  const Value& rows = v["EI"];
  for (std::size_t i = 0; i < rows.items.size(); ++i) {
    const double d = rows.items[i].items[0].number, k = rows.items[i].items[1].number;
    const std::string key = fmt::format("{}.EI[{}]", path, i);
    if (!(d >= 0) || (i > 0 && !(d > b.rows.back().first)))
      source.bad(rows.items[i], key,
                 i > 0 ? fmt::format("rows go away from the root, but {:g} m comes after {:g} m", d,
                                     b.rows.back().first)
                       : fmt::format("{:g} m is before the root", d));
    if (!(k >= 0)) source.bad(rows.items[i], key, fmt::format("{:g} N m² would soften the line", k));
    b.rows.emplace_back(d, k);
  }
  const double tip = b.towards_a ? at - b.rows.back().first : at + b.rows.back().first;
  if (tip < -1e-9 * length || tip > length * (1 + 1e-9))
    source.bad(rows, path + ".EI", fmt::format("reaches to {:g} m of a line of {:g} m", tip, length));
  line.bend_stiffeners.push_back(std::move(b));
}

void read_temperature_change(const Value& v, const std::string& path, const CaseSource& source,
                             model::Line& line) {
  if (v.kind != Value::Kind::list) {
    if (v.number != 0) line.temperature_change = {{0, v.number}};
    return;
  }
  for (std::size_t i = 0; i < v.items.size(); ++i) {
    const double s = v.items[i].items[0].number;
    if (i > 0 && !(s > line.temperature_change.back().first))
      source.bad(v.items[i], fmt::format("{}[{}]", path, i),
                 fmt::format("rows go from end A on, but {:g} m comes after {:g} m", s,
                             line.temperature_change.back().first));
    line.temperature_change.emplace_back(s, v.items[i].items[1].number);
  }
}

}  // namespace hawser::io
