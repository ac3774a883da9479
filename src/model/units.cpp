// Table of units with factors to SI, accepted spellings of units, and the parser of a number with its unit.
#include "hawser/model/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace hawser::model {
namespace {

constexpr double kTonneForce = 9806.65;  // N, by definition of standard gravity
constexpr double kPi = std::numbers::pi;

constexpr Unit kNone[] = {{"1"}, {"%", 1, 100}};
constexpr Unit kLength[] = {{"m"},           {"mm", 1, 1000},    {"cm", 1, 100},
                            {"km", 1000, 1}, {"in", 254, 10000}, {"ft", 3048, 10000}};
constexpr Unit kTime[] = {{"s"}, {"ms", 1, 1000}, {"min", 60, 1}, {"h", 3600, 1}};
constexpr Unit kMass[] = {{"kg"}, {"g", 1, 1000}, {"t", 1000, 1}};
constexpr Unit kMassPerLength[] = {{"kg/m"}, {"t/m", 1000, 1}, {"kg/km", 1, 1000}};
constexpr Unit kForce[] = {{"N"}, {"kN", 1e3, 1}, {"MN", 1e6, 1}, {"GN", 1e9, 1}, {"tf", kTonneForce, 1}};
constexpr Unit kForcePerLength[] = {
    {"N/m"}, {"kN/m", 1e3, 1}, {"MN/m", 1e6, 1}, {"kgf/m", kTonneForce, 1000}, {"tf/m", kTonneForce, 1}};
constexpr Unit kMoment[] = {{"Nm"}, {"kNm", 1e3, 1}, {"MNm", 1e6, 1}, {"tfm", kTonneForce, 1}};
constexpr Unit kBending[] = {
    {"Nm^2"}, {"kNm^2", 1e3, 1}, {"MNm^2", 1e6, 1}, {"GNm^2", 1e9, 1}, {"tfm^2", kTonneForce, 1}};
constexpr Unit kLineStiffness[] = {{"N/m^2"}, {"kN/m^2", 1e3, 1}, {"MN/m^2", 1e6, 1},
                                   {"N/m/m"}, {"kN/m/m", 1e3, 1}, {"MN/m/m", 1e6, 1},
                                   {"Pa"},    {"kPa", 1e3, 1},    {"MPa", 1e6, 1}};
constexpr Unit kAreaStiffness[] = {{"N/m^3"}, {"kN/m^3", 1e3, 1}, {"MN/m^3", 1e6, 1}, {"kN/m/m^2", 1e3, 1},
                                   {"Pa/m"},  {"kPa/m", 1e3, 1}};
constexpr Unit kVelocity[] = {{"m/s"}, {"km/h", 10, 36}, {"kn", 1852, 3600}, {"cm/s", 1, 100}};
constexpr Unit kAcceleration[] = {{"m/s^2"}};
constexpr Unit kAngle[] = {{"deg", kPi, 180}, {"rad"}};
constexpr Unit kAngularVelocity[] = {{"rad/s"}, {"deg/s", kPi, 180}, {"rpm", kPi, 30}};
constexpr Unit kInertia[] = {{"kgm"}, {"tm", 1000, 1}, {"kgm^2/m"}, {"tm^2/m", 1000, 1}};
constexpr Unit kMomentOfInertia[] = {{"kgm^2"}, {"tm^2", 1000, 1}};
constexpr Unit kPointDamping[] = {{"Ns/m"}, {"kNs/m", 1e3, 1}, {"MNs/m", 1e6, 1}};
constexpr Unit kTurningStiffness[] = {
    {"Nm/rad"},           {"kNm/rad", 1e3, 1},     {"MNm/rad", 1e6, 1},    {"Nm", 1, 1},
    {"Nm/deg", 180, kPi}, {"kNm/deg", 180e3, kPi}, {"MNm/deg", 180e6, kPi}};
constexpr Unit kTurningDamping[] = {{"Nms/rad"}, {"kNms/rad", 1e3, 1}, {"MNms/rad", 1e6, 1}, {"Nms"}};
constexpr Unit kDensity[] = {{"kg/m^3"}, {"t/m^3", 1000, 1}};
constexpr Unit kPressure[] = {{"Pa"}, {"kPa", 1e3, 1}, {"MPa", 1e6, 1}, {"GPa", 1e9, 1}, {"bar", 1e5, 1}};
constexpr Unit kVolume[] = {{"m^3"}};
constexpr Unit kArea[] = {{"m^2"}};
constexpr Unit kTemperatureChange[] = {{"K"}, {"degC"}, {"°C"}};
constexpr Unit kThermalExpansion[] = {{"1/K"}, {"1/degC"}, {"1/°C"}};

struct Units {
  std::string_view name, base;
  std::span<const Unit> units;
};
// In the order of Dimension.
const std::array kTable = std::to_array<Units>({{"dimensionless number", "-", kNone},
                                                {"length", "m", kLength},
                                                {"time", "s", kTime},
                                                {"mass", "kg", kMass},
                                                {"mass per length", "kg/m", kMassPerLength},
                                                {"force", "N", kForce},
                                                {"force per length", "N/m", kForcePerLength},
                                                {"moment", "N m", kMoment},
                                                {"bending or torsion stiffness", "N m²", kBending},
                                                {"stiffness per point", "N/m", kForcePerLength},
                                                {"stiffness per length", "N/m²", kLineStiffness},
                                                {"stiffness per area", "N/m³", kAreaStiffness},
                                                {"velocity", "m/s", kVelocity},
                                                {"acceleration", "m/s²", kAcceleration},
                                                {"angle", "deg", kAngle},
                                                {"angular velocity", "rad/s", kAngularVelocity},
                                                {"rotary inertia per length", "kg m", kInertia},
                                                {"moment of inertia", "kg m²", kMomentOfInertia},
                                                {"damping of a point", "N s/m", kPointDamping},
                                                {"stiffness against turning", "N m/rad", kTurningStiffness},
                                                {"damping of turning", "N m s/rad", kTurningDamping},
                                                {"density", "kg/m³", kDensity},
                                                {"pressure", "Pa", kPressure},
                                                {"volume", "m³", kVolume},
                                                {"area", "m²", kArea},
                                                {"temperature change", "K", kTemperatureChange},
                                                {"thermal expansion", "1/K", kThermalExpansion}});
constexpr auto kDimensions = [] {
  std::array<Dimension, kTable.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Dimension>(i);
  return all;
}();
static_assert(kDimensions.back() == Dimension::thermal_expansion, "a row for each dimension");

const Units& entry(Dimension d) { return kTable[static_cast<std::size_t>(d)]; }

// Canonical spelling: "kN m²", "kN.m2", "kN*m^2" -> "kNm^2".
std::string canonical(std::string_view unit) {
  std::string s;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const std::string_view remainder = unit.substr(i);
    if (remainder.starts_with("²")) {
      s += "^2";
      ++i;
    } else if (remainder.starts_with("³")) {
      s += "^3";
      ++i;
    } else if (remainder.starts_with("·")) {
      ++i;
    } else if (unit[i] == ' ' || unit[i] == '.' || unit[i] == '*') {
      continue;
    } else if ((unit[i] == '2' || unit[i] == '3') && !s.empty() && s.back() != '^') {
      s += '^';
      s += unit[i];
    } else {
      s += unit[i];
    }
  }
  return s;
}

bool names_no_finite_number(std::string_view s) {
  if (!s.empty() && (s.front() == '+' || s.front() == '-')) s.remove_prefix(1);
  for (const std::string_view w :
       {".inf", ".Inf", ".INF", ".nan", ".NaN", ".NAN", "inf", "nan", "NaN", "Inf"})
    if (s == w) return true;
  return false;
}

}  // namespace

std::span<const Dimension> dimensions() { return kDimensions; }
std::string_view dimension_name(Dimension d) { return entry(d).name; }
std::string_view base_unit(Dimension d) { return entry(d).base; }
std::span<const Unit> units_of(Dimension d) { return entry(d).units; }

namespace {

Quantity::Status status_of(double si) {
  if (!std::isfinite(si)) return Quantity::Status::not_finite;
  const double size = std::abs(si);
  return si == 0 || (size >= kSmallest && size <= kLargest) ? Quantity::Status::ok
                                                            : Quantity::Status::out_of_range;
}

}  // namespace

Quantity parse_quantity(std::string_view text, Dimension d) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  Quantity q;
  if (names_no_finite_number(text)) {
    q.status = Quantity::Status::not_finite;
    return q;
  }
  // from_chars accepts no '+', and accepts words such as "infinity" that are not allowed here.
  std::string_view digits = text;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  const std::string_view unsigned_digits = digits.substr(digits.starts_with('-') ? 1 : 0);
  const char first = unsigned_digits.empty() ? ' ' : unsigned_digits.front();
  if (!(first == '.' || (first >= '0' && first <= '9'))) {
    q.status = Quantity::Status::not_a_number;
    return q;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument) {
    q.status = Quantity::Status::not_a_number;
    return q;
  }
  if (error == std::errc::result_out_of_range) {
    q.status = Quantity::Status::not_finite;
    return q;
  }
  std::string_view unit = digits.substr(static_cast<std::size_t>(end - digits.data()));
  while (!unit.empty() && unit.front() == ' ') unit.remove_prefix(1);
  // Fractions such as "1/7", usual for exponents.
  if (d == Dimension::none && unit.starts_with('/')) {
    double divisor = 0;
    const auto [parsed_end, bad] = std::from_chars(unit.data() + 1, unit.data() + unit.size(), divisor);
    if (bad != std::errc() || parsed_end != unit.data() + unit.size()) {
      q.status = Quantity::Status::not_a_number;
      return q;
    }
    q.si = value / divisor;
    q.status = status_of(q.si);
    return q;
  }
  q.unit = unit;
  const std::span<const Unit> units = units_of(d);
  const Unit* u = unit.empty() ? &units.front() : nullptr;
  if (!u) {
    // "1,5" and "1.2.3" are misspelt numbers, not numbers with an unknown unit.
    const char c = unit.front();
    if (c == ',' || c == '.' || c == '_' || c == ':' || c == '-' || c == '+') {
      q.status = Quantity::Status::not_a_number;
      return q;
    }
    const std::string name = canonical(unit);
    for (const Unit& candidate : units)
      if (candidate.name == name && name != "1") u = &candidate;
  }
  if (!u) {
    q.status = Quantity::Status::wrong_unit;
    return q;
  }
  q.si = value * u->multiply / u->divide;
  q.status = status_of(q.si);
  return q;
}

}  // namespace hawser::model
