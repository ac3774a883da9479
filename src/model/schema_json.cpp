// JSON Schema (draft 2020-12) of a case file, for completion and checks in editors.
#include <fmt/format.h>

#include <cstdlib>

#include "hawser/model/json_string.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::model {
namespace {

using Type = Key::Type;

// Writes lines of a JSON object or array, indented by two blanks per level.
class Writer {
 public:
  void open(char bracket) {
    put(std::string(1, bracket));
    ++depth_;
    first_ = true;
  }
  void open(std::string_view name, char bracket) {
    put(json_string(name) + ": " + bracket);
    ++depth_;
    first_ = true;
  }
  void close(char bracket) {
    --depth_;
    text_ += first_ ? std::string(1, bracket) : fmt::format("\n{}{}", indent(), bracket);
    first_ = false;
  }
  // `json` is written verbatim.
  void item(const std::string& json) { put(json); }
  void member(std::string_view name, const std::string& json) { put(json_string(name) + ": " + json); }
  std::string take() { return std::move(text_) + "\n"; }

 private:
  void put(const std::string& s) {
    if (!text_.empty()) text_ += (first_ ? "\n" : ",\n") + indent();
    text_ += s;
    first_ = false;
  }
  std::string indent() const { return std::string(2 * static_cast<std::size_t>(depth_), ' '); }

  std::string text_;
  int depth_ = 0;
  bool first_ = true;
};

std::string array(const std::vector<std::string>& words) {
  std::string s = "[";
  for (const std::string& w : words) s += (s.size() > 1 ? ", " : "") + json_string(w);
  return s + "]";
}

std::string definition(Dimension d) {
  std::string name(dimension_name(d));
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
}

std::string literal(const std::string& s) {  // default as JSON
  if (s == "true" || s == "false" || s == "{}" || s == "[]") return s;
  char* end = nullptr;
  std::strtod(s.c_str(), &end);
  if (!s.empty() && *end == '\0') return s;
  if (s.starts_with('[')) {
    std::vector<std::string> items;
    std::string item;
    for (const char c : s.substr(1)) {
      if (c == ',' || c == ']') {
        items.push_back(literal(item));
        item.clear();
      } else if (c != ' ') {
        item += c;
      }
    }
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
  return json_string(s);
}

void members(const Key& k, Writer& w);

void object(const Key& k, Writer& w) {
  w.open('{');
  members(k, w);
  w.close('}');
}

void number_members(const Key& k, Writer& w) {
  // A bare number has bounds; a number with unit is checked only in form.
  std::string n = "{\"type\": \"number\"";
  if (k.unit != Dimension::angle) {
    if (k.bounds.above) n += fmt::format(", \"exclusiveMinimum\": {:g}", *k.bounds.above);
    if (k.bounds.at_least) n += fmt::format(", \"minimum\": {:g}", *k.bounds.at_least);
    if (k.bounds.at_most) n += fmt::format(", \"maximum\": {:g}", *k.bounds.at_most);
  }
  w.open("anyOf", '[');
  w.item(n + "}");
  w.item(fmt::format("{{\"$ref\": \"#/$defs/{}\"}}", definition(k.unit)));
  w.close(']');
}

void list_limits(const Key& k, Writer& w) {
  if (k.min_items > 0) w.member("minItems", fmt::format("{}", k.min_items));
  if (k.max_items > 0) w.member("maxItems", fmt::format("{}", k.max_items));
}

// At most one complete group of keys.
void group_members(const Key& k, Writer& w) {
  if (k.groups.empty()) return;
  const auto any_of = [](const std::vector<std::string>& keys) {
    std::vector<std::string> each;
    for (const std::string& key : keys)
      each.push_back(fmt::format("{{\"required\": [{}]}}", json_string(key)));
    return fmt::format("{{\"anyOf\": [{}]}}", fmt::join(each, ", "));
  };
  std::vector<std::string> all;
  w.open("oneOf", '[');
  for (const Group& g : k.groups) {
    std::vector<std::string> others;
    for (const Group& o : k.groups)
      if (&o != &g) others.insert(others.end(), o.keys.begin(), o.keys.end());
    all.insert(all.end(), g.keys.begin(), g.keys.end());
    std::string s = "{";
    s += g.needed.empty() ? any_of(g.keys).substr(1, any_of(g.keys).size() - 2)
                          : fmt::format("\"required\": {}", array(g.needed));
    if (!others.empty()) s += fmt::format(", \"not\": {}", any_of(others));
    w.item(s + "}");
  }
  if (!k.group_required) w.item(fmt::format("{{\"not\": {}}}", any_of(all)));
  w.close(']');
}

void map_members(const Key& k, Writer& w) {
  w.member("type", "\"object\"");
  w.open("properties", '{');
  std::vector<std::string> required;
  for (const Key& c : k.keys) {
    w.open(c.name, '{');
    members(c, w);
    w.close('}');
    if (c.required) required.push_back(c.name);
  }
  w.close('}');
  if (!required.empty()) w.member("required", array(required));
  w.member("additionalProperties", "false");
  group_members(k, w);
}

void members(const Key& k, Writer& w) {
  std::string about = k.about;
  if (k.unit != Dimension::none) about += fmt::format("{}[{}]", about.empty() ? "" : " ", base_unit(k.unit));
  if (!k.fallback_note.empty())
    about += fmt::format("{}(default: {})", about.empty() ? "" : " ", k.fallback_note);
  if (!about.empty()) w.member("description", json_string(about));
  if (k.fallback) w.member("default", literal(*k.fallback));
  switch (k.type) {
    case Type::number:
      number_members(k, w);
      break;
    case Type::integer:
      w.member("type", "\"integer\"");
      if (k.bounds.at_least) w.member("minimum", fmt::format("{:.0f}", *k.bounds.at_least));
      if (k.bounds.at_most) w.member("maximum", fmt::format("{:.0f}", *k.bounds.at_most));
      break;
    case Type::boolean:
      w.member("type", "\"boolean\"");
      break;
    case Type::word:
      w.member("enum", array(k.words));
      break;
    case Type::text:
      w.member("type", "[\"string\", \"number\", \"boolean\"]");
      break;
    case Type::name:
    case Type::reference:
      w.member("$ref", "\"#/$defs/name\"");
      break;
    case Type::vec3: {
      w.member("type", "\"array\"");
      Key number;
      number.type = Type::number;
      number.unit = k.unit;
      number.bounds = k.bounds;
      w.open("items", '{');
      number_members(number, w);
      w.close('}');
      w.member("minItems", "3");
      w.member("maxItems", "3");
      break;
    }
    case Type::list:
      w.member("type", "\"array\"");
      w.open("items", '{');
      members(k.keys[0], w);
      w.close('}');
      list_limits(k, w);
      break;
    case Type::map:
      map_members(k, w);
      break;
    case Type::map_by_name:
      w.member("type", "\"object\"");
      w.open("patternProperties", '{');
      w.open(name_pattern(), '{');
      members(k.keys[0], w);
      w.close('}');
      w.close('}');
      w.member("additionalProperties", "false");
      if (k.min_items > 0) w.member("minProperties", fmt::format("{}", k.min_items));
      break;
    case Type::one_of:
      w.open("anyOf", '[');
      for (const Key& a : k.keys) object(a, w);
      w.close(']');
      break;
  }
}

// Regular expression of a number as text, with or without a unit of the dimension.
std::string quantity_pattern(Dimension d) {
  std::string units;
  for (const Unit& u : units_of(d)) {
    std::string text;
    for (const char c : u.name) {
      if (c == '^') continue;  // m2, m^2 and m² are handled below
      if (c == '2' || c == '3')
        text += fmt::format("(\\\\^?{}|{})", c, c == '2' ? "²" : "³");
      else if (c == 'm' && !text.empty() &&
               std::string_view("Nfgt").find(text.back()) != std::string_view::npos)
        text += "[ .·*]?m";
      else if (c == 's' && text.find('N') != std::string::npos)
        text += "[ .·*]?s";
      else
        text += c;
    }
    if (u.name != "1") units += (units.empty() ? "" : "|") + text;
  }
  const std::string number = "([0-9]+\\\\.?[0-9]*|\\\\.[0-9]+)([eE][+-]?[0-9]+)?";
  if (d == Dimension::none) units += "|/" + number;
  return fmt::format("\"^ *[+-]?{} *({})? *$\"", number, units);
}

}  // namespace

std::string schema_json() {
  Writer w;
  w.open('{');
  w.member("$schema", "\"https://json-schema.org/draft/2020-12/schema\"");
  w.member("title", "\"hawser case file\"");
  w.member("$comment",
           "\"Written by 'hawser schema --json' from the schema in the code; don't edit by hand. Names that "
           "refer to names, sense and meshes are only checked by 'hawser check'.\"");
  members(case_schema(), w);
  w.open("$defs", '{');
  w.member("name", "{\"type\": [\"string\", \"integer\"]}");
  for (const Dimension d : dimensions()) {
    w.member(definition(d), fmt::format("{{\"type\": \"string\", \"pattern\": {}}}", quantity_pattern(d)));
  }
  w.close('}');
  w.close('}');
  return w.take();
}

}  // namespace hawser::model
