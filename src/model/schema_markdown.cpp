// Key tables of the user guide, generated from the schema.
#include <fmt/format.h>

#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::model {
namespace {

using Type = Key::Type;

constexpr const char* kHeader =
    R"(# Keys of a case file

What every key means, with its unit and default. The user guide (How to write a case file) shows how they go together.
Units are SI. A bare number is in the unit shown; another unit may follow the number, as in `850 mm`, `10 kN` or
`3.5 deg` (see [units](#units)). **needed** means that the key must be given. `[]` after a key marks the items of a
list.
)";

std::string bounds(const Key& k) {
  const double f = k.unit == Dimension::angle ? 180 / 3.14159265358979323846 : 1;
  std::string s;
  if (k.bounds.above) s += fmt::format(" > {:g}", *k.bounds.above * f);
  if (k.bounds.at_least) s += fmt::format(" ≥ {:g}", *k.bounds.at_least * f);
  if (k.bounds.at_most) s += fmt::format("{} ≤ {:g}", s.empty() ? "" : ",", *k.bounds.at_most * f);
  return s;
}

std::string value_text(const Key& k);

std::string list_text(const Key& k) {
  std::string items = value_text(k.keys[0]);
  if (items.starts_with("number")) items = fmt::format("numbers{}", items.substr(6));
  if (items.starts_with("name from")) items = fmt::format("names from{}", items.substr(9));
  if (items.starts_with("list of")) items = fmt::format("lists of{}", items.substr(7));
  if (items.starts_with("3 numbers")) items = fmt::format("lists of {}", items);
  if (items == "keys") items = "maps";
  if (k.max_items > 1 && k.max_items == k.min_items) return fmt::format("list of {} {}", k.max_items, items);
  if (k.max_items > 1 && k.min_items > 1)
    return fmt::format("list of {} to {} {}", k.min_items, k.max_items, items);
  if (k.min_items > 1) return fmt::format("list of at least {} {}", k.min_items, items);
  return fmt::format("list of {}", items);
}

std::string value_text(const Key& k) {
  switch (k.type) {
    case Type::number:
      return fmt::format("number{}", bounds(k));
    case Type::integer:
      return k.bounds.at_least && k.bounds.at_least == k.bounds.at_most
                 ? fmt::format("{:g}", *k.bounds.at_least)
                 : fmt::format("integer{}", bounds(k));
    case Type::boolean:
      return "`true` or `false`";
    case Type::word: {
      std::vector<std::string> words;
      for (const std::string& w : k.words) words.push_back(fmt::format("`{}`", w));
      return enumerate(words);
    }
    case Type::text:
      return "text";
    case Type::name:
      return "name";
    case Type::reference:
      return fmt::format("name from `{}`", k.refers);
    case Type::vec3:
      return fmt::format("3 numbers{}", bounds(k));
    case Type::list:
      return list_text(k);
    case Type::map:
      return "keys";
    case Type::map_by_name:
      return "names";
    case Type::one_of: {
      std::vector<std::string> parts;
      for (const Key& a : k.keys) parts.push_back(value_text(a));
      return enumerate(parts);
    }
  }
  return {};
}

std::string unit_text(const Key& k) {
  if (k.type == Type::number || k.type == Type::vec3)
    return k.unit == Dimension::none ? "" : std::string(base_unit(k.unit));
  if (k.type == Type::one_of || k.type == Type::list)
    for (const Key& a : k.keys)
      if (const std::string u = unit_text(a); !u.empty()) return u;
  return "";
}

std::string default_text(const Key& k) {
  if (k.required) return "**needed**";
  if (!k.fallback_note.empty()) return k.fallback_note;
  if (!k.fallback) return "";
  if (k.fallback->empty() || *k.fallback == "[]" || *k.fallback == "{}") return "";
  return fmt::format("`{}`", *k.fallback);
}

std::string groups_text(const Key& k) {
  if (k.groups.empty()) return "";
  std::vector<std::string> parts;
  for (const Group& g : k.groups) {
    std::vector<std::string> keys;
    for (const std::string& key : g.needed.empty() ? g.keys : g.needed)
      keys.push_back(fmt::format("`{}`", key));
    parts.push_back(enumerate(keys, "and"));
  }
  return fmt::format(" Give {} of {}.", k.group_required ? "one" : "only one", enumerate(parts));
}

std::string groups_below(
    const Key& k) {  // of the map that this key holds, directly or as an alternative or item
  if (k.type == Type::map) return groups_text(k);
  std::string s;
  if (k.type == Type::list || k.type == Type::one_of)
    for (const Key& a : k.keys) s += groups_below(a);
  return s;
}

void rows_below(const Key& k, const std::string& path, std::string& out);

void row(const Key& k, const std::string& path, std::string& out) {
  const std::string groups = groups_below(k);
  const std::string about = k.about + (groups.empty() || k.about.ends_with('.') ? "" : ".") + groups;
  std::string escaped;
  for (const char c : about) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  out += fmt::format("| `{}` | {} | {} | {} | {} |\n", path, value_text(k), unit_text(k), default_text(k),
                     escaped);
  rows_below(k, path, out);
}

void rows_below(const Key& k, const std::string& path, std::string& out) {
  const std::string prefix = path.empty() ? "" : path + ".";
  switch (k.type) {
    case Type::map:
      for (const Key& c : k.keys) row(c, prefix + c.name, out);
      break;
    case Type::list:
      rows_below(k.keys[0], path + "[]", out);
      break;
    case Type::one_of:
      for (const Key& a : k.keys) rows_below(a, path, out);
      break;
    default:
      break;
  }
}

constexpr const char* kTable = "| key | value | unit | default | meaning |\n|---|---|---|---|---|\n";

std::string units_table() {
  std::string s =
      "\n## Units\n\nPowers may be written `m2`, `m^2` or `m²`, and blanks, dots or `·` between factors make "
      "no difference.\nKeys that end in `_deg` take degrees; results and the program inside use rad.\n\n"
      "| quantity | bare number | may be written |\n|---|---|---|\n";
  for (const Dimension d : dimensions()) {
    std::vector<std::string> names;
    for (const Unit& u : units_of(d))
      if (u.name != "1") names.push_back(fmt::format("`{}`", u.name));
    s += fmt::format("| {} | {} | {} |\n", dimension_name(d), base_unit(d), fmt::join(names, ", "));
  }
  return s;
}

}  // namespace

std::string schema_markdown() {
  std::string s = kHeader;
  s += "\n## Top level\n\n";
  s += kTable;
  for (const Key& k : case_schema().keys) {
    const bool own_table = k.type == Type::map || k.type == Type::map_by_name || k.type == Type::one_of;
    const std::string name =
        own_table ? fmt::format("[`{}`](#{})", k.name, k.name) : fmt::format("`{}`", k.name);
    s += fmt::format("| {} | {} | {} | {} | {} |\n", name, value_text(k), unit_text(k), default_text(k),
                     k.about);
  }
  for (const Key& k : case_schema().keys) {
    if (k.type != Type::map && k.type != Type::map_by_name && k.type != Type::one_of) continue;
    s += fmt::format("\n## {}\n\n{}{}\n\n", k.name, k.about, groups_below(k));
    s += kTable;
    if (k.type == Type::map_by_name) {
      rows_below(k.keys[0], k.keys[0].name, s);
    } else {
      rows_below(k, "", s);
    }
  }
  return s + units_table();
}

}  // namespace hawser::model
