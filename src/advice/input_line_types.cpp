// Consistency of mass, diameter and EA of a line type by density and modulus. Steel: 7850 kg/m³ and 206 GPa
// (DNV-OS-E301); the diameter of a chain is that of a round bar of equal volume, 1.8 times its bar.
// Plausibility of contents and coatings.
#include <fmt/format.h>

#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/model/farm.hpp"
#include "unit_hint.hpp"

namespace hawser::advice {

using namespace model;

namespace {

constexpr double kHeavy = 8500, kLight = 100;  // kg/m³, mean density including the bore
// In air the diameter may be nominal, that of a chain's bar: 25 t/m³.
constexpr double kHeavyInAir = 30000;
constexpr double kThick = 5;  // m
// Density of contents, kg/m³: pressurised gas has 50 or more, the heaviest drilling mud 2400.
constexpr double kLeastContents = 10, kMostContents = 5000;
constexpr double kStiff = 250e9, kSoft = 5e5;  // Pa

bool in_range(double x, double lower, double upper) { return x >= lower && x <= upper; }

// Unit in which the mass or diameter would be plausible.
std::string density_hint(const Case& c, const LineType& t, double density, bool water) {
  const double d = t.displaced();
  const auto fits = [water](double x) { return in_range(x, kLight, water ? kHeavy : kHeavyInAir); };
  const auto hint_for = [&](const char* key, FunctionRef<bool(double)> fit) {
    return unit_hint(c, {"line_types", t.name, key}, fit);
  };
  if (t.kind == LineKind::cable && water && density > kHeavy && density < kHeavyInAir)
    return "; for a chain give the diameter of a round bar of equal volume, 1.8 times the diameter of its "
           "own bar";
  if (std::string hint = hint_for("mass_per_length", [&](double m) { return fits(m / (M_PI / 4 * d * d)); });
      !hint.empty())
    return hint;
  if (std::string hint = hint_for(t.displaced() == t.outer_diameter ? "outer_diameter" : "displaced_diameter",
                                  [&](double x) { return fits(t.mass_per_length / (M_PI / 4 * x * x)); });
      !hint.empty())
    return hint;
  return "; check both";
}

void warn_of_contents(const LineType& t, std::vector<InputWarning>& out) {
  const double density = t.contents_density;
  if (!(density > 0) || in_range(density, kLeastContents, kMostContents)) return;
  std::string hint = "is it meant?";
  if (in_range(density * 1000, kLeastContents, kMostContents))
    hint = fmt::format("is it in t/m³ or g/cm³? ('{:g} kg/m3')", density * 1000);
  add_warning(out, fmt::format("line_types.{}.contents.density", t.name), Effect::all,
              "{:g} kg/m³ is {} than usual contents of pipes ({:g} to {:g}); {}", density,
              density < kLeastContents ? "lighter" : "heavier", kLeastContents, kMostContents, hint);
}

// Coatings thicker than half the pipe, by the keys of the file because the type has only sums.
bool warn_of_coatings(const Case& c, const LineType& t, std::vector<InputWarning>& out) {
  const Entry type = entry_of(c, "line_types", t.name);
  const Value* pipe = type ? type->find("pipe") : nullptr;
  const Value* coatings = pipe ? pipe->find("coatings") : nullptr;
  if (!coatings) return false;
  const std::size_t before = out.size();
  const double D = (*pipe)["outer_diameter"].number;
  for (std::size_t i = 0; i < coatings->items.size(); ++i)
    if (const double thickness = coatings->items[i]["thickness"].number; thickness > D / 2)
      add_warning(
          out, fmt::format("line_types.{}.pipe.coatings[{}].thickness", t.name, i), Effect::all,
          "a coating of {:.4g} m is thicker than half of the pipe of {:.4g} m; is it in mm? ('{:g} mm')",
          thickness, D, thickness);
  return out.size() > before;
}

// Pipes outside the range of the code formulas.
void warn_of_slenderness(const LineType& t, std::vector<InputWarning>& out) {
  if (!t.steel) return;
  const double slender = std::round(t.steel->slenderness() * 1e6) / 1e6;
  const auto warn = [&](const std::string& range, const char* field) {
    add_warning(out, fmt::format("line_types.{}.pipe.wall_thickness", t.name), Effect::all,
                "D/t is {:.3g}, and {}: {} does not apply to this pipe; give it another wall thickness, or "
                "check it by other means",
                slender, range, field);
  };
  if (slender > kMaxSlender || slender < kMinSlender)
    warn(fmt::format("DNV-ST-F101's formulas for combined loads apply from {:g} to {:g}", kMinSlender,
                     kMaxSlender),
         "'dnv_local_buckling'");
  if (slender > kMaxSlenderApi)
    warn(fmt::format("API RP 1111's formula for bending with pressure applies up to {:g}", kMaxSlenderApi),
         "'api_bending_pressure'");
}

}  // namespace

void warn_of_line_types(const Case& c, std::vector<InputWarning>& out) {
  const bool water = c.environment.water.present;
  for (const LineType& t : c.line_types) {
    warn_of_contents(t, out);
    warn_of_slenderness(t, out);
    if (warn_of_coatings(c, t, out)) continue;  // all else is a consequence
    const std::string key = "line_types." + t.name;
    const double d = t.displaced();
    const double density = t.mass_per_length / (M_PI / 4 * d * d);
    if (density > (water ? kHeavy : kHeavyInAir) || density < kLight)
      add_warning(
          out, key, Effect::all, "{:.4g} kg/m in a diameter of {:.4g} m is a density {}, {}{}",
          t.mass_per_length, d,
          std::isfinite(density) ? fmt::format("of {:.3g} t/m³", density / 1000) : "beyond any material",
          density < kLight ? "less than any line (0.1) except an inflated one" : "more than steel (7.85)",
          density_hint(c, t, density, water));
    else if (t.outer_diameter > kThick)
      add_warning(out, key, Effect::all,
                  "an outer diameter of {:.4g} m is more than that of any pipe, hose or rope; "
                  "is it in mm? ('{:.4g} mm')",
                  t.outer_diameter, t.outer_diameter);
    const double D = t.outer_diameter;
    const double modulus = t.EA / (M_PI / 4 * D * D);
    if (modulus > kStiff)
      add_warning(out, key, Effect::all,
                  "an EA of {:.4g} N over a diameter of {:.4g} m is a modulus of {:.3g} GPa; "
                  "that of a solid steel bar is 206, of wire rope and chain 20 to 130",
                  t.EA, D, modulus / 1e9);
    if (modulus < kSoft)
      add_warning(out, key, Effect::all,
                  "an EA of {:.4g} N over a diameter of {:.4g} m is a modulus of {:.3g} MPa, less than "
                  "that of rubber (1 to 10){}",
                  t.EA, D, modulus / 1e6, unit_hint(c, {"line_types", t.name, "EA"}, [&](double x) {
                    return in_range(x / (M_PI / 4 * D * D), 1e8, kStiff);
                  }));
  }
}

}  // namespace hawser::advice
