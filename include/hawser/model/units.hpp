// Units of the case file. A bare number is in the base unit of its key; "850 mm" gives another.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hawser::model {

enum class Dimension {
  none,
  length,
  time,
  mass,
  mass_per_length,
  force,
  force_per_length,  // a load, N/m
  moment,
  bending_stiffness,  // N m²
  point_stiffness,    // N/m
  line_stiffness,     // N/m², per length of a line
  area_stiffness,     // N/m³, per area of a line
  velocity,
  acceleration,
  angle,  // base unit deg, SI value rad
  angular_velocity,
  inertia_per_length,  // kg m
  inertia,             // kg m²
  point_damping,       // N s/m
  turning_stiffness,   // N m/rad
  turning_damping,     // N m s/rad
  density,             // kg/m³
  pressure,            // Pa
  volume,              // m³
  area,                // m²
  temperature_change,  // K
  thermal_expansion,   // 1/K
};
// All dimensions, in order of declaration.
std::span<const Dimension> dimensions();

struct Unit {
  std::string_view name;            // canonical: no blanks or dots, powers as ^2
  double multiply = 1, divide = 1;  // SI = value * multiply / divide; both keep 850 mm exactly 0.85
};

std::string_view dimension_name(Dimension d);  // "length", as in "a length is given in m, mm ..."
std::string_view base_unit(Dimension d);       // as printed: "N m²"; "-" for none
std::span<const Unit> units_of(Dimension d);   // first is the base unit

// Bounds of the magnitude of nonzero numbers: products of five such numbers, as in E d^4, neither overflow
// nor underflow.
inline constexpr double kLargest = 1e60, kSmallest = 1e-60;

// A number with or without unit, e.g. "0.85", "850 mm", "1e3 kN", converted to SI.
struct Quantity {
  enum class Status { ok, not_a_number, not_finite, out_of_range, wrong_unit };
  Status status = Status::ok;
  double si = 0;
  std::string unit;  // as written, for messages
};
Quantity parse_quantity(std::string_view text, Dimension d);

}  // namespace hawser::model
