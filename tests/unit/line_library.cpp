// Line types from the library: values against the tables they come from, keys of the case that override them,
// and consistency of all entries.
#include "hawser/io/line_library.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "hawser/io/case_reader.hpp"

namespace hawser::line_library_test {
namespace {

model::LineType type_of(const std::string& keys) {
  const std::string text =
      "hawser: 1\nline_types:\n  t: {" + keys +
      "}\nlines:\n  l: {sections: [{type: t, length: 10, elements: 2}], end_a: {anchor: [0, 0, "
      "0]}, end_b: {anchor: [6, 0, 0]}}\n";
  return io::read_case_text(text, "library.yaml").line_type("t");
}

// Breaking loads of a chain maker's table for 50 mm and 70 mm (R3, R3S, R4), kN; mass of the same chain by
// 19.9 and 21.9 t/m times d².
TEST(LineLibrary, ChainByGradeAndDiameter) {
  const auto kN = [](const char* grade, const char* d) {
    return type_of(std::string("library: chain-studless, grade: ") + grade + ", diameter: " + d)
               .breaking_load /
           1000;
  };
  EXPECT_NEAR(kN("R3", "50 mm"), 2230, 1);
  EXPECT_NEAR(kN("R3S", "50 mm"), 2490, 1);
  EXPECT_NEAR(kN("R4", "0.05"), 2740, 1);
  EXPECT_NEAR(kN("R3", "70 mm"), 4196, 1);
  EXPECT_NEAR(kN("R3S", "70 mm"), 4686, 1);
  const model::LineType t = type_of("library: chain-studlink, grade: R4, diameter: 84 mm");
  EXPECT_EQ(t.kind, model::LineKind::cable);
  EXPECT_NEAR(t.mass_per_length, 21.9e3 * 0.084 * 0.084, 1e-9);
  EXPECT_NEAR(t.EA, 1.01e11 * 0.084 * 0.084, 1);
  EXPECT_NEAR(t.outer_diameter, 1.89 * 0.084, 1e-12);
  EXPECT_NEAR(t.drag_diameter, 0.084, 1e-12);
  EXPECT_EQ(t.Cd_normal, 2.6);
  // The displaced volume is that of the steel.
  const double steel = t.mass_per_length / (M_PI / 4 * t.displaced() * t.displaced());
  EXPECT_NEAR(steel, 7850, 0.01 * 7850);
}

TEST(LineLibrary, KeysOfTheCaseTakePrecedence) {
  const model::LineType t =
      type_of("library: polyester, diameter: 0.2, EA: 200 MN, Cd_normal: 1.2, drag_diameter: 0.21");
  EXPECT_EQ(t.EA, 2e8);
  EXPECT_EQ(t.Cd_normal, 1.2);
  EXPECT_EQ(t.drag_diameter, 0.21);
  EXPECT_NEAR(t.breaking_load, 308.2e6 * 0.04, 1);
  EXPECT_NEAR(t.mass_per_length / (M_PI / 4 * t.displaced() * t.displaced()), 1380, 1);
  EXPECT_NEAR(type_of("library: polyester, diameter: 0.2").EA, 14 * 308.2e6 * 0.04, 1);
  const model::LineType beam =
      type_of("library: wire-six-strand, diameter: 0.1, bending: true, EI: 5e3, GJ: 1e3");
  EXPECT_EQ(beam.kind, model::LineKind::beam);
  EXPECT_EQ(beam.EI2, 5e3);
  EXPECT_GT(beam.rotary_inertia.x(), 0);
}

TEST(LineLibrary, ThePageOfTheUserGuideIsWhatTheProgramWrites) {
  std::ifstream in(HAWSER_SOURCE_DIR "/docs/user-guide/line-types.md");
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), io::line_library_markdown()) << "run: hawser library > docs/user-guide/line-types.md";
}

TEST(LineLibrary, EveryEntryIsWhole) {
  for (const std::string& name : io::line_library_names()) {
    const bool chain = name.starts_with("chain");
    const model::LineType t = type_of("library: " + name + ", diameter: 0.1" + (chain ? ", grade: R4" : ""));
    const double density = t.mass_per_length / (M_PI / 4 * t.displaced() * t.displaced());
    EXPECT_GT(density, 1000) << name;
    EXPECT_LT(density, 8500) << name;
    EXPECT_GT(t.EA, 4 * t.breaking_load) << name;
    EXPECT_NE(io::line_library_markdown().find("`" + name + "`"), std::string::npos);
  }
}

}  // namespace
}  // namespace hawser::line_library_test
