// Notes on coefficients of a floating body that do not cover the sea.
#include "hawser/advice/coefficients_in_sea.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hawser/math/degree.hpp"

namespace hawser::advice {
namespace {

std::string uncovered_directions(const char* quantity, const WaveForceTable& table,
                                 const model::Coverage& coverage) {
  const std::vector<double>& given = table.directions();
  return fmt::format(
      "the {} of the files have {} direction{}, {:.4g} to {:.4g} deg, none near {:.4g} deg as seen from the "
      "bow, where {:.3g} % of the sea's energy goes",
      quantity, given.size(), given.size() == 1 ? "" : "s", given.front() / kDegree, given.back() / kDegree,
      coverage.direction / kDegree, 100 * coverage.uncovered);
}

// True if the table has directions of one side of the body only and this direction [rad] is of the other.
bool is_of_other_side(const WaveForceTable& table, double direction) {
  constexpr double kAlong = 1e-6;  // ahead and astern are of both sides
  bool other = false;
  for (const double given : table.directions()) {
    const double same = std::sin(given) * std::sin(direction);
    if (same > kAlong) return false;
    other = other || same < -kAlong;
  }
  return other;
}

std::string uncovered_periods(const char* quantity, double energy, BeyondPeriods beyond, double last) {
  return fmt::format(
      "{:.3g} % of the sea's energy has {} periods than the {} of the files, which end at {:.4g} s",
      100 * energy, beyond == BeyondPeriods::shorter ? "shorter" : "longer", quantity, last);
}

}  // namespace

std::string directions_not_covered(const std::string& key, const char* quantity, const WaveForceTable& table,
                                   const model::Coverage& coverage) {
  return key + ": " + uncovered_directions(quantity, table, coverage);
}

std::string directions_missing(const char* quantity, const WaveForceTable& table,
                               const model::Coverage& coverage) {
  return uncovered_directions(quantity, table, coverage) + ": add these directions to the files" +
         (is_of_other_side(table, coverage.direction)
              ? ", or give 'symmetry: port_starboard' if the sides of the body are mirror images"
              : "");
}

std::string periods_not_covered(const std::string& key, const char* quantity, double energy,
                                BeyondPeriods beyond, double last) {
  return key + ": " + uncovered_periods(quantity, energy, beyond, last) +
         " and are used there as they are at that: add these periods to the files";
}

std::string periods_missing(const char* quantity, double energy, BeyondPeriods beyond, double last) {
  return uncovered_periods(quantity, energy, beyond, last) + ": add these periods to the files";
}

std::string one_direction_of_difference_forces(const std::string& key, double direction) {
  return fmt::format(
      "{}: the difference-frequency forces at {:g} deg as seen from the bow, nearest to the sea, are used; "
      "those at other directions are not",
      key, direction * 180 / M_PI);
}

std::string negative_drift_damping(const std::string& key) {
  return key +
         ".wave_drift_damping: is negative in this sea, so that it excites slow motion instead of damping "
         "it: is its sign wrong?";
}

}  // namespace hawser::advice
