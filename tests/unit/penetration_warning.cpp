// The warning of a line deep in a volume names the depth to which the contact law holds: the radius of the
// line, or the last row of a table; for a plane there is no such depth.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "hawser/advice/limits.hpp"

namespace hawser::test::penetration_warning_test {
namespace {

std::string warning(double depth, const model::Volume& volume,
                    const advice::PenetratedStiffness& stiffness = {}) {
  model::Case c;
  model::LineType& type = c.line_types.emplace_back();
  type.name = "rope";
  type.contact_diameter = 0.2;
  model::Line& line = c.lines.emplace_back();
  line.name = "mooring";
  line.sections = {{"rope", 10, 5}};
  return advice::penetration_warning(c, {"mooring", depth, 3, 5}, volume, stiffness);
}

TEST(PenetrationWarning, WithoutATableTheLawHoldsToTheRadius) {
  EXPECT_NE(warning(0.15, {}).find("holds to a depth of 0.1 m, the radius of the line"), std::string::npos);
  EXPECT_EQ(warning(0.05, {}).find("holds to a depth"), std::string::npos);
}

TEST(PenetrationWarning, WithATableItHoldsToTheLastRow) {
  const std::vector<ContactForceTable::Row> rows = {{0.1, 1000}, {0.3, 5000}};
  model::Volume volume;
  volume.force_table = std::make_shared<ContactForceTable>(rows);
  EXPECT_NE(warning(0.15, volume).find("the table of its normal_stiffness allows"), std::string::npos);
  EXPECT_NE(warning(0.35, volume).find("holds to a depth of 0.3 m, the last row of its table"),
            std::string::npos);
}

TEST(PenetrationWarning, APlaneWithAGivenStiffnessHasNoLimit) {
  model::Volume volume;
  volume.shape = PlaneShape{};
  volume.basis = model::StiffnessBasis::per_length;
  EXPECT_EQ(warning(0.15, volume).find("holds to a depth"), std::string::npos);
  volume.basis = model::StiffnessBasis::automatic;
  EXPECT_NE(warning(0.15, volume).find("holds to a depth"), std::string::npos);
}

// The radius is 0.1 m, so that 0.01 m is acceptable at rest and 0.06 m in an impact. 0.08 m on 1e6 N/m per m
// requires a stiffness of 8 times that under a static force, 64 times in an impact.
TEST(PenetrationWarning, OnAnAutomaticStiffness) {
  EXPECT_NE(warning(0.08, {}, {1e6, true, false}).find("this is an impact"), std::string::npos);
  EXPECT_NE(warning(0.08, {}, {1e6, true, false})
                .find("'normal_stiffness: {per_length: 6.4e+07}' limits this one to about 0.01 m"),
            std::string::npos);
  EXPECT_NE(warning(0.08, {}, {1e6, false, false})
                .find("'normal_stiffness: {per_length: 8e+06}' limits the penetration to about 0.01 m"),
            std::string::npos);
  EXPECT_EQ(warning(0.08, {}, {1e6, false, false}).find("breaking load"), std::string::npos);
  EXPECT_NE(warning(0.08, {}, {1e6, false, true}).find("is the tension above the breaking load?"),
            std::string::npos);
}

}  // namespace
}  // namespace hawser::test::penetration_warning_test
