// Values of a case file that a restart must not change, and the tree of a case file reduced to what a run
// needs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::model {
namespace {

using Type = Key::Type;

}  // namespace

std::string value_text(const Value& v) {
  if (v.kind == Value::Kind::scalar) {
    const Type type = v.schema ? v.schema->type : Type::number;
    const bool is_number = type == Type::number || type == Type::integer || type == Type::boolean;
    return is_number ? fmt::format("{}", v.number) : v.text;
  }
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < v.items.size(); ++i)
    parts.push_back((v.keys.empty() ? "" : v.keys[i] + ": ") + value_text(*Entry(v, i)));
  if (!v.keys.empty()) std::sort(parts.begin(), parts.end());
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

namespace {

void collect(const Value& v, const Key& key, std::map<std::string, std::string>& to) {
  if (key.fixed_in_restart) {
    to[v.where] = value_text(v);
  } else if (!v.schema) {
    return;  // an entry of lines or bodies, of which without_values() has left the lines in the file
  } else if (key.type == Type::one_of) {
    collect(v, *v.schema, to);
  } else if (key.type == Type::map_by_name || key.type == Type::list) {
    for (std::size_t i = 0; i < v.items.size(); ++i) collect(*Entry(v, i), key.keys[0], to);
  } else if (key.type == Type::map) {
    for (const Key& k : key.keys)
      if (const Value* item = v.find(k.name)) collect(*item, k, to);
  }
}

}  // namespace

namespace {

// The key of an item of a list or a map with this key; null: it has none.
const Key* key_of(const Value& v, std::size_t item, const Key* key) {
  if (!key || key->keys.empty()) return nullptr;
  if (key->type == Type::map_by_name || key->type == Type::list) return &key->keys[0];
  if (key->type != Type::map) return nullptr;
  const auto at =
      std::find_if(key->keys.begin(), key->keys.end(), [&](const Key& k) { return k.name == v.keys[item]; });
  return at == key->keys.end() ? nullptr : &*at;
}

bool has_fixed_keys(const Key& key) {
  return key.fixed_in_restart || std::any_of(key.keys.begin(), key.keys.end(), has_fixed_keys);
}

// line: in which the nearest entry around v is. nullopt: nothing of v is read.
std::optional<Value> reduced(const Value& v, const Key* key, int line) {
  if (v.kind == Value::Kind::packed) return reduced(unpacked(v), key, line);
  if (key && key->fixed_in_restart) return v;
  if (key && key->type == Type::one_of) return reduced(v, v.schema, line);
  const bool placed = v.given && v.line != 0;
  const int item_line = placed ? v.line : line;
  Value out;
  out.kind = v.kind;
  out.line = v.line;
  out.given = v.given;
  out.schema = v.schema;
  const bool in_order = v.kind == Value::Kind::list;  // items of a list are found by their numbers
  // Packed entries have no schema until they are checked, which only fixed keys need.
  const bool checked = key && key->type == Type::map_by_name && has_fixed_keys(key->keys[0]);
  bool any = false;
  out.items.reserve(v.items.size());
  if (!in_order) out.keys.reserve(v.items.size());
  for (std::size_t i = 0; i < v.items.size(); ++i) {
    const Value& entry = v.items[i];
    std::optional<Value> item = reduced(checked ? *Entry(v, i) : entry, key_of(v, i, key), item_line);
    any |= item.has_value();
    if (!in_order && !item) continue;
    out.items.push_back(item ? std::move(*item) : Value());
    if (!in_order) out.keys.push_back(v.keys[i]);
  }
  if (item_line == line && !any) return std::nullopt;
  if (!any) out.items.clear();
  out.items.shrink_to_fit();
  out.keys.shrink_to_fit();
  if (!any) return out;
  const bool names = key && key->type == Type::map_by_name;
  if (names && std::all_of(out.items.begin(), out.items.end(),
                           [](const Value& x) { return x.kind == Value::Kind::map && x.items.empty(); }))
    pack(out);
  return out;
}

}  // namespace

Value without_values(const Value& v) {
  Value out = reduced(v, v.schema, 0).value_or(Value());
  out.line = v.line;
  out.schema = v.schema;
  return out;
}

std::map<std::string, std::string> fixed_values(const Value& v) {
  std::map<std::string, std::string> out;
  collect(v, *v.schema, out);
  return out;
}

}  // namespace hawser::model
