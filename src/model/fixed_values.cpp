// Values of a case file that must not change in a restart from a checkpoint.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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
    parts.push_back((v.keys.empty() ? "" : v.keys[i] + ": ") + value_text(v.items[i]));
  if (!v.keys.empty()) std::sort(parts.begin(), parts.end());
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

namespace {

void collect(const Value& v, const Key& key, std::map<std::string, std::string>& to) {
  if (key.fixed_in_restart) {
    to[v.where] = value_text(v);
  } else if (key.type == Type::one_of) {
    collect(v, *v.schema, to);
  } else if (key.type == Type::names || key.type == Type::list) {
    for (const Value& item : v.items) collect(item, key.keys[0], to);
  } else if (key.type == Type::map) {
    for (const Key& k : key.keys)
      if (const Value* item = v.find(k.name)) collect(*item, k, to);
  }
}

}  // namespace

std::map<std::string, std::string> fixed_values(const Value& v) {
  std::map<std::string, std::string> out;
  collect(v, *v.schema, out);
  return out;
}

}  // namespace hawser::model
