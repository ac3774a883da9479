// Functions that build the keys of a case file and bind them to the fields they fill:
//   number({"mass", &PointMass::mass}, mass, "point mass", above(0), required)
// gives the name and field of a key, its unit, its help, its range and that it is required.
#pragma once

#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "hawser/math/types.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::model {

// Stores a value in a field according to its type: a struct by its own keys, a vector item by item, and the
// `name` of entries of a map of names.
template <class M>
void put(M& x, const Value& v) {
  if constexpr (std::is_arithmetic_v<M> || std::is_enum_v<M>) {
    x = static_cast<M>(v.number);
  } else if constexpr (std::is_same_v<M, std::string>) {
    x = v.text;
  } else if constexpr (std::is_same_v<M, Vec3>) {
    x = Vec3(v.items[0].number, v.items[1].number, v.items[2].number);
  } else if constexpr (requires { typename M::first_type; }) {
    put(x.first, v.items[0]);
    put(x.second, v.items[1]);
  } else if constexpr (requires {
                         x.emplace();
                         *x;
                       }) {
    put(x.emplace(), v);
  } else if constexpr (requires { x.emplace_back(); }) {
    if constexpr (requires { x.reserve(1); }) x.reserve(v.items.size());
    for (std::size_t i = 0; i < v.items.size(); ++i) {
      put(x.emplace_back(), *Entry(v, i));
      if constexpr (requires { x.back().name; })
        if (!v.keys.empty()) x.back().name = v.keys[i];
    }
  } else {
    take(v, x);
  }
}

namespace schema_build {

// Function that fills a field.
struct Field {
  Put put;
  template <class T, class M>
  Field(M T::*f) : put([f](const Target& to, const Value& v) { model::put(to.as<T>().*f, v); }) {}
  explicit Field(Put p) : put(std::move(p)) {}
};
// A field of a nested struct.
template <class T, class U, class M>
Field within(U T::*s, M U::*f) {
  return Field(Put([s, f](const Target& to, const Value& v) { put(to.as<T>().*s.*f, v); }));
}
// A key of a nested struct, among the keys of the enclosing struct.
template <class T, class U>
Key within(U T::*s, Key key) {
  for (Put& f : key.fields) f = [s, f](const Target& to, const Value& v) { f(to.as<T>().*s, v); };
  return key;
}
// A field that is set to x if the key is present.
template <class T, class M>
Field set(M T::*f, std::type_identity_t<M> x) {
  return Field(Put([f, x](const Target& to, const Value&) { to.as<T>().*f = x; }));
}
template <class T, class U, class M>
Field set(U T::*s, M U::*f, std::type_identity_t<M> x) {
  return Field(Put([s, f, x](const Target& to, const Value&) { to.as<T>().*s.*f = x; }));
}
// A nonzero direction of three numbers, as a unit vector.
Vec3 direction(const Value& v);
template <class T, class M>
Field unit(M T::*f) {
  return Field(Put([f](const Target& to, const Value& v) { to.as<T>().*f = direction(v); }));
}
// For a key with `set` or another field beside it: its own keys fill the enclosing struct.
template <class T>
Field itself() {
  return Field(Put([](const Target& to, const Value& v) { take(v, to.as<T>()); }));
}
// Calls f(T&, const Value&); a std::invalid_argument from it becomes the refusal of the key.
template <class T, class Function>
Field set_by(Function f) {
  return Field(Put([f](const Target& to, const Value& v) { f(to.as<T>(), v); }));
}

// The name of a key and the fields that it fills: "mass" or {"mass", &PointMass::mass}.
struct Head {
  std::string name;
  std::vector<Put> fields;
  Head(const char* n) : name(n) {}
  Head(std::string n) : name(std::move(n)) {}
  template <class... F>
  Head(const char* n, F... f) : name(n), fields{Field(f).put...} {}
};

// A word and its value.
struct Word {
  std::string text;
  double means = 0;
  Word(const char* t) : text(t) {}
  template <class M>
  Word(const char* t, M m) : text(t), means(static_cast<double>(m)) {}
};

using Type = Key::Type;
using enum Dimension;

// Arguments after a key's name, in any order: help, unit, nested keys, and any of the functions below.
inline void apply(Key& k, std::string about) { k.about = std::move(about); }
inline void apply(Key& k, Dimension unit) { k.unit = unit; }
inline void apply(Key& k, std::vector<Key> keys) { k.keys = std::move(keys); }
inline void apply(Key& k, std::invocable<Key&> auto edit) { edit(k); }

inline auto above(double x) {
  return [x](Key& k) { k.bounds.above = x; };
}
inline auto at_least(double x) {
  return [x](Key& k) { k.bounds.at_least = x; };
}
inline auto at_most(double x) {
  return [x](Key& k) { k.bounds.at_most = x; };
}
inline auto in_range(double lowest, double highest) {
  return [=](Key& k) {
    k.bounds.at_least = lowest;
    k.bounds.at_most = highest;
  };
}
// Allowed number of entries of a list; most = 0: no limit.
inline auto items(std::size_t min_count, std::size_t max_count = 0) {
  return [=](Key& k) {
    k.min_items = min_count;
    k.max_items = max_count;
  };
}
inline constexpr auto required = [](Key& k) { k.required = true; };
// The state in a checkpoint depends on the key.
inline constexpr auto fixed_in_restart = [](Key& k) { k.fixed_in_restart = true; };
// Default of a key, literally or in words.
inline auto or_else(std::string literal) {
  return [literal](Key& k) { k.fallback = literal; };
}
inline auto or_else_note(std::string words) {
  return [words](Key& k) { k.fallback_note = words; };
}
// At most one, or exactly one, of these groups of keys of a map is used.
inline auto at_most_one_of(std::vector<Group> groups) {
  return [groups](Key& k) { k.groups = groups; };
}
inline auto either(std::vector<Group> groups) {
  return [groups](Key& k) {
    k.groups = groups;
    k.group_required = true;
  };
}

Key with(Key k, auto... parts) {
  (apply(k, std::move(parts)), ...);
  return k;
}

Key make(Type type, Head head, auto... parts) {
  Key k;
  k.type = type;
  k.name = std::move(head.name);
  k.fields = std::move(head.fields);
  return with(std::move(k), std::move(parts)...);
}

Key number(Head head, Dimension unit, auto... parts) { return make(Type::number, head, unit, parts...); }
Key vec3(Head head, Dimension unit, auto... parts) { return make(Type::vec3, head, unit, parts...); }
Key integer(Head head, auto... parts) { return make(Type::integer, head, parts...); }
Key boolean(Head head, auto... parts) { return make(Type::boolean, head, parts...); }
Key text(Head head, auto... parts) { return make(Type::text, head, parts...); }
Key name(Head head, auto... parts) { return make(Type::name, head, parts...); }
Key word(Head head, const std::vector<Word>& words, auto... parts) {
  Key k = make(Type::word, head, parts...);
  for (const Word& w : words) {
    k.words.push_back(w.text);
    k.meanings.push_back(w.means);
  }
  return k;
}
Key reference(Head head, std::string to, auto... parts) {
  Key k = make(Type::reference, head, parts...);
  k.refers = std::move(to);
  return k;
}
Key list(Head head, Key item, auto... parts) {
  return make(Type::list, head, std::vector{std::move(item)}, parts...);
}
Key map(Head head, std::vector<Key> keys, auto... parts) {
  return make(Type::map, head, std::move(keys), parts...);
}
Key map_by_name(Head head, Key item, auto... parts) {
  return make(Type::map_by_name, head, std::vector{std::move(item)}, parts...);
}
Key one_of(Head head, std::vector<Key> alternatives, auto... parts) {
  return make(Type::one_of, head, std::move(alternatives), parts...);
}

// List of rows with two numbers each.
Key rows(Head head, auto... parts) {
  return list(std::move(head), list("", number("", none), items(2, 2)), parts...);
}

// Arc length on a line.
Key arc(Head head, auto... parts) {
  return one_of(std::move(head),
                {number("", length, at_least(0)), word("", {{"end_a", 0}, {"end_b", kEndB}})}, parts...);
}

// Stores rows of force over penetration as the `force_table` of a volume or the seabed.
template <class T>
void force_table(T& o, const Value& v) {
  o.force_table = std::make_shared<const ContactForceTable>(v.rows());
  o.normal_stiffness = o.force_table->largest_slope();
}

inline constexpr const char* kZero = "[0, 0, 0]";

Key farm();  // platforms from files of their own
Key bodies();
Key volumes();   // with shapes, contact laws and friction
Key supports();  // roller boxes of laid pipes
Key joints();
Key lines();
std::vector<Key> feed_law();  // control law of a feeder: for ends and events
Key links();
Key contact();
Key statics();
Key dynamics();
Key stages();
Key events();
Key relative_damping();              // of volumes and of rollers
Key friction(const Field& field);    // coefficients and springs, of volumes and the seabed
Key force_rows(const Field& field);  // `table` of force over penetration, of volumes and the seabed
Key environment();                   // sea and seabed
std::vector<Key> in_water();         // of line types
Key line_types();
Key output();

}  // namespace schema_build
}  // namespace hawser::model
