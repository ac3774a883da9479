// Tables of wind and current on bodies: conventions of angles, mirrored sides, refusals.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::case_flow_test {
namespace {

model::Case read(const std::string& flow, const std::string& environment = "wind: {speed: 20}, water: {}") {
  return io::read_case_text(
      "hawser: 1\nenvironment: {" + environment +
          "}\nbodies: {ship: {floating: {mass: 1e7, inertia: [1e9, 1e10, 1e10], stiffness: "
          "[1e5, 1e5, 1e5],\n  " +
          flow + "}}}\n",
      testing::TempDir() + "/text.yaml");
}
std::string refused(const std::string& flow,
                    const std::string& environment = "wind: {speed: 20}, water: {}") {
  try {
    read(flow, environment);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}
std::string wind(const std::string& more) {
  return "wind: {frontal_area: 100, lateral_area: 500, length: 90, " + more + "}";
}
void expect_refused(const std::string& flow, const char* part) {
  const std::string why = refused(flow);
  EXPECT_NE(why.find(part), std::string::npos) << part << "\n" << why;
}

const char* kSide = "[[0, 0.8, 0, 0], [60, 0.4, 0.7, 0.1], [120, -0.4, 0.6, -0.05], [180, -0.7, 0, 0]]";

TEST(CaseFlow, OneSideMakesTheOther) {
  const model::Case c = read(wind(std::string("rows: ") + kSide));
  const model::FlowOnBody& f = *c.bodies[0].mass->wind;
  EXPECT_TRUE(f.mirrored);
  Vec3 C, slope;
  f.coefficients.at(-M_PI / 3, C, slope);
  EXPECT_LT((C - Vec3(0.4, -0.7, -0.1)).norm(), 1e-14);
  f.coefficients.at(1.5 * M_PI, C, slope);
  EXPECT_LT((C - Vec3(0, -0.65, -0.025)).norm(), 1e-14);
  EXPECT_LT((slope - Vec3(0.8, -0.1, -0.15) / (M_PI / 3)).norm(), 1e-13);
  const std::string s = model::summary(c);
  EXPECT_NE(s.find("wind by 4 rows, by where it goes to, mirrored: at 20 m/s it has at most 19.6 kN along"),
            std::string::npos)
      << s;
  EXPECT_NE(s.find("wind: 20 m/s at 10 m, goes to 0 deg\n"), std::string::npos) << s;
}

// The same body with angles of the direction from which the wind comes: 0 is head wind.
TEST(CaseFlow, AnglesFromWhereItComes) {
  const model::Case to = read(wind(std::string("rows: ") + kSide));
  const model::Case from =
      read(wind("angles: from, rows: [[-180, 0.8, 0, 0], [-120, 0.4, 0.7, 0.1], [-60, -0.4, 0.6, -0.05], [0, "
                "-0.7, 0, 0]]"));
  for (double a = 0; a < 7; a += 0.3) {
    Vec3 here, there, slope;
    to.bodies[0].mass->wind->coefficients.at(a, here, slope);
    from.bodies[0].mass->wind->coefficients.at(a, there, slope);
    EXPECT_LT((here - there).norm(), 1e-13) << a;
  }
}

TEST(CaseFlow, FileAllRoundAndDraught) {
  std::ofstream(testing::TempDir() + "/flow.txt")
      << "# angle Cx Cy Cn\n0 0.05 0.01 0\n60, 0.02, 0.6, 0.05\n120 -0.02 0.6 -0.05\n180 -0.05 0 0\n240 "
         "-0.02 -0.5 "
         "0.05\n300 0.02 -0.5 -0.05\n360 0.05 0.01 0\n";
  const model::Case c = read("current: {length: 90, draught: 5, file: flow.txt}");
  const model::FlowOnBody& f = *c.bodies[0].mass->current;
  EXPECT_FALSE(f.mirrored);
  EXPECT_EQ(f.frontal, 450);
  EXPECT_EQ(f.lateral, 450);
  EXPECT_EQ(f.rows, 7);
}

TEST(CaseFlow, WarningOfForcesInPlaceOfCoefficients) {
  const auto of = [](const char* across) {
    return advice::input_notes(read(wind(std::string("rows: [[0, 0.8, 0, 0], [60, 0.4, ") + across +
                                         ", 0], [120, -0.4, 0.6, 0], [180, -0.7, 0, 0]]")));
  };
  EXPECT_TRUE(of("3").empty());
  const std::vector<std::string> found = of("700");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("floating.wind: has a coefficient of 700"), std::string::npos) << found[0];
}

// The table of kSide by clockwise angles, to and from which the wind blows: either has only one axis against
// the flow, so that the other word of `angles` alone is no remedy.
TEST(CaseFlow, ClockwiseAngles) {
  const std::string to =
      "rows: [[0, 0.8, 0, 0], [60, 0.4, -0.7, -0.1], [120, -0.4, -0.6, 0.05], [180, -0.7, 0, 0]]";
  expect_refused(
      wind(to),
      "flows from the sides, and they alone, push the body against them: do its angles go clockwise, "
      "or is Cy positive to starboard? Then reverse the signs of Cy and Cn");
  expect_refused(
      wind("angles: from, " + to),
      "flows to 0 and 180 deg, and they alone, push the body against them: do its angles go "
      "clockwise, and are they those 'to' which the flow goes? Then give 'angles: to' and reverse");
}

TEST(CaseFlow, BadTablesGetASentence) {
  expect_refused(
      wind("rows: [[0, -0.8, 0, 0], [60, -0.4, -0.7, 0], [120, 0.4, -0.6, 0], [180, 0.7, 0, 0]]"),
      "where the flow goes to 0 deg, ahead, Cx = -0.8 pushes the body against it: are the angles those "
      "'from' which it comes? Then give 'angles: from'");
  expect_refused(
      wind("rows: [[0, 0.8, 0, 0], [120, -0.4, 0.6, 0], [180, -0.7, 0, 0]]"),
      "there is no row between 0 and 120 deg: rows are at most 60 deg apart, all round or from 0 to "
      "180 deg");
  expect_refused(wind("rows: [[0, 0.8, 0, 0], [60, 0.4, 0.7, 0], [120, -0.4, 0.6, 0], [170, -0.7, 0, 0]]"),
                 "there is no row between 170 and 360 deg");
  expect_refused(
      wind("rows: [[0, 0.8, 0.1, 0], [60, 0.4, 0.7, 0], [120, -0.4, 0.6, 0], [180, -0.7, 0, 0]]"),
      "rows of one side are mirrored for the other, so that Cy and Cn at 0 deg are 0, found 0.1 and 0");
  expect_refused(wind("rows: [[0, 0.8, 0, 0], [60, 0.4, 0.7, 0], [50, -0.4, 0.6, 0], [180, -0.7, 0, 0]]"),
                 "angles must increase from row to row, but 50 deg follows 60 deg: row 3");
  expect_refused(
      "current: {length: 90, rows: [[0, 0.8, 0, 0], [60, 0.4, 0.7, 0], [120, -0.4, 0.6, 0], [180, -0.7, 0, "
      "0]]}",
      "current.frontal_area: required key is missing: both areas, or 'draught'");
  EXPECT_NE(refused(wind(std::string("rows: ") + kSide), "water: {}").find("there is no wind"),
            std::string::npos);
}

}  // namespace
}  // namespace hawser::case_flow_test
