// What the keys of a case file are put together from.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hawser/model/schema.hpp"

namespace hawser::model::schema_build {

using Type = Key::Type;
using enum Dimension;

inline Key make(Type type, std::string name, std::string about) {
  Key k;
  k.type = type;
  k.name = std::move(name);
  k.about = std::move(about);
  return k;
}

// With a unit; put together from other keys.
inline Key make(Type type, std::string name, Dimension unit, std::string about) {
  Key k = make(type, std::move(name), std::move(about));
  k.unit = unit;
  return k;
}
inline Key make(Type type, std::string name, std::vector<Key> keys, std::string about) {
  Key k = make(type, std::move(name), std::move(about));
  k.keys = std::move(keys);
  return k;
}

inline Key number(std::string name, Dimension unit, std::string about = "") {
  return make(Type::number, std::move(name), unit, std::move(about));
}
inline Key vec3(std::string name, Dimension unit, std::string about = "") {
  return make(Type::vec3, std::move(name), unit, std::move(about));
}
inline Key integer(std::string name, std::string about) {
  return make(Type::integer, std::move(name), std::move(about));
}
inline Key boolean(std::string name, std::string about = "") {
  return make(Type::boolean, std::move(name), std::move(about));
}
inline Key text(std::string name, std::string about) {
  return make(Type::text, std::move(name), std::move(about));
}
inline Key word(std::string name, std::vector<std::string> words, std::string about = "") {
  Key k = make(Type::word, std::move(name), std::move(about));
  k.words = std::move(words);
  return k;
}
inline Key reference(std::string name, std::string to, std::string about = "") {
  Key k = make(Type::reference, std::move(name), std::move(about));
  k.refers = std::move(to);
  return k;
}
inline Key list(std::string name, Key item, std::string about) {
  return make(Type::list, std::move(name), std::vector{std::move(item)}, std::move(about));
}
inline Key map(std::string name, std::vector<Key> keys, std::string about) {
  return make(Type::map, std::move(name), std::move(keys), std::move(about));
}
inline Key names(std::string name, Key item, std::string about) {
  return make(Type::names, std::move(name), std::vector{std::move(item)}, std::move(about));
}
inline Key one_of(std::string name, std::vector<Key> alternatives, std::string about) {
  return make(Type::one_of, std::move(name), std::move(alternatives), std::move(about));
}

// An arc length of a line.
inline Key arc(std::string name, std::string about) {
  return one_of(std::move(name), {number("", length).at_least(0), word("", {"end_a", "end_b"})},
                std::move(about));
}

inline constexpr const char* kZero = "[0, 0, 0]";

Key bodies();
Key volumes();   // with their shapes, contact laws and friction
Key supports();  // of laid pipes: roller boxes
Key joints();
Key lines();
std::vector<Key> feed_law();  // by which a feeder goes: of ends and of events
Key links();
Key contact();
Key statics();
Key dynamics();
Key stages();
Key events();
Key friction();               // coefficients and springs of it, of volumes and the seabed
Key force_rows();             // `table` of force against penetration, of volumes and the seabed
Key environment();            // the sea and its bed
std::vector<Key> in_water();  // of line types
Key line_types();
Key output();

}  // namespace hawser::model::schema_build
