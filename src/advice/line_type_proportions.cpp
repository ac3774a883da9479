// Proportions of line types that no section of any material has: stiffnesses, diameters, strength and bend
// radius. Mass and EA over the area: input_line_types.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/model/farm.hpp"
#include "unit_hint.hpp"

namespace hawser::advice {

using namespace model;

namespace {

bool between(double x, double lower, double upper) { return x >= lower && x <= upper; }

class Proportions {
 public:
  Proportions(const Case& c, const LineType& t, std::vector<InputWarning>& out)
      : c_(c), t_(t), key_("line_types." + t.name), out_(out) {}

  void run() {
    // If mass, diameter and EA are already inconsistent, the rest is a consequence.
    const auto known = [this](const InputWarning& d) { return d.key == key_; };
    if (std::any_of(out_.begin(), out_.end(), known)) return;
    if (t_.kind == LineKind::beam) {
      bending();
      torsion();
      shear();
      curvatures();
    }
    strength();
    softness();
    diameter(t_.displaced(), "displaced_diameter", 0.4, 2);
    diameter(t_.dragged(), "drag_diameter", 0.2, 5);
    diameter(t_.contact_diameter, "contact_diameter", 0.2, 5);
    bend_radius();
    wall();
    strains();
  }

 private:
  template <class... Args>
  void warn(const char* key, fmt::format_string<Args...> sentence, Args&&... args) {
    add_warning(out_, key_ + (*key ? "." : "") + key, Effect::all, sentence, std::forward<Args>(args)...);
  }
  std::string hint(const char* key, FunctionRef<bool(double)> fits) const {
    return unit_hint(c_, {"line_types", t_.name, key}, fits);
  }
  // Radius of gyration of the bending stiffness [m].
  double gyration(double EI) const { return std::sqrt(EI / t_.EA); }

  // All stiffness is within D/2 of the axis: EI2 + EI3 = sum of E A r² <= EA D²/4. A bundle of loose wires of
  // diameter d has EI = EA d²/16, with at most 10^4 wires: d >= D/125.
  void bending() {
    // EA of spiral ropes and hoses is reduced by their lay; benchmark rods and hulls modelled as lines reach
    // 12 times the bound. kN in place of N makes a factor of 1000.
    constexpr double kTolerance = 13;
    const double D = t_.outer_diameter;
    const double EI = 0.5 * (t_.EI2 + t_.EI3);
    const double upper = kTolerance * D * D / 8;
    const double lower = std::pow(D / 125, 2) / 16;
    if (between(EI / t_.EA, lower, upper)) return;
    const auto fits = [&](double x) { return between(x / t_.EA, lower, upper); };
    if (EI / t_.EA > upper)
      warn("EI",
           "with its EA it means a radius of gyration sqrt(EI/EA) of {:.3g} m, and a section {:.4g} m in "
           "diameter has {:.3g} m at most{}",
           gyration(EI), D, D / std::sqrt(8.0), hint("EI", fits));
    else
      warn("EI",
           "{:.3g} N m² with an EA of {:.3g} N is the stiffness of loose wires of {:.2g} mm in a diameter of "
           "{:.4g} m{}",
           EI, t_.EA, 4000 * gyration(EI), D, hint("EI", fits));
  }

  // Round sections have GJ/EI = 1/(1 + nu) = 0.67 to 1; helical armour increases it up to 300.
  void torsion() {
    const double EI = 0.5 * (t_.EI2 + t_.EI3);
    const double lower = 0.05;
    const double upper = 500;
    if (between(t_.GJ / EI, lower, upper)) return;
    warn("GJ", "{:.4g} N m² is {:.2g} times EI: round sections have 0.7 to 1, armoured cables up to 300{}",
         t_.GJ, t_.GJ / EI, hint("GJ", [&](double x) { return between(x / EI, lower, upper); }));
  }

  // G is below E.
  void shear() {
    if (t_.GA == 0 || between(t_.GA / t_.EA, 1e-4, 1)) return;
    warn("GA", "{:.4g} N is {:.2g} times EA, and the shear stiffness of a section is 0.1 to 0.5 of it{}",
         t_.GA, t_.GA / t_.EA, hint("GA", [&](double x) { return between(x / t_.EA, 1e-4, 1); }));
  }

  // Strain of the outer fibre at the end of bending tables.
  void curvatures() {
    double last = 0;  // 1/m
    const char* key = "EI";
    if (t_.moment_table) last = t_.moment_table->last();
    if (t_.plastic_bending) {
      last = t_.plastic_bending->last();
      key = "plasticity";
    }
    const double strain = 0.5 * last * t_.outer_diameter;
    if (last == 0 || between(strain, 1e-5, 2)) return;
    warn(key,
         "its table ends at {:.4g} 1/m, a strain of {:.2g} in a diameter of {:.4g} m: are the columns 1/m "
         "and N m?",
         last, strain, t_.outer_diameter);
  }

  // Linear breaking strain: steel 0.2 % and more, nylon 40 %.
  void strength() {
    if (!(t_.breaking_load > 0) || t_.tension_table) return;
    const double strain = t_.breaking_load / t_.EA;
    const double lower = 5e-4;
    const double upper = 1;
    if (between(strain, lower, upper)) return;
    const std::string of_load =
        hint("breaking_load", [&](double x) { return between(x / t_.EA, lower, upper); });
    warn("breaking_load",
         "{:.4g} N over an EA of {:.4g} N is a strain of {:.2g} %; lines break at 0.2 to 50 %{}",
         t_.breaking_load, t_.EA, 100 * strain, of_load);
  }

  // Metals reach this density, and none is so soft; chains have 30 GPa over this diameter, wire ropes 50.
  void softness() {
    constexpr double kDense = 3500, kSoft = 1e8;  // kg/m³, Pa
    const double D = t_.outer_diameter;
    const double area = M_PI / 4 * D * D;
    if (!(t_.mass_per_length / area > kDense) || !(t_.EA / area < kSoft)) return;
    warn("EA",
         "{:.4g} N over {:.4g} m is a modulus of {:.3g} MPa, and {:.3g} t/m³ are metal, of 20 GPa and more{}",
         t_.EA, D, t_.EA / area / 1e6, t_.mass_per_length / area / 1000,
         hint("EA", [&](double x) { return between(x / area, 5e9, 250e9); }));
  }

  void diameter(double d, const char* key, double lower, double upper) {
    const double ratio = d / t_.outer_diameter;
    if (between(ratio, lower, upper)) return;
    if (std::string_view(key) == "displaced_diameter" && !given(key))
      return warn(
          "", "its mass and weight mean a displaced diameter of {:.4g} m, and its outer diameter is {:.4g} m",
          d, t_.outer_diameter);
    if (!given(key)) return;  // another key is the implausible one
    warn(key, "{:.4g} m is {:.2g} times the outer diameter; {:g} to {:g} times are usual{}", d, ratio, lower,
         upper, hint(key, [&](double x) { return between(x / t_.outer_diameter, lower, upper); }));
  }
  bool given(const char* key) const {
    const Entry type = entry_of(c_, "line_types", t_.name);
    const Value* v = type ? type->find(key) : nullptr;
    return v && v->given;
  }

  // In diameters: ropes and hoses 2 to 20, steel pipes 100 to 300 (strains of 0.2 to 0.5 %).
  void bend_radius() {
    if (!(t_.minimum_bend_radius > 0)) return;
    const double ratio = t_.minimum_bend_radius / t_.outer_diameter;
    const double lower = 0.5;
    const double upper = 2000;
    if (between(ratio, lower, upper)) return;
    warn("minimum_bend_radius", "{:.4g} m is {:.2g} diameters; lines may be bent to 2 to 500 diameters{}",
         t_.minimum_bend_radius, ratio,
         hint("minimum_bend_radius", [&](double x) { return between(x / t_.outer_diameter, lower, upper); }));
  }

  // For pipes without code checks.
  void wall() {
    if (t_.steel || !given("pipe") || !(t_.wall_diameter > t_.inner_diameter)) return;
    const double slender = t_.wall_diameter / (0.5 * (t_.wall_diameter - t_.inner_diameter));
    if (slender > 150)
      warn("pipe.wall_thickness",
           "D/t is {:.3g}; usual pipes have 5 to 60, and above 150 the wall buckles as a thin shell",
           slender);
  }

  void strains() {
    if (!t_.tension_table || !(t_.tension_table->last() > 3)) return;
    warn("EA", "its table goes up to a strain of {:g}, which is {:g} times its length: are the strains in %?",
         t_.tension_table->last(), 1 + t_.tension_table->last());
  }

  const Case& c_;
  const LineType& t_;
  std::string key_;
  std::vector<InputWarning>& out_;
};

}  // namespace

void warn_of_proportions(const Case& c, std::vector<InputWarning>& out) {
  for (const LineType& t : c.line_types) Proportions(c, t, out).run();
}

}  // namespace hawser::advice
