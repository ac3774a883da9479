// Line types of the library: look-up by name and grade, polynomials in the nominal diameter, and the page of
// the user guide with these formulas.
#include "hawser/io/line_library.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "hawser/io/yaml_document.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {

extern const char* const kLineLibrary;

namespace {

using model::refuse;
using model::refuse_key;
using model::Value;

const Value& library() {
  static const Value root = parse_yaml(kLineLibrary, "line-types.yaml");
  return root;
}

double as_number(const Value& v) {
  double x = 0;
  const auto [end, error] = std::from_chars(v.text.data(), v.text.data() + v.text.size(), x);
  if (error != std::errc() || end != v.text.data() + v.text.size())
    throw std::logic_error("line-types.yaml: '" + v.text + "' is no number");
  return x;
}

// A number, or the polynomial given by a map of powers.
double value(const Value& v, double d, double breaking_load) {
  if (v.kind != Value::Kind::map) return as_number(v);
  double sum = 0;
  for (std::size_t i = 0; i < v.items.size(); ++i) {
    const double a = as_number(v.items[i]);
    const std::string& k = v.keys[i];
    sum += a * (k == "d" ? d : k == "d2" ? d * d : k == "d3" ? d * d * d : breaking_load);
  }
  return sum;
}

// Text of a formula: "19900 d²", "44e9 d² - 80e9 d³", "14 MBL".
std::string formula(const Value& v) {
  if (v.kind != Value::Kind::map) return v.text;
  std::string s;
  for (std::size_t i = 0; i < v.items.size(); ++i) {
    const double a = as_number(v.items[i]);
    const std::string& k = v.keys[i];
    const char* reference = k == "d" ? "d" : k == "d2" ? "d²" : k == "d3" ? "d³" : "MBL";
    if (i > 0) s += a < 0 ? " - " : " + ";
    const double size = i > 0 ? std::abs(a) : a;
    s += size == 1 ? reference : fmt::format("{:g} {}", size, reference);
  }
  return s;
}

}  // namespace

std::vector<std::string> line_library_names() { return library().keys; }

model::LineType library_line_type(const Value& v) {
  const std::string& name = v["library"].text;
  const std::vector<std::string> names = line_library_names();
  const Value* entry = library().find(name);
  if (!entry)
    refuse(v["library"], model::quote(name) + " is not in the library" + model::did_you_mean(name, names) +
                             " (there are " + model::enumerate(names, "and") + ")");
  if (!v.has("diameter"))
    refuse_key(v, v.where + ".diameter", "required key is missing: the nominal diameter of " + name);
  const double d = v["diameter"].number;
  double strength = 1;
  if (const Value* grades = entry->find("grades")) {
    const std::string known = model::enumerate(grades->keys);
    if (!v.has("grade")) refuse_key(v, v.where + ".grade", "required key is missing: " + known);
    const std::string& grade = v["grade"].text;
    const Value* g = grades->find(grade);
    if (!g)
      refuse(v["grade"], model::quote(grade) + " is no grade of " + name +
                             model::did_you_mean(grade, grades->keys) + " (" + known + ")");
    strength = as_number(*g);
  } else if (v.has("grade")) {
    refuse(v["grade"], name + " has no grades; remove it");
  }
  model::LineType t;
  t.kind = model::LineKind::cable;
  t.breaking_load = strength * value((*entry)["breaking_load"], d, 0);
  const auto property_of_entry = [&](const char* property) {
    return value((*entry)[property], d, t.breaking_load);
  };
  t.outer_diameter = property_of_entry("outer_diameter");
  t.contact_diameter =
      entry->has("contact_diameter") ? property_of_entry("contact_diameter") : t.outer_diameter;
  t.displaced_diameter =
      entry->has("displaced_diameter") ? property_of_entry("displaced_diameter") : t.outer_diameter;
  t.drag_diameter = property_of_entry("drag_diameter");
  t.mass_per_length = property_of_entry("mass_per_length");
  t.EA = property_of_entry("EA");
  t.Cd_normal = property_of_entry("Cd_normal");
  t.Cd_axial = property_of_entry("Cd_axial");
  t.Ca_normal = property_of_entry("Ca_normal");
  t.Ca_axial = property_of_entry("Ca_axial");
  if (!(t.breaking_load > 0) || !(t.EA > 0))
    refuse(v["diameter"],
           "{:g} m is beyond what the formulas of {} are made for (the diameter is in m, or with its unit: "
           "84 mm)",
           d, name);
  return t;
}

std::string line_library_markdown() {
  std::string s =
      "<!-- Written by `hawser library` from data/line-types.yaml; don't edit by hand. -->\n"
      "# Line types library\n\n"
      "Chains and ropes by their nominal diameter, for early design: means over catalogues, from published "
      "formulas.\nManufacturers' data take precedence: a key that the case gives itself replaces the value "
      "of the library.\n\n"
      "```yaml\nline_types:\n  chain: {library: chain-studless, diameter: 84 mm, grade: R4}\n"
      "  rope: {library: polyester, diameter: 210 mm, EA: 190 MN}\n```\n\n"
      "All are cables (`bending: false`), unless the case sets `bending: true` and gives `EI` and `GJ`. d is "
      "the nominal\ndiameter in m, of a chain that of its bar; MBL the minimum breaking load in N. Cd axial "
      "acts on the skin, π times\nthe drag diameter.\n\n"
      "| `library` | mass kg/m | EA N | MBL N | outer diameter | contact diameter | displaced diameter | "
      "drag diameter | Cd normal | Cd axial | Ca normal | Ca axial "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  const Value& all = library();
  for (std::size_t i = 0; i < all.items.size(); ++i) {
    const Value& e = all.items[i];
    const auto column = [&e](const char* key, const char* fallback = "outer_diameter") {
      return formula(e.has(key) ? e[key] : e[fallback]);
    };
    const std::string breaks = column("breaking_load");
    s += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", all.keys[i],
                     column("mass_per_length"), column("EA"), e.has("grades") ? "c (" + breaks + ")" : breaks,
                     column("outer_diameter"), column("contact_diameter"), column("displaced_diameter"),
                     column("drag_diameter"), column("Cd_normal"), column("Cd_axial"), column("Ca_normal"),
                     column("Ca_axial"));
  }
  s += "\n| `library` | what it is | source |\n|---|---|---|\n";
  for (std::size_t i = 0; i < all.items.size(); ++i) {
    const Value& e = all.items[i];
    s += fmt::format("| `{}` | {}", all.keys[i], e["about"].text);
    if (const Value* g = e.find("grades")) {
      s += "; c by `grade`:";
      for (std::size_t k = 0; k < g->items.size(); ++k)
        s += fmt::format("{} {} {}", k ? "," : "", g->keys[k], g->items[k].text);
    }
    s += fmt::format(" | {} |\n", e["source"].text);
  }
  return s;
}

}  // namespace hawser::io
