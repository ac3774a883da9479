// Keys of the schema in words: what values they take, and where in the schema a name is.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::model {
namespace {

using Type = Key::Type;

std::string in_unit(Dimension d) { return d == Dimension::none ? "" : fmt::format(" [{}]", base_unit(d)); }

std::string plural(std::string s) {  // "a number [m]" -> "numbers [m]"
  if (s.starts_with("a number")) return "numbers" + s.substr(8);
  if (s.starts_with("the name of an entry")) return "names of entries" + s.substr(20);
  return s;
}

}  // namespace

std::string describe(const Key& k) {
  switch (k.type) {
    case Type::number:
      return "a number" + in_unit(k.unit);
    case Type::integer:
      return "an integer";
    case Type::boolean:
      return "true or false";
    case Type::word: {
      std::vector<std::string> quoted;
      for (const std::string& w : k.words) quoted.push_back("'" + w + "'");
      return enumerate(quoted);
    }
    case Type::text:
      return "text";
    case Type::name:
      return "a name";
    case Type::reference:
      return "the name of an entry of " + k.refers;
    case Type::vec3:
      return "a list of 3 numbers" + in_unit(k.unit);
    case Type::list: {
      std::string of = plural(describe(k.keys[0]));
      if (of.starts_with("a map")) of = "maps" + of.substr(5);
      if (of.starts_with("a list")) of = "lists" + of.substr(6);
      if (k.max_items > 0 && k.max_items == k.min_items)
        return fmt::format("a list of {} {}", k.min_items, of);
      if (k.max_items > 0) return fmt::format("a list of {} to {} {}", k.min_items, k.max_items, of);
      if (k.min_items == 1) return "a list of one or more " + of;
      if (k.min_items > 0) return fmt::format("a list of at least {} {}", k.min_items, of);
      return "a list of " + of;
    }
    case Type::map: {
      std::vector<std::string> names;
      for (const Key& c : k.keys) names.push_back(c.name);
      return fmt::format("a map with the keys {}", fmt::join(names, ", "));
    }
    case Type::names:
      return "a map of names";
    case Type::one_of: {
      std::vector<std::string> parts;
      for (const Key& a : k.keys) parts.push_back(describe(a));
      return enumerate(parts);
    }
  }
  return {};
}

std::string place_below(const Key& key, std::string_view name) {
  struct Place {
    const Key* key;
    std::string path;
  };
  const auto same = [&](std::string_view other) {
    return std::equal(other.begin(), other.end(), name.begin(), name.end(), [](char a, char b) {
      return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    });
  };
  std::vector<Place> level{{&key, ""}};
  for (int depth = 0; depth < 6 && !level.empty(); ++depth) {
    std::vector<Place> next;
    for (const Place& p : level)
      for (const Key& k : p.key->keys) {
        if (p.key->type == Type::one_of) {
          next.push_back({&k, p.path});
        } else if (p.key->type == Type::list) {
          next.push_back({&k, p.path + "[0]"});
        } else if (p.key->type == Type::map) {
          const std::string path = p.path + (p.path.empty() ? "" : ".") + k.name;
          if (depth > 0 && same(k.name)) return path;
          next.push_back({&k, path});
        }
      }
    level = std::move(next);
  }
  return "";
}

}  // namespace hawser::model
