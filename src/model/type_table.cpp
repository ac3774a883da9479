// Table of line types for `hawser check`: mass, weights and strength.
#include <fmt/format.h>

#include <cmath>

#include "hawser/model/summary.hpp"

namespace hawser::model {

std::string line_type_table(const Case& c) {
  std::size_t width = 9;
  for (const LineType& t : c.line_types) width = std::max(width, t.name.size());
  std::string s = fmt::format("{:<{}} {:>10} {:>10} {:>10} {:>11} {:>11} {:>10} {:>9}\n", "line type", width,
                              "mass", "in air", "submerged", "EA", "EI", "MBL", "min bend");
  s += fmt::format("{:<{}} {:>10} {:>10} {:>10} {:>11} {:>11} {:>10} {:>9}\n", "", width, "kg/m", "N/m",
                   "N/m", "kN", "kN m²", "kN", "radius m");
  const auto known = [](double value, double unit = 1) {
    return value > 0 ? fmt::format("{:.4g}", value / unit) : std::string("-");
  };
  const Water& water = c.environment.water;
  for (const LineType& t : c.line_types) {
    const double g = c.environment.gravity;
    const double air = t.mass_per_length * g;
    const double submerged = air - water.density * g * M_PI / 4 * t.displaced() * t.displaced();
    const bool beam = t.kind == LineKind::beam;
    const std::string EI = !beam            ? "-"
                           : t.EI2 == t.EI3 ? known(t.EI2, 1e3)
                                            : known(t.EI2, 1e3) + "/" + known(t.EI3, 1e3);
    s += fmt::format("{:<{}} {:>10.4g} {:>10.4g} {:>10} {:>11} {:>11} {:>10} {:>9}\n", t.name, width,
                     t.mass_per_length, air,
                     water.present ? fmt::format("{:.4g}", submerged) : std::string("-"), known(t.EA, 1e3),
                     EI, known(t.breaking_load, 1e3), known(t.minimum_bend_radius));
  }
  return s;
}

}  // namespace hawser::model
