// Notes on tables of response amplitude operators in the sea of the case.
#include "hawser/advice/rao_tables.hpp"

#include <fmt/format.h>

#include "hawser/math/degree.hpp"
#include "hawser/math/freedoms.hpp"

namespace hawser::advice {

std::string sea_in_direction_gap(const std::string& key, size_t waves, double direction,
                                 const DirectionGap& gap) {
  return fmt::format(
      "{}: {} as seen from the bow, and the responses there lie on straight lines between {:.4g} and {:.4g} "
      "deg, the table's next directions: give rows between them, or 'symmetry: port_starboard' if the table "
      "is that of one side",
      key,
      waves == 1 ? fmt::format("the wave propagates to {:.4g} deg", direction / kDegree)
                 : fmt::format("{} components of the sea go to {:.4g} deg and thereabouts", waves,
                               direction / kDegree),
      gap.from / kDegree, gap.to / kDegree);
}

std::string only_one_direction(const std::string& key, double direction, double furthest) {
  return fmt::format(
      "{}: the table has one direction, {:.4g} deg, whose responses are used for waves up to {:.3g} deg away "
      "from it: give rows for the directions of the sea",
      key, direction / kDegree, furthest / kDegree);
}

std::string sea_beyond_responses(const std::string& key, double energy, BeyondPeriods beyond, double farthest,
                                 double last) {
  const bool shorter = beyond == BeyondPeriods::shorter;
  return fmt::format(
      "{}: {:.3g} % of the sea's energy has {} periods than the table, as far as {:.3g} s, and there the "
      "responses of its {} one, {:.4g} s, are used: give rows there",
      key, 100 * energy, shorter ? "shorter" : "longer", farthest, shorter ? "shortest" : "longest", last);
}

std::string phase_turns_between_rows(const std::string& key, const RaoTable::Turn& t, double energy,
                                     size_t more) {
  const bool rotation = t.freedom >= 3;
  const double unit = rotation ? kDegree : 1;
  return fmt::format(
      "{}: in waves to {:.4g} deg as seen from the bow the phase of {} turns by {:.3g} deg from {:.4g} to "
      "{:.4g} s, where {:.3g} % of the sea's energy is, and the straight line between these rows makes the "
      "amplitude fall from {:.3g} to {:.3g} {} there{}; if the vessel's does not, give rows between them",
      key, t.direction / kDegree, kFreedomNames[t.freedom], t.angle / kDegree, 2 * M_PI / t.to,
      2 * M_PI / t.from, 100 * energy, t.ends / unit, t.smallest / unit, rotation ? "deg/m" : "m/m",
      more > 0 ? fmt::format(" (and so in {} other place{} of the table)", more, more > 1 ? "s" : "") : "");
}

}  // namespace hawser::advice
