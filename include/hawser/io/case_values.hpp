// Values of optional keys, and arc lengths of places on lines.
#pragma once

#include "hawser/io/case_reader_parts.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {

inline double number(const model::Value& v, const char* key, double fallback = 0) {
  const model::Value* x = v.find(key);
  return x ? x->number : fallback;
}
// Zero if the key is missing.
inline Vec3 vec(const model::Value& v, const char* key) {
  const model::Value* x = v.find(key);
  return x ? as_vec3(*x) : Vec3(Vec3::Zero());
}
// Replaces 'end_b' in a value of the schema by the length of the line.
inline void to_length(double& arc, double length) {
  if (arc == model::kEndB) arc = length;
}
inline double length_of(const model::Case& c, const std::string& line) {
  return model::length_of(c.line(line));
}
// Arc length [m] on a line of this length: a number or 'end_a' or 'end_b'; `fallback` if missing.
inline double arc(const model::Value* v, double fallback, double length) {
  if (!v) return fallback;
  if (v->is("end_a")) return 0;
  if (v->is("end_b")) return length;
  return v->number;
}

}  // namespace hawser::io
