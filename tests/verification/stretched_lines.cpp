// Lines much shorter than the distance of their ends: rubber and elastomers, by a constant EA and by a table.
#include <gtest/gtest.h>

#include <string>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "support/rig.hpp"

namespace hawser::test::stretched_lines_test {
namespace {

model::Case tether(const std::string& EA, double length, double diameter = 0.01) {
  return io::read_case_text(
      "hawser: 1\nenvironment: {gravity: 0}\nline_types:\n  tether: {outer_diameter: " +
          std::to_string(diameter) + ", mass_per_length: 0.09, bending: false, EA: " + EA +
          "}\nlines:\n  tether:\n    sections: [{type: tether, length: " + std::to_string(length) +
          ", elements: 10}]\n    end_a: {anchor: [0, 0, 0]}\n"
          "    end_b: {anchor: [0, 0, 1.5]}\n",
      "/nowhere/case.yaml");
}

double tension(const model::Case& c) {
  Simulation s(PETSC_COMM_SELF, c);
  s.solve_statics();
  return Eigen::Map<const Vec3>(s.system().reactions().data() + 3 * s.local().block[10]).norm();
}

// Tension EA times strain: 500 N (1.5/1.3 - 1), and by the linear table through (1.2, 600 N).
TEST(StretchedLines, ByEAAndByATable) {
  EXPECT_NEAR(tension(tether("500", 1.3)), 76.923, 1e-3);
  const std::string table = "{table: [[0.5, 250], [1.0, 500], [1.5, 750]]}";
  EXPECT_NEAR(tension(tether(table, 0.7)), 500 * (1.5 / 0.7 - 1), 0.05);
}

// Errors for strains that no material bears, probably misprints: 10 % for metal, 50 % for a constant EA, and
// for a table 50 % beyond its last row.
TEST(StretchedLines, WhatNoMaterialBearsIsRefused) {
  const auto refused = [](const std::string& EA, double length) {
    try {
      tether(EA, length);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(refused("2e7", 1.3).find("and the limit is 10 %"), std::string::npos);
  EXPECT_NE(refused("500", 0.9).find("and the limit is 50 %"), std::string::npos);
  EXPECT_NE(refused("{table: [[0.5, 250], [1.5, 750]]}", 0.45).find("and the limit is 200 %"),
            std::string::npos);
  EXPECT_EQ(refused("2e7", 1.45), "");
}

}  // namespace
}  // namespace hawser::test::stretched_lines_test
