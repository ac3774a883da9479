// Tree of a case file, independent of its format: scalars as text, lists, maps in file order. io parses YAML
// into it; the schema checks it, fills in defaults and converts numbers to SI.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::model {

struct Key;

struct Value {
  // packed: an entry of `lines` or `bodies` as bytes in `text` (packed_value.hpp).
  enum class Kind { null, scalar, list, map, packed };

  Kind kind = Kind::null;
  std::string text;     // scalar as written
  bool quoted = false;  // scalar in quotes
  int line = 0;         // line in the file, from 1; of the key for values of a map
  bool given = true;    // false: a default that the schema filled in
  // Set by the schema check (check_structure):
  double number = 0;              // SI, for numbers, integers and booleans; for words their meaning
  std::string where;              // dotted: "lines.hose.sections[0].length"
  const Key* schema = nullptr;    // key that it was checked against; of alternatives the matching one
  std::vector<Value> items;       // of a list; or the values of a map
  std::vector<std::string> keys;  // of a map, as many as items

  const Value* find(std::string_view key) const;        // null if this is no map or has no such key
  const Value& operator[](std::string_view key) const;  // throws std::out_of_range
  bool has(std::string_view key) const { return find(key) != nullptr; }
  bool is(std::string_view word) const { return kind == Kind::scalar && text == word; }
  std::vector<std::pair<double, double>> rows() const;  // for a list of lists of two numbers

  // Line of a dotted key such as "lines.hose.sections[0].length", or of its nearest existing ancestor.
  int line_of(std::string_view path) const;
};

}  // namespace hawser::model
