// Keys of line types: sections by properties, pipes by walls, hoses and umbilicals by weights.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

constexpr const char* kFromPipe = "none: needed unless `library` or `pipe`";
constexpr const char* kStiffness = "none: needed unless `bending: false` or `pipe`";

Key condition(const char* where, double PipeConditions::*factor, const char* about, auto fallback) {
  return number({where, within(&LineType::conditions, factor)}, none, about, in_range(0.5, 2), fallback);
}

Key pipe() {
  return map(
      "pipe",
      {number("outer_diameter", length, "outer diameter of the pipe wall, without coatings", above(0),
              required, fixed_in_restart),
       number("wall_thickness", length, "thickness of the pipe wall", above(0), required, fixed_in_restart),
       one_of("material",
              {word("", {"steel", "titanium", "hdpe"}),
               map("", {number("E", pressure, "modulus of elasticity", above(0), required),
                        number("density", density, "density of the wall", above(0), required),
                        number("poisson", none, "Poisson's ratio", in_range(0, 0.5), or_else("0.3"))})},
              "material of the wall: a name of the "
              "[guide](case-file/line-types.md#pipes-hoses-and-umbilicals), or its properties",
              or_else("steel"), fixed_in_restart),
       word("grade", {"X42", "X46", "X52", "X56", "X60", "X65", "X70", "X80"},
            "steel grade of API 5L: with it the pipe is checked by [codes](reports.md#strength-of-pipes) at "
            "every step"),
       word("safety_class", {"low", "medium", "high"}, "safety class of DNV-ST-F101", or_else("low")),
       word("fabrication", {"seamless", "UO", "UOE"}, "fabrication method, for DNV-ST-F101 and API RP 1111",
            or_else("UOE")),
       number("ovality", none, "(D_max - D_min) / D of DNV-ST-F101", in_range(0.005, 0.03), or_else("0.015")),
       number("material_factor", none, "alpha_U of DNV-ST-F101", in_range(0.5, 2), or_else("0.96")),
       map("condition_factor",
           {condition("supports", &PipeConditions::supports,
                      "for the part between supports that carry the pipe", or_else("1")),
            condition("span", &PipeConditions::span, "for the free span", or_else("1")),
            condition("seabed", &PipeConditions::seabed, "for the part between touchdown points",
                      or_else_note("1, on a measured seabed (`grid`, `mesh`) 1.07"))},
           "condition load effect factor gamma_C of functional loads, of DNV-ST-F101"),
       list("coatings",
            map("", {number("thickness", length, "thickness of the layer", above(0), required),
                     number("density", density, "density of the layer", above(0), required)}),
            "layers on the wall, from the inside to the outside: they add mass and diameter, no stiffness",
            or_else("[]"), fixed_in_restart)},
      "a pipe; mass, diameters, `EA`, `EI`, `GJ` and the bore of `contents` follow from it");
}

Key weight() {
  return map(
      "weight",
      {number("in_air", force_per_length, "weight in air", above(0), required),
       number("submerged", force_per_length, "submerged weight; negative: the line floats", required),
       number("full_of", density,
              "density of the contents that these weights include; it is subtracted if `contents` are given",
              above(0), or_else_note("0: the weights are those of the empty line")),
       number("water_density", density, "density of the water for `submerged`", above(0), or_else("1025"))},
      "weights per length of a data sheet; `mass_per_length` and `displaced_diameter` follow from them",
      fixed_in_restart);
}

Key plasticity() {
  return map(
      "plasticity",
      {map("ramberg_osgood",
           {number("yield_moment", moment, "yield moment M_y", above(0), required),
            number("A", none, "coefficient A: plastic over elastic curvature at M_y", above(0), required),
            number("B", none, "exponent B of the plastic part, above 1", above(1), required)},
           "curvature over moment, κ/κ_y = M/M_y + A (M/M_y)^B with κ_y = M_y/EI, up to a bending strain of "
           "5 %"),
       rows("table",
            "bending moment against curvature, `[[1/m, N m], ...]`, for the first loading: linear between "
            "rows and beyond the last, with a slope that never increases; the slope of its first row is "
            "`EI`, which need not be given, and otherwise must agree to 5 %",
            items(2))},
      "elastic-plastic bending with hysteresis, the same in all directions "
      "([theory](../theory/plastic-bending.md))",
      fixed_in_restart);
}

void bending(LineType& t, const Value& v) { t.kind = v.number != 0 ? LineKind::beam : LineKind::cable; }

void tensions(LineType& t, const Value& v) {
  t.tension_table = std::make_shared<const ResponseCurve>(v.rows(), false);
  t.EA = t.tension_table->initial();
}
void moments(LineType& t, const Value& v) {
  t.moment_table = std::make_shared<const ResponseCurve>(v.rows(), true);
  t.EI2 = t.EI3 = t.moment_table->initial();
}
void two_axes(LineType& t, const Value& v) {
  t.EI2 = v.items[0].number;
  t.EI3 = v.items[1].number;
}

}  // namespace

Key line_types() {
  std::vector<Key> keys = {
      text("library",
           "takes the properties that are not given here from the [library](line-types.md) of chains and "
           "ropes",
           fixed_in_restart),
      number("diameter", length, "nominal diameter in the library: for a chain the bar diameter", above(0),
             fixed_in_restart),
      text("grade", "chain grade in the library: `R3`, `R3S`, `R4`, `R4S` or `R5`", fixed_in_restart),
      pipe(),
      weight(),
      number({"outer_diameter", &LineType::outer_diameter, &LineType::contact_diameter}, length,
             "outer diameter", above(0), or_else_note(kFromPipe), fixed_in_restart),
      number({"contact_diameter", &LineType::contact_diameter}, length, "diameter for contact", above(0),
             or_else_note("same as `outer_diameter`")),
      number({"mass_per_length", &LineType::mass_per_length}, mass_per_length,
             "mass in air, without `contents` and `marine_growth`", above(0),
             or_else_note("none: needed unless `library`, `pipe` or `weight`"), fixed_in_restart),
      boolean(
          {"bending", set_by<LineType>(bending)},
          "`false` makes a cable: it has axial stiffness only and may go slack; its nodes have no rotations",
          or_else_note("`true`; `false` with `library`")),
      one_of("EA",
             {number({"", &LineType::EA}, force, above(0)),
              map("", {rows({"table", set_by<LineType>(tensions)},
                            "tension against strain, `[[strain, N], ...]`, increasing through zero: a "
                            "monotone cubic, elastic, linear beyond the rows",
                            required, items(1))})},
             "axial stiffness", or_else_note(kFromPipe), fixed_in_restart),
      one_of("EI",
             {number({"", &LineType::EI2, &LineType::EI3}, bending_stiffness, above(0)),
              list({"", set_by<LineType>(two_axes)}, number("", bending_stiffness, above(0)), items(2, 2)),
              map("", {rows({"table", set_by<LineType>(moments)},
                            "bending moment against curvature, `[[1/m, N m], ...]`, increasing from zero and "
                            "the same in all directions: a monotone cubic, elastic, linear beyond the rows",
                            required, items(1))})},
             "bending stiffness, or `[EI2, EI3]` about the section's axes 2 and 3",
             or_else_note("none: needed unless `bending: false`, `pipe` or a table of `plasticity`"),
             fixed_in_restart),
      plasticity(),
      number({"GJ", &LineType::GJ}, bending_stiffness, "torsional stiffness", above(0),
             or_else_note(kStiffness), fixed_in_restart),
      number({"GA", &LineType::GA}, force, "shear stiffness; 0: rigid in shear (Euler-Bernoulli)",
             at_least(0), or_else("0"), fixed_in_restart),
      vec3({"rotary_inertia", &LineType::rotary_inertia}, inertia_per_length,
           "rotary inertia per length about axes 1 (along the line), 2 and 3", at_least(0),
           or_else_note("that of a solid circular section: m d²/8, m d²/16, m d²/16; for a `pipe` that of "
                        "its wall and coatings")),
      number({"stiffness_damping", &LineType::stiffness_damping}, time,
             "Rayleigh damping beta: damping = beta times the material stiffness; in a cable it is at most "
             "the tension",
             at_least(0), or_else("0")),
      number({"thermal_expansion", &LineType::thermal_expansion}, thermal_expansion,
             "strain per kelvin of the line's `temperature_change`: 1.17e-5 for steel; may be negative",
             or_else("0")),
      number({"breaking_load", &LineType::breaking_load}, force,
             "minimum breaking load, for the utilisation in the summary; the line does not break", above(0),
             or_else_note("that of `library`; otherwise none")),
      number({"minimum_bend_radius", &LineType::minimum_bend_radius}, length,
             "minimum allowed bend radius, for the utilisation in the summary; the line does not break",
             above(0), or_else_note("none"))};
  for (Key& k : in_water()) keys.push_back(std::move(k));
  return map_by_name("line_types", map("<type>", std::move(keys)), "Properties of lines, by name.",
                     or_else("{}"));
}

}  // namespace hawser::model::schema_build
