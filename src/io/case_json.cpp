// JSON of a case: its tree as written and as read, and its line types.
#include "hawser/io/case_json.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "hawser/model/farm.hpp"
#include "hawser/model/json_string.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {
namespace {

using model::json_string;
using model::Key;
using model::Value;
using Kind = Value::Kind;

// Builder of an array or an object.
class Elements {
 public:
  explicit Elements(char open) : text_(1, open) {}
  void add(const std::string& json) {
    if (text_.size() > 1) text_ += ", ";
    text_ += json;
  }
  void add(std::string_view name, const std::string& json) { add(json_string(name) + ": " + json); }
  std::string closed() { return std::move(text_) + (text_.front() == '[' ? ']' : '}'); }

 private:
  std::string text_;
};

std::string texts(const std::vector<std::string>& words) {
  Elements all('[');
  for (const std::string& w : words) all.add(json_string(w));
  return all.closed();
}

std::string as_given(const Value& v) {
  if (v.kind == Kind::packed) return as_given(model::unpacked(v));
  if (v.kind == Kind::scalar) return json_string(v.text);
  if (v.kind == Kind::null) return "null";
  Elements all(v.kind == Kind::list ? '[' : '{');
  for (std::size_t i = 0; i < v.items.size(); ++i) {
    if (!v.items[i].given) continue;
    if (v.kind == Kind::list)
      all.add(as_given(v.items[i]));
    else
      all.add(v.keys[i], as_given(v.items[i]));
  }
  return all.closed();
}

std::string number(const Value& v, model::Dimension unit) {
  if (unit == model::Dimension::angle) return fmt::format("{:.15g}", v.number * 180 / std::numbers::pi);
  return fmt::format("{}", v.number);
}

std::string as_read(const Value& v);

std::string map_as_read(const Value& v) {
  const bool of_library = v.has("library");
  Elements all('{');
  for (std::size_t i = 0; i < v.items.size(); ++i)
    if (v.items[i].given || !of_library) all.add(v.keys[i], as_read(*model::Entry(v, i)));
  return all.closed();
}

std::string as_read(const Value& v) {
  if (v.kind == Kind::map) return map_as_read(v);
  if (v.kind == Kind::list) {
    Elements all('[');
    for (const Value& item : v.items)
      all.add(v.schema->type == Key::Type::vec3 ? number(item, v.schema->unit) : as_read(item));
    return all.closed();
  }
  switch (v.schema->type) {
    case Key::Type::number:
    case Key::Type::integer:
      return number(v, v.schema->unit);
    case Key::Type::boolean:
      return v.number != 0 ? "true" : "false";
    default:
      return json_string(v.text);
  }
}

std::string properties(const model::LineType& t) {
  const std::pair<const char*, double> numbers[] = {{"outer_diameter", t.outer_diameter},
                                                    {"contact_diameter", t.contact_diameter},
                                                    {"displaced_diameter", t.displaced()},
                                                    {"drag_diameter", t.dragged()},
                                                    {"inner_diameter", t.inner_diameter},
                                                    {"mass_per_length", t.mass_per_length},
                                                    {"EA", t.EA},
                                                    {"EI2", t.EI2},
                                                    {"EI3", t.EI3},
                                                    {"GJ", t.GJ},
                                                    {"GA", t.GA},
                                                    {"stiffness_damping", t.stiffness_damping},
                                                    {"thermal_expansion", t.thermal_expansion},
                                                    {"breaking_load", t.breaking_load},
                                                    {"minimum_bend_radius", t.minimum_bend_radius},
                                                    {"Cd_normal", t.Cd_normal},
                                                    {"Cd_axial", t.Cd_axial},
                                                    {"Ca_normal", t.Ca_normal},
                                                    {"Ca_axial", t.Ca_axial},
                                                    {"contents_density", t.contents_density},
                                                    {"contents_pressure", t.contents_pressure}};
  Elements all('{');
  for (const auto& [name, x] : numbers) all.add(name, fmt::format("{}", x));
  return all.closed();
}

std::string platform(const model::FarmPart& part) {
  Elements all('{');
  all.add("file", json_string(part.given));
  Elements places('{');
  for (const model::FarmPlace& p : part.places)
    places.add(p.name, fmt::format("[{}, {}, {:.15g}]", p.x, p.y, p.heading * 180 / std::numbers::pi));
  all.add("places", places.closed());
  all.add("given", as_given(*part.tree));
  all.add("read", as_read(*part.tree));
  return all.closed();
}

}  // namespace

std::string case_json(const model::Case& c) {
  Elements all('{');
  all.add("file", json_string(c.path));
  all.add("results", json_string(c.output.file));
  all.add("inputs", texts(c.inputs));
  if (c.tree) {
    all.add("given", as_given(*c.tree));
    all.add("read", as_read(*c.tree));
  }
  if (c.farm) {
    Elements parts('[');
    for (const model::FarmPart& part : c.farm->parts) parts.add(platform(part));
    all.add("platforms", parts.closed());
  }
  Elements types('{');
  for (const model::LineType& t : c.line_types) types.add(t.name, properties(t));
  all.add("line_types", types.closed());
  return all.closed();
}

}  // namespace hawser::io
