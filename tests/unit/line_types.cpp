// Line types given as pipes and by data-sheet weights: against pipe tables and hand calculations; refusals;
// the table of `hawser check`.
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::line_types_test {
namespace {

model::Case case_of(const std::string& keys, const std::string& sea = "water: {}") {
  return io::read_case_text(
      "hawser: 1\nenvironment: {" + sea + "}\nline_types:\n  t: {" + keys +
          "}\nlines:\n  l: {sections: [{type: t, length: 10, elements: 2}], end_a: {anchor: "
          "[0, 0, -5]}, end_b: {anchor: [9, 0, -5]}}\n",
      "types.yaml");
}

model::LineType type_of(const std::string& keys) { return case_of(keys).line_type("t"); }

std::string refusal(const std::string& keys, const std::string& sea = "water: {}") {
  try {
    case_of(keys, sea);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

void expect_refused(const std::string& keys, const std::string& why, const std::string& sea = "water: {}") {
  const std::string message = refusal(keys, sea);
  EXPECT_NE(message.find(why), std::string::npos) << keys << ": " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

const std::string kPipe = "pipe: {outer_diameter: 10.75 in, wall_thickness: 0.5 in";

// ASME B36.10: 10 inch, wall 0.500 in, 81.52 kg/m; I = 212 in^4 and A = 16.1 in^2 of its tables.
TEST(LineTypes, SteelPipe) {
  const model::LineType t = type_of(kPipe + "}");
  EXPECT_EQ(t.kind, model::LineKind::beam);
  EXPECT_NEAR(t.mass_per_length, 81.52, 0.001 * 81.52);
  EXPECT_NEAR(t.EA, 207e9 * 16.1 * 0.0254 * 0.0254, 2e-3 * t.EA);
  EXPECT_NEAR(t.EI2, 207e9 * 212 * std::pow(0.0254, 4), 2e-3 * t.EI2);
  EXPECT_EQ(t.EI2, t.EI3);
  EXPECT_NEAR(t.GJ, t.EI2 / 1.3, 1e-9 * t.GJ);  // G J = E / (2 (1 + nu)) 2 I
  EXPECT_NEAR(t.outer_diameter, 0.27305, 1e-12);
  EXPECT_NEAR(t.inner_diameter, 9.75 * 0.0254, 1e-12);
  EXPECT_NEAR(t.rotary_inertia.x(), 7850 * 2 * t.EI2 / 207e9, 1e-9);
  EXPECT_EQ(t.contact_diameter, t.outer_diameter);
}

// By hand: 3 mm of 900 kg/m³ under 50 mm of 800 kg/m³, full of oil.
TEST(LineTypes, CoatingsAndContents) {
  const model::LineType bare = type_of(kPipe + "}");
  const model::LineType t =
      type_of(kPipe +
              ", coatings: [{thickness: 3 mm, density: 900}, {thickness: 50 mm, density: "
              "800}]}, contents: {density: 870, pressure: 10 MPa}");
  const double D = 0.27305;
  const double D1 = D + 0.006;
  const double D2 = D1 + 0.1;
  const double d = D - 2 * 0.0127;
  EXPECT_NEAR(t.outer_diameter, D2, 1e-12);
  EXPECT_NEAR(t.displaced(), D2, 1e-12);
  EXPECT_NEAR(t.wall_diameter, D, 1e-12);
  EXPECT_NEAR(
      t.mass_per_length,
      bare.mass_per_length + M_PI / 4 * (900 * (D1 * D1 - D * D) + 800 * (D2 * D2 - D1 * D1) + 870 * d * d),
      1e-9);
  EXPECT_EQ(t.EI2, bare.EI2);
  EXPECT_EQ(t.EA, bare.EA);
  EXPECT_EQ(t.GJ, bare.GJ);
  EXPECT_EQ(t.contents_pressure, 1e7);
  const auto ring = [](double inner, double outer) {
    return M_PI / 32 * (std::pow(outer, 4) - std::pow(inner, 4));
  };
  EXPECT_NEAR(t.rotary_inertia.x(), bare.rotary_inertia.x() + 900 * ring(D, D1) + 800 * ring(D1, D2), 1e-9);
}

// The buoyancy of a flooded pipe is that of its wall alone.
TEST(LineTypes, Flooded) {
  const model::Case c = case_of(
      "pipe: {outer_diameter: 0.5, wall_thickness: 0.02, material: hdpe}, contents: "
      "{density: flooded}",
      "water: {density: 1000}");
  const model::LineType& t = c.line_type("t");
  const double wall = M_PI / 4 * (0.25 - 0.46 * 0.46);
  EXPECT_NEAR(t.mass_per_length - 1000 * M_PI / 4 * 0.25, (955 - 1000) * wall, 1e-9);
  EXPECT_NEAR(t.EA, 0.9e9 * wall, 1e-3);
  expect_refused(kPipe + "}, contents: {density: flooded}", "contents.density: is 'flooded', but there is no",
                 "gravity: 9.81");
}

TEST(LineTypes, Materials) {
  EXPECT_NEAR(type_of(kPipe + ", material: titanium}").EA / type_of(kPipe + "}").EA, 114. / 207, 1e-12);
  const model::LineType t = type_of(kPipe + ", material: {E: 70 GPa, density: 2700, poisson: 0.25}}");
  EXPECT_NEAR(t.GJ, t.EI2 / 1.25, 1e-9 * t.GJ);
  EXPECT_NEAR(t.mass_per_length / type_of(kPipe + "}").mass_per_length, 2700. / 7850, 1e-12);
  EXPECT_EQ(type_of(kPipe + "}, bending: false").kind, model::LineKind::cable);
}

TEST(LineTypes, ByWeights) {
  const std::string rest = ", outer_diameter: 0.25, EA: 500 MN, EI: 50 kNm2, GJ: 10 kNm2";
  const model::LineType t = type_of("weight: {in_air: 90 kgf/m, submerged: 45 kgf/m}" + rest);
  EXPECT_NEAR(t.mass_per_length, 90, 1e-9);
  EXPECT_NEAR(1025 * M_PI / 4 * t.displaced() * t.displaced(), 45, 1e-9);
  EXPECT_EQ(t.dragged(),
            0.25);  // the drag diameter is that of the outside, independent of the displaced diameter
  // The data sheet has water of 1025 kg/m³ in the hose, the case has gas.
  const double bore = M_PI / 4 * 0.01;
  const model::LineType gas = type_of(
      "weight: {in_air: 90 kgf/m, submerged: 45 kgf/m, full_of: 1025}, contents: {inner_diameter: 0.1, "
      "density: 100}" +
      rest);
  EXPECT_NEAR(gas.mass_per_length, 90 - 925 * bore, 1e-9);
  EXPECT_NEAR(gas.displaced(), t.displaced(), 1e-12);
  // The weight of the drained line in air and that of the flooded line under water include the material only,
  // and no bore is consistent with them.
  const std::string drained =
      "weight: {in_air: 338.893, submerged: 121.79}, outer_diameter: 0.3, EA: 60 MN, bending: false";
  const model::LineType open = type_of(drained);
  EXPECT_NEAR(9.80665 * (open.mass_per_length - 1025 * M_PI / 4 * open.displaced() * open.displaced()),
              121.79, 1e-9);
  expect_refused(
      drained + ", contents: {inner_diameter: 0.25, density: flooded}",
      "line_types.t.contents.inner_diameter: a bore of 0.25 m does not fit into the 0.1658 m that the line "
      "displaces by its weights: if those are of the drained line in air and of the flooded line under water "
      "leave 'contents' out, or give the weight of the empty line with closed ends as 'submerged'");
  const double closed = 121.79 - 9.80665 * 1025 * M_PI / 4 * 0.25 * 0.25;
  const model::LineType full = type_of("weight: {in_air: 338.893, submerged: " + std::to_string(closed) +
                                       "}, outer_diameter: 0.3, EA: 60 MN, bending: false, contents: "
                                       "{inner_diameter: 0.25, density: flooded}");
  EXPECT_NEAR(9.80665 * (full.mass_per_length - 1025 * M_PI / 4 * full.displaced() * full.displaced()),
              121.79, 1e-3);
  expect_refused(
      "mass_per_length: 30, displaced_diameter: 0.2, outer_diameter: 0.3, EA: 60 MN, bending: false, "
      "contents: "
      "{inner_diameter: 0.25, density: 900}",
      "a bore of 0.25 m does not fit into the 0.2 m that the line displaces: 'displaced_diameter' is that of "
      "the closed line, with its bore");
  // A floating hose.
  EXPECT_LT(type_of("weight: {in_air: 0.2 kN/m, submerged: -0.1 kN/m}" + rest).mass_per_length,
            1025 * M_PI / 4 * 0.25 * 0.25);
}

TEST(LineTypes, Refusals) {
  const std::string rest = ", outer_diameter: 0.25, EA: 500 MN, EI: 50 kNm2, GJ: 10 kNm2";
  const std::string weight = "weight: {in_air: 90 kgf/m, submerged: 45 kgf/m}";
  expect_refused(kPipe + "}, EA: 1 MN", "line_types.t.EA: 'pipe' already defines it");
  expect_refused(kPipe + "}, outer_diameter: 1", "line_types.t.outer_diameter: 'pipe' already defines");
  expect_refused(kPipe + "}, library: polyester, diameter: 0.1",
                 "line_types.t.library: 'pipe' already defines");
  expect_refused(kPipe + "}, " + weight, "line_types.t.weight: 'pipe' already defines");
  expect_refused(kPipe + "}, contents: {inner_diameter: 0.1, density: 1}",
                 "line_types.t.contents.inner_diameter: 'pipe' already defines");
  expect_refused("pipe: {outer_diameter: 0.2, wall_thickness: 0.1}", "fills the pipe of 0.2 m");
  expect_refused(kPipe + ", material: stel}", "did you mean 'steel'");
  expect_refused(weight + rest + ", mass_per_length: 90",
                 "line_types.t.mass_per_length: 'weight' already defines");
  expect_refused(weight + ", library: polyester, diameter: 0.1",
                 "line_types.t.library: 'weight' already defines");
  expect_refused(weight + ", EA: 5 MN", "line_types.t.outer_diameter: required key is missing");
  expect_refused("weight: {in_air: 45 kgf/m, submerged: 90 kgf/m}" + rest,
                 "is not less than the weight in air");
  expect_refused("weight: {in_air: 90 kgf/m, submerged: 10 kgf/m}" + rest,
                 "but its outer_diameter is 0.25 m");
  expect_refused(
      "weight: {in_air: 90 kgf/m, submerged: 45 kgf/m, full_of: 1e5}, contents: {inner_diameter: 0.1, "
      "density: 1}" +
          rest,
      "weighs more than the line full of it");
  expect_refused(weight + rest + ", contents: {density: 1000}", "the diameter of the bore");
  expect_refused("outer_diameter: 0.1, EA: 1 MN", "mass_per_length (or weight)");
}

// The first row of a plasticity table is the bending stiffness, with `EI` or without.
TEST(LineTypes, StiffnessOfATableOfPlasticity) {
  const std::string rest = "mass_per_length: 90, outer_diameter: 0.25, EA: 500 MN, GJ: 10 kNm2",
                    table = ", plasticity: {table: [[0.01, 500], [0.1, 2000]]}";
  for (const std::string EI : {"", ", EI: 51 kNm2"}) {
    const model::LineType t = type_of(rest + EI + table);
    EXPECT_NEAR(t.EI2, 50e3, 1e-6) << EI;
    EXPECT_EQ(t.EI3, t.EI2);
  }
  expect_refused(rest + ", EI: 60 kNm2" + table, "its first row makes EI 5e+04 N m2, but the type has 6e+04");
  expect_refused(rest + ", plasticity: {ramberg_osgood: {yield_moment: 600, A: 0.4, B: 12}}",
                 "line_types.t.EI: required key is missing");
}

TEST(LineTypes, TableOfTheCheck) {
  const std::string table = model::line_type_table(
      case_of("weight: {in_air: 900, submerged: 450}, outer_diameter: 0.25, EA: 500 MN, EI: 50 kNm2, GJ: 10 "
              "kNm2, breaking_load: 2 MN, minimum_bend_radius: 3.5"));
  EXPECT_NE(
      table.find("t              91.77        900        450       5e+05          50       2000       3.5\n"),
      std::string::npos)
      << table;
  const std::string dry = model::line_type_table(case_of(kPipe + "}", "gravity: 9.81"));
  EXPECT_NE(dry.find(" - "), std::string::npos) << dry;
}

}  // namespace
}  // namespace hawser::line_types_test
