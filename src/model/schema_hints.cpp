// Hints for messages about faults in a case file: foreign number formats, lists without commas or dashes, and
// misspelt or misplaced keys.
#include "schema_hints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "hawser/model/nearest.hpp"

namespace hawser::model {

using Type = Key::Type;
using Kind = Value::Kind;

// Hint for text after a number that is more likely a part of the number than a unit.
std::string misspelt_number(const std::string& unit) {
  const auto digit = [&](std::size_t i) { return i < unit.size() && unit[i] >= '0' && unit[i] <= '9'; };
  const bool letter = !unit.empty() && std::string_view("eEdD").find(unit[0]) != std::string_view::npos;
  if (unit.starts_with('^') || unit.starts_with("*10") ||
      (letter && (digit(1) || (digit(2) && unit[1] == '+'))))
    return "; a power of ten is written 1e8, without blanks";
  if (digit(0)) return "; there are no blanks between the digits of a number";
  return "";
}

// Hint for a value that is not a list.
std::string hint_of_no_list(const Value& v) {
  if (v.kind == Kind::map) return "; entries of a list begin with '- ', or stand in brackets: [a, b]";
  if (v.kind != Kind::scalar || (!v.text.starts_with('(') && v.text.find(',') == std::string::npos))
    return "";
  return v.line == kBySet ? "; a list stands in brackets, for the shell in quotes: --set 'KEY=[1, 2, 3]'"
                          : "; a list stands in brackets: [1, 2, 3]";
}
// Hint for a list of one entry that needs several.
std::string hint_of_no_commas(const Value& v) {
  const bool one = v.items.size() == 1 && v.items[0].kind == Kind::scalar &&
                   v.items[0].text.find_first_of(" ;") != std::string::npos;
  return one ? fmt::format("; separate entries by commas, not as in {}", quote(v.items[0].text)) : "";
}

// Hint for a key followed by text without a colon; empty: the text begins with no allowed key.
std::string hint_of_no_colon(const std::string& text, const std::vector<std::string>& allowed) {
  const std::size_t blank = text.find(' ');
  const std::string word = text.substr(0, blank);
  if (blank == std::string::npos || std::find(allowed.begin(), allowed.end(), word) == allowed.end())
    return "";
  return fmt::format("; a colon is missing after '{}': '{}: ...'", word, word);
}

// Hint for a value that is not a map.
std::string hint_of_no_keys(const Value& v, const Key& k) {
  if (v.kind == Kind::null) return "; indent its keys further, on the lines below it";
  std::vector<std::string> allowed;
  for (const Key& c : k.keys) allowed.push_back(c.name);
  if (const std::string hint = hint_of_no_colon(v.text, allowed); !hint.empty()) return hint;
  const std::string blank = v.kind == Kind::scalar ? missing_blank(v.text) : "";
  return blank.empty() ? "" : "; " + blank;
}

// Probable meaning of the i-th key, which the schema does not have.
std::string likely_key(const Value& v, std::size_t i, const Key& k, const std::vector<std::string>& allowed) {
  if (v.keys[i].find("\u00a0") != std::string::npos)
    return "; it contains a no-break space (often pasted from another document): replace it by a blank";
  if (const std::string blank = missing_blank(v.keys[i]); !blank.empty()) return "; " + blank;
  if (const std::size_t at = v.keys[i].find('='); at != std::string::npos && at > 0) {
    const std::string before = v.keys[i].substr(0, v.keys[i].find_last_not_of(" =", at) + 1);
    return fmt::format("; write a colon and a blank between a key and its value: '{}: ...'", before);
  }
  if (const std::string hint = hint_of_no_colon(v.keys[i], allowed); !hint.empty()) return hint;
  // Remainder of a number or of a list in parentheses.
  if (i > 0 && v.items[i].kind == Kind::null && v.items[i - 1].kind == Kind::scalar &&
      v.keys[i].find_first_not_of("0123456789.-+ )") == std::string::npos) {
    if (v.items[i - 1].text.starts_with('(')) return "; a list stands in brackets: [1, 2, 3]";
    return fmt::format("; write a decimal point and no separators of thousands: not {},{}",
                       v.items[i - 1].text, v.keys[i]);
  }
  // Keys of an empty map that are not indented below it.
  for (std::size_t j = i; j-- > 0;)
    for (const Key& above : k.keys)
      if (above.name == v.keys[j] && v.items[j].kind == Kind::null)
        for (const Key& inner : above.keys)
          if (inner.name == v.keys[i])
            return fmt::format("; indent it further if it belongs to '{}'", above.name);
  const std::string near = nearest(v.keys[i], allowed);
  if (near.empty() || edit_distance(v.keys[i], near) > 1) {
    if (const std::string below = place_below(k, v.keys[i]); !below.empty())
      return fmt::format("; did you mean '{}'?", below);
    if (const std::string other = near.empty() ? place_below(case_schema(), v.keys[i]) : ""; !other.empty())
      return fmt::format("; there is such a key at '{}'", other);
  }
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

std::string place_below(const Key& key, std::string_view name) {
  struct KeyPath {
    const Key* key;
    std::string path;
  };
  const auto same = [&](std::string_view other) {
    return std::equal(other.begin(), other.end(), name.begin(), name.end(), [](char a, char b) {
      return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    });
  };
  std::vector<KeyPath> level{{&key, ""}};
  for (int depth = 0; depth < 6 && !level.empty(); ++depth) {
    std::vector<KeyPath> next;
    for (const KeyPath& p : level)
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
