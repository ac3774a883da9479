// Whether mass, diameter and EA of a line type are those of one thing: by density and modulus. Steel: 7850
// kg/m³ and 206 GPa (DNV-OS-E301); the diameter of a chain is that of a round bar of its volume, 1.8 times
// that of its bar.
#include <fmt/format.h>

#include <cmath>

#include "hawser/model/doubts.hpp"

namespace hawser::model {
namespace {

constexpr double kHeavy = 8500, kLight = 100;  // kg/m³, mean density of a line with its bore
// In air the diameter may be nominal, that of a chain's bar: 25 t/m³.
constexpr double kHeavyInAir = 30000;
constexpr double kThick = 5;                   // m
constexpr double kStiff = 250e9, kSoft = 1e5;  // Pa

bool in_range(double x, double least, double most) { return x >= least && x <= most; }

std::string density_hint(double density, bool water) {
  if (density > kHeavy) {
    if (water && density < kHeavyInAir)
      return "; a chain has here the diameter of a round bar of its volume, 1.8 times that of its bar";
    if (in_range(density / 1000, kLight, kHeavyInAir)) return "; is the mass in kg/km? ('219 kg/km')";
  } else {
    if (in_range(density * 1e6, kLight, kHeavyInAir)) return "; is the diameter in mm? ('120 mm')";
    if (in_range(density * 1000, kLight, kHeavyInAir)) return "; is the mass in t/m? ('0.2 t/m')";
  }
  return "; check both";
}

}  // namespace

void doubt_line_types(const Case& c, std::vector<Doubt>& out) {
  const bool water = c.environment.water.present;
  for (const LineType& t : c.line_types) {
    const std::string key = "line_types." + t.name;
    const double d = t.displaced(), density = t.mass_per_length / (M_PI / 4 * d * d);
    if (density > (water ? kHeavy : kHeavyInAir) || density < kLight)
      out.push_back({key,
                     fmt::format("{:.4g} kg/m in a diameter of {:.4g} m are {:.3g} t/m³, {}{}",
                                 t.mass_per_length, d, density / 1000,
                                 density < kLight ? "less than any line (0.1) but an inflated one"
                                                  : "more than steel (7.85)",
                                 density_hint(density, water)),
                     1});
    else if (t.outer_diameter > kThick)
      out.push_back(
          {key,
           fmt::format("an outer diameter of {:.4g} m is more than that of any pipe, hose or rope; is "
                       "it in mm? ('{:g} mm')",
                       t.outer_diameter, t.outer_diameter),
           0});
    const double D = t.outer_diameter, modulus = t.EA / (M_PI / 4 * D * D);
    if (modulus > kStiff)
      out.push_back(
          {key,
           fmt::format("an EA of {:.4g} N over a diameter of {:.4g} m is a modulus of {:.3g} GPa; that "
                       "of a solid steel bar is 206, of wire rope and chain 20 to 130",
                       t.EA, D, modulus / 1e9),
           2});
    if (modulus < kSoft)
      out.push_back(
          {key,
           fmt::format("an EA of {:.4g} N over a diameter of {:.4g} m is a modulus of {:.3g} MPa, less "
                       "than that of rubber (1 to 10){}",
                       t.EA, D, modulus / 1e6,
                       modulus * 1000 > 1e6 ? "; is the EA in kN or MN? ('900 MN')" : "; check both"),
           2});
  }
}

}  // namespace hawser::model
