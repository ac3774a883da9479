// Check of a Value against the schema: form, numbers, units, bounds, names, references, defaults.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

#include "hawser/base/error.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"
#include "schema_hints.hpp"

namespace hawser::model {

std::string refusal(const std::string& file, int line, const std::string& key, const std::string& text) {
  std::string where = file;
  if (line > 0) where += fmt::format(":{}", line);
  if (line == kBySet) where += " with --set";
  if (!key.empty()) where += ": " + key;
  std::string s = where + ": " + text;
  for (char& c : s)  // keeps the message on one line, whatever the file contains
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return s;
}

void fail(const std::string& file, int line, const std::string& key, const std::string& text) {
  throw InputError(refusal(file, line, key, text));
}

const char* name_pattern() { return "^[A-Za-z0-9_\u0080-\uffff][A-Za-z0-9_+ \u0080-\uffff-]*$"; }

bool is_name(std::string_view text) {
  constexpr std::size_t kLongest = 100;
  if (text.empty() || text.size() > kLongest || text.front() == ' ' || text.back() == ' ') return false;
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  };
  const auto inner = [&](char c) { return letter(c) || c == '-' || c == '+' || c == ' '; };
  return letter(text.front()) && std::all_of(text.begin(), text.end(), inner);
}

namespace {

using Type = Key::Type;
using Kind = Value::Kind;

std::string in_unit(Dimension d) { return d == Dimension::none ? "" : fmt::format(" [{}]", base_unit(d)); }

// "a number [m]" -> "numbers [m]"
std::string plural(std::string s) {
  if (s.starts_with("a number")) return "numbers" + s.substr(8);
  if (s.starts_with("a list")) return "lists" + s.substr(6);
  if (s.starts_with("the name of an entry")) return "names of entries" + s.substr(20);
  return s;
}

// Bounds in the base unit, which is stated unless the bound is zero.
std::string bounds_text(const Key& k) {
  const double f = k.unit == Dimension::angle ? 180 / 3.14159265358979323846 : 1;
  const auto text = [&](double bound) {
    return bound == 0 || k.unit == Dimension::none ? fmt::format("{:g}", bound * f)
                                                   : fmt::format("{:g} {}", bound * f, base_unit(k.unit));
  };
  if (k.bounds.at_least && k.bounds.at_least == k.bounds.at_most) return text(*k.bounds.at_least);
  std::vector<std::string> parts;
  if (k.bounds.above) parts.push_back("above " + text(*k.bounds.above));
  if (k.bounds.at_least) parts.push_back("at least " + text(*k.bounds.at_least));
  if (k.bounds.at_most) parts.push_back("at most " + text(*k.bounds.at_most));
  return enumerate(parts, "and");
}

// Parses a literal default of the schema: scalar, [a, b, ...] or {}.
Value literal(const std::string& s, int line) {
  Value v;
  v.given = false;
  v.line = line;
  if (s == "{}") {
    v.kind = Kind::map;
  } else if (s.starts_with('[')) {
    v.kind = Kind::list;
    std::string item;
    for (const char c : s.substr(1)) {
      if (c == ',' || c == ']') {
        if (!item.empty()) v.items.push_back(literal(item, line));
        item.clear();
      } else if (c != ' ') {
        item += c;
      }
    }
  } else {
    v.kind = Kind::scalar;
    v.text = s;
  }
  return v;
}

class Checker {
 public:
  // again: the values were found to be right, so that references need no search.
  Checker(const std::string& file, Value& root, const MoreNames& more, bool again = false)
      : file_(file), root_(root), more_(more), again_(again) {}

  void check(Value& v, const Key& k, std::string where) {
    v.where = std::move(where);
    v.schema = &k;
    const std::string& path = v.where;
    switch (k.type) {
      case Type::number:
        return check_number(v, k, path, false);
      case Type::integer:
        return check_number(v, k, path, true);
      case Type::boolean:
        return check_boolean(v, k, path);
      case Type::word:
        return check_word(v, k, path);
      case Type::text:
        return check_text(v, k, path);
      case Type::name:
        return check_name(v, k, path);
      case Type::reference:
        return check_reference(v, k, path);
      case Type::vec3:
        return check_vec3(v, k, path);
      case Type::list:
        return check_list(v, k, path);
      case Type::map:
        return check_map(v, k, path);
      case Type::map_by_name:
        return check_names(v, k, path);
      case Type::one_of:
        return check_one_of(v, k, path);
    }
  }

 private:
  template <class... Args>
  [[noreturn]] void refuse(const Value& v, const std::string& path, fmt::format_string<Args...> text,
                           Args&&... args) const {
    fail(file_, v.line, path, fmt::format(text, std::forward<Args>(args)...));
  }

  static std::string kind_of_value(const Value& v) {
    switch (v.kind) {
      case Kind::null:
        return "nothing";
      case Kind::list:
        return "a list";
      case Kind::map:
      case Kind::packed:
        return "a map of keys";
      case Kind::scalar:
        return quote(v.text);
    }
    return {};
  }

  [[noreturn]] void wrong_type(const Value& v, const Key& k, const std::string& path,
                               const std::string& hint = "") const {
    refuse(v, path, "expected {}, found {}{}", describe(k), kind_of_value(v), hint);
  }

  // k: of the number, or of the three that it belongs to.
  [[noreturn]] void no_number(const Value& v, Key k, const std::string& path, bool integer,
                              const std::string& hint = "") const {
    k.type = integer ? Type::integer : Type::number;
    wrong_type(v, k, path, hint);
  }

  void check_number(Value& v, const Key& k, const std::string& path, bool integer) {
    if (v.kind != Kind::scalar) no_number(v, k, path, integer);
    const Quantity q = parse_quantity(v.text, k.unit);
    switch (q.status) {
      case Quantity::Status::ok:
        break;
      case Quantity::Status::not_a_number: {
        const bool comma = v.text.find(',') != std::string::npos;
        const bool comment = v.text.find("//") != std::string::npos;
        no_number(v, k, path, integer,
                  comment ? "; a comment begins with '#'"
                  : comma ? "; the decimal sign is a point"
                          : "");
      }
      case Quantity::Status::not_finite:
        refuse(v, path, "{} is not a finite number", quote(v.text));
      case Quantity::Status::out_of_range:
        refuse(v, path, "{} is out of range; a number is 0 or between {:g} and {:g} in size", quote(v.text),
               kSmallest, kLargest);
      case Quantity::Status::wrong_unit: {
        if (const std::string hint = misspelt_number(q.unit); !hint.empty())
          no_number(v, k, path, integer, hint);
        if (k.unit == Dimension::none)
          refuse(v, path, "wrong unit {} in {}; this number has no unit", quote(q.unit), quote(v.text));
        std::vector<std::string> units;
        for (const Unit& u : units_of(k.unit)) units.emplace_back(u.name);
        refuse(v, path, "wrong unit {} in {}; a {} is given in {} (a bare number is in {})", quote(q.unit),
               quote(v.text), dimension_name(k.unit), enumerate(units), base_unit(k.unit));
      }
    }
    if (integer && (q.si != std::floor(q.si) || std::abs(q.si) > 1e15)) no_number(v, k, path, integer);
    const Bounds& b = k.bounds;
    if ((b.above && !(q.si > *b.above)) || (b.at_least && !(q.si >= *b.at_least)) ||
        (b.at_most && !(q.si <= *b.at_most)))
      refuse(v, path, "{} is out of range; must be {}", quote(v.text), bounds_text(k));
    v.number = q.si;
  }

  void check_boolean(Value& v, const Key& k, const std::string& path) {
    const bool yes = v.is("true") || v.is("True") || v.is("TRUE");
    const bool no = v.is("false") || v.is("False") || v.is("FALSE");
    if (v.quoted || (!yes && !no)) wrong_type(v, k, path);
    v.number = yes ? 1 : 0;
  }

  void check_word(Value& v, const Key& k, const std::string& path) {
    if (v.kind == Kind::scalar)
      for (std::size_t i = 0; i < k.words.size(); ++i)
        if (k.words[i] == v.text) return void(v.number = k.meanings[i]);
    wrong_type(v, k, path, v.kind == Kind::scalar ? did_you_mean(v.text, k.words) : "");
  }

  void check_text(Value& v, const Key& k, const std::string& path) {
    if (v.kind != Kind::scalar) wrong_type(v, k, path);
    if (v.text.empty() && v.given) refuse(v, path, "is empty; expected {}", describe(k));
    if (v.text.find('\0') != std::string::npos) refuse(v, path, "holds a zero byte");
  }

  void check_name(Value& v, const Key& k, const std::string& path) {
    if (v.kind != Kind::scalar) wrong_type(v, k, path);
    check_name_text(v, v.text, path);
  }

  // True for the maps of parts that a farm copies.
  static bool can_be_placed(const std::string& path) {
    return std::find(std::begin(kPlaced), std::end(kPlaced), path) != std::end(kPlaced);
  }

  void check_name_text(const Value& v, const std::string& name, const std::string& path) const {
    if (!is_name(name))
      refuse(
          v, path,
          "{} is not a valid name; a name begins with a letter or digit and has up to 100 letters, digits, "
          "'_', '-', '+' and inner blanks{}",
          quote(name),
          name.find('/') != std::string::npos && can_be_placed(path)
              ? "; parts at the places of a farm are described in the file of their platform"
              : "");
  }

  void check_reference(Value& v, const Key& k, const std::string& path) {
    if (v.kind != Kind::scalar) wrong_type(v, k, path);
    if (again_) return;
    const auto [index, is_new] = known_.try_emplace(k.refers);
    if (is_new)
      for (const std::string& name : names_of(k.refers)) index->second.insert(name);
    if (index->second.count(v.text)) return;
    const std::vector<std::string> known = names_of(k.refers);
    std::vector<std::string> some(known.begin(),
                                  known.begin() + std::min<long>(12, static_cast<long>(known.size())));
    if (some.size() < known.size()) some.emplace_back("...");
    refuse(v, path, "no {} is called {}{}{}", singular(k.refers), quote(v.text), did_you_mean(v.text, known),
           known.empty() ? fmt::format(" ({} is empty)", k.refers)
                         : fmt::format(" (known: {})", fmt::join(some, ", ")));
  }

  // Names of the entries of a top-level map of the document, and the additional names.
  std::vector<std::string> names_of(const std::string& map) const {
    std::vector<std::string> names;
    if (const Value* target = root_.find(map); target && target->kind == Kind::map) names = target->keys;
    if (const auto more = more_.find(map); more != more_.end())
      names.insert(names.end(), more->second.begin(), more->second.end());
    return names;
  }

  static std::string singular(const std::string& map) {
    if (map == "line_types") return "line type";
    if (map == "bodies") return "body";
    return map.substr(0, map.size() - 1);
  }

  void check_vec3(Value& v, const Key& k, const std::string& path) {
    if (v.kind != Kind::list) wrong_type(v, k, path, hint_of_no_list(v));
    if (v.items.size() != 3)
      refuse(v, path, "expected {}, found a list of {}{}", describe(k), v.items.size(), hint_of_no_commas(v));
    constexpr const char* kPlaces[] = {"[0]", "[1]", "[2]"};
    for (std::size_t i = 0; i < 3; ++i) {
      Value& x = v.items[i];
      x.where = path + kPlaces[i];
      check_number(x, k, x.where, false);
    }
  }

  void check_list(Value& v, const Key& k, const std::string& path) {
    if (v.kind != Kind::list) wrong_type(v, k, path, hint_of_no_list(v));
    const std::size_t n = v.items.size();
    if (n < k.min_items || (k.max_items > 0 && n > k.max_items))
      refuse(v, path, "expected {}, found a list of {}{}", describe(k), n, hint_of_no_commas(v));
    for (std::size_t i = 0; i < n; ++i) check(v.items[i], k.keys[0], path + "[" + std::to_string(i) + "]");
  }

  void check_names(Value& v, const Key& k, const std::string& path) {
    if (v.kind != Kind::map) wrong_type(v, k, path, hint_of_no_keys(v, k));
    if (v.items.size() < k.min_items) refuse(v, path, "is empty; at least one entry is needed");
    for (std::size_t i = 0; i < v.items.size(); ++i) {
      check_name_text(v.items[i], v.keys[i], path);
      const std::string where = path + "." + v.keys[i];
      if (v.items[i].kind == Kind::packed) {
        Value entry = unpacked(v.items[i]);
        check(entry, k.keys[0], where);
      } else {
        check(v.items[i], k.keys[0], where);
      }
    }
  }

  void check_map(Value& v, const Key& k, const std::string& path) {
    if (v.kind != Kind::map) wrong_type(v, k, path, hint_of_no_keys(v, k));
    const std::string prefix = path.empty() ? "" : path + ".";
    std::vector<const Key*> of_items;
    of_items.reserve(k.keys.size());
    for (std::size_t i = 0; i < v.keys.size(); ++i) {
      const auto same = [&](const Key& c) { return c.name == v.keys[i]; };
      const auto found = std::find_if(k.keys.begin(), k.keys.end(), same);
      if (found == k.keys.end()) unknown_key(v, i, k, prefix);
      of_items.push_back(&*found);
    }
    for (const Key& c : k.keys)
      if (c.required && !v.has(c.name))
        refuse(v, prefix + c.name, "required key is missing; expected {}: {}", describe(c), c.about);
    check_groups(v, k, path);
    for (std::size_t i = 0; i < v.keys.size(); ++i) check(v.items[i], *of_items[i], prefix + v.keys[i]);
    const auto missing = std::count_if(k.keys.begin(), k.keys.end(),
                                       [&](const Key& c) { return c.fallback && !v.has(c.name); });
    v.keys.reserve(v.keys.size() + static_cast<std::size_t>(missing));
    v.items.reserve(v.items.size() + static_cast<std::size_t>(missing));
    for (const Key& c : k.keys)
      if (c.fallback && !v.has(c.name)) {
        Value filled = literal(*c.fallback, v.line);
        check(filled, c, prefix + c.name);
        v.keys.push_back(c.name);
        v.items.push_back(std::move(filled));
      }
  }

  [[noreturn]] void unknown_key(const Value& v, std::size_t i, const Key& k,
                                const std::string& prefix) const {
    std::vector<std::string> allowed;
    for (const Key& c : k.keys) allowed.push_back(c.name);
    std::sort(allowed.begin(), allowed.end());
    refuse(v.items[i], prefix + printable(v.keys[i]), "unknown key{} (allowed: {})",
           likely_key(v, i, k, allowed), fmt::join(allowed, ", "));
  }

  static std::string printable(const std::string& key) {
    const std::string q = quote(key);
    return is_name(key) ? key : q;
  }

  void check_groups(const Value& v, const Key& k, const std::string& path) const {
    const Group* used = nullptr;
    std::string excluding;
    for (const Group& g : k.groups)
      for (const std::string& key : g.keys) {
        if (!v.has(key)) continue;
        if (used && used != &g)
          refuse(*v.find(key), path, "'{}' and '{}' exclude each other; {}", excluding, key, choices(k));
        used = &g;
        excluding = key;
      }
    if (k.groups.empty()) return;
    if (!used && k.group_required) refuse(v, path, "{}", choices(k));
    if (!used) return;
    for (const std::string& key : used->needed)
      if (!v.has(key)) refuse(v, path, "'{}' requires '{}'", excluding, key);
  }

  static std::string choices(const Key& k) {
    std::vector<std::string> c;
    for (const Group& g : k.groups) {
      std::vector<std::string> keys;
      for (const std::string& key : g.needed.empty() ? g.keys : g.needed) keys.push_back("'" + key + "'");
      c.push_back(enumerate(keys, g.needed.empty() ? "and" : "with"));
    }
    return "give " + std::string(k.group_required ? "one of " : "only one of ") + enumerate(c);
  }

  // Alternatives differ in form; the form of the value selects the one to check against.
  void check_one_of(Value& v, const Key& k, const std::string& path) {
    const Key* choice = nullptr;
    const auto pick = [&](std::initializer_list<Type> types) {
      for (const Type t : types)
        for (const Key& a : k.keys)
          if (!choice && a.type == t) choice = &a;
    };
    if (v.kind == Kind::map) pick({Type::map, Type::map_by_name});
    if (v.kind == Kind::list) pick({Type::vec3, Type::list});
    if (v.kind == Kind::scalar) {
      const char c = v.text.empty() ? ' ' : v.text.front();
      const bool numeric =
          c == '+' || c == '-' || c == '.' || (c >= '0' && c <= '9') || v.is("nan") || v.is("inf");
      if (numeric) pick({Type::number, Type::integer});
      pick({Type::text});
      for (const Key& a : k.keys)
        if (a.type == Type::word && std::find(a.words.begin(), a.words.end(), v.text) != a.words.end())
          return check(v, a, path);
      if (v.is("true") || v.is("false")) pick({Type::boolean});
      if (!choice)
        for (const Key& a : k.keys)
          if (a.type == Type::word) wrong_type(v, k, path, did_you_mean(v.text, a.words));
    }
    if (!choice) wrong_type(v, k, path);
    check(v, *choice, path);
  }

  const std::string& file_;
  Value& root_;
  const MoreNames& more_;
  const bool again_;
  std::map<std::string, std::unordered_set<std::string>> known_;  // names by top-level map
};

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
      std::string items = plural(describe(k.keys[0]));
      if (items.starts_with("a map")) items = "maps" + items.substr(5);
      if (k.keys[0].type == Type::one_of) {
        std::vector<std::string> parts;
        for (const Key& a : k.keys[0].keys) parts.push_back(plural(describe(a)));
        items = enumerate(parts);
      }
      if (k.max_items > 0 && k.max_items == k.min_items)
        return fmt::format("a list of {} {}", k.min_items, items);
      if (k.max_items > 0) return fmt::format("a list of {} to {} {}", k.min_items, k.max_items, items);
      if (k.min_items == 1) return "a list of one or more " + items;
      if (k.min_items > 0) return fmt::format("a list of at least {} {}", k.min_items, items);
      return "a list of " + items;
    }
    case Type::map: {
      std::vector<std::string> names;
      for (const Key& c : k.keys) names.push_back(c.name);
      return fmt::format("a map with the keys {}", fmt::join(names, ", "));
    }
    case Type::map_by_name:
      return "a map of names";
    case Type::one_of: {
      std::vector<std::string> parts;
      for (const Key& a : k.keys) parts.push_back(describe(a));
      return enumerate(parts);
    }
  }
  return {};
}

void check_structure(Value& root, const Key& schema, const std::string& file, const MoreNames& more) {
  Checker(file, root, more).check(root, schema, "");
}

void check_again(Value& v, const Key& key, const std::string& where) {
  static const MoreNames none;
  static const std::string file;
  Checker(file, v, none, true).check(v, key, where);
}

}  // namespace hawser::model
