// Dynamic positioning and wave-drift damping in a case: reading, refusals, notes, and stability of the
// control loop.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/kernels/waves.hpp"
#include "hawser/model/positioning.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::case_positioning_test {
namespace {

constexpr double kMass = 2e6, kInertia = 3e9;

model::Case read(const std::string& body) {
  return io::read_case_text(
      fmt::format("hawser: 1\nbodies: {{ship: {{position: [1, 2, 3], rotation_deg: [0, 0, 30], {}}}}}\n",
                  body),
      testing::TempDir() + "/text.yaml");
}
std::string floating(const std::string& positioning) {
  return fmt::format("floating: {{mass: {}, inertia: [2e9, 2e9, {}], positioning: {{{}}}}}", kMass, kInertia,
                     positioning);
}
template <class Read>
std::string refused(const Read& reads) {
  try {
    reads();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}
void expect_refused(const std::string& body, const char* part) {
  const std::string why = refused([&] { read(body); });
  EXPECT_NE(why.find(part), std::string::npos) << part << "\n" << why;
}

TEST(CasePositioning, ReadsKeysAndDefaults) {
  const model::Case c = read(floating("proportional: [1e5, 2e5, 3e7]"));
  const model::DynamicPositioning& p = *c.bodies[0].mass->positioning;
  EXPECT_FALSE(p.place || p.heading);
  EXPECT_EQ(p.filter, 60);
  EXPECT_EQ(p.max_force, Eigen::Vector2d::Constant(HUGE_VAL));
  const model::Case given = read(
      floating("place: [4, 5, 0], heading_deg: 90, proportional: [1e5, 2e5, 3e7], derivative: [1, 2, 3], "
               "integral: [4, 5, 6], filter_period: 30, max_force: [2 MN, 500 kN], max_moment: 7 MN m"));
  const model::DynamicPositioning& all = *given.bodies[0].mass->positioning;
  EXPECT_EQ(*all.place, Vec3(4, 5, 0));
  EXPECT_DOUBLE_EQ(*all.heading, M_PI / 2);
  EXPECT_EQ(all.proportional, Vec3(1e5, 2e5, 3e7));
  EXPECT_EQ(all.derivative, Vec3(1, 2, 3));
  EXPECT_EQ(all.integral, Vec3(4, 5, 6));
  EXPECT_EQ(all.max_force, Eigen::Vector2d(2e6, 5e5));
  EXPECT_EQ(all.max_moment, 7e6);
  const std::string s = model::summary(given);
  EXPECT_NE(s.find("by motion slower than 30 s, up to 2000 kN in surge and 500 kN in sway, up to 7000 kN m"),
            std::string::npos)
      << s;
}

TEST(CasePositioning, Refusals) {
  const std::string P = "proportional: [1e5, 1e5, 1e7], ";
  expect_refused(
      floating(P + "max_force: -1"),
      "text.yaml:2: bodies.ship.floating.positioning.max_force: '-1' is out of range; must be above 0");
  expect_refused(floating(P + "max_force: [1e5, 0]"),
                 "positioning.max_force[1]: '0' is out of range; must be above 0");
  expect_refused(floating(P + "max_force: [1e5, 1e5, 1e7]"), "positioning.max_force: ");
  expect_refused(floating(P + "max_moment: 0"),
                 "positioning.max_moment: '0' is out of range; must be above 0");
  expect_refused(floating(P + "filter_period: 0"),
                 "positioning.filter_period: '0' is out of range; must be above 0");
  expect_refused(floating("proportional: [1e5, -1e5, 1e7]"),
                 "positioning.proportional[1]: '-1e5' is out of range; must be at least 0");
  expect_refused(floating("proportional: [1e5, 1e5]"), "positioning.proportional: ");
  expect_refused(floating(P + "gain: 1"), "positioning.gain: ");
  expect_refused(floating(""), "positioning: needs 'proportional' or 'derivative' parts");
  expect_refused(floating("proportional: [1e5, 0, 0], integral: [1e2, 0, 1e5]"),
                 "positioning.integral: has 100000 for yaw, where 'proportional' has 0");
  expect_refused("positioning: {proportional: [1e5, 1e5, 1e7]}", "bodies.ship.positioning: ");
}

// State z = (x, v, y, y', r, s) of the theory page; growth from the eigenvalues of z' = A z.
TEST(CasePositioning, GrowthOfTheLoop) {
  const auto growth = [](double P, double D, double I, double period) {
    const double c = 2 * M_PI / period;
    Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
    A(0, 1) = A(2, 3) = 1;
    A.row(3) << c * c, 0, -c * c, -2 * c, 0, 0;
    A.row(4) << 0, 0, 0, c, -c, 0;
    A.row(5) << 0, 0, 1, 0, 2 / c, 0;
    A.row(1) << 0, 0, -P, -3 * D, 2 * D - 2 * P / c, -I;
    A.row(1) /= kMass;
    return A.eigenvalues().real().maxCoeff();
  };
  int unstable = 0;
  for (const double natural : {60., 90., 100., 200.})
    for (const double I : {0., 0.1, 1.}) {
      const double w = 2 * M_PI / natural;
      const double P = kMass * w * w;
      const double D = 1.4 * kMass * w;
      const double i = I * P * w;
      const model::Case c = read(floating(fmt::format(
          "proportional: [{}, 0, 0], derivative: [{}, 0, 0], integral: [{}, 0, 0], filter_period: 60", P, D,
          i)));
      const double largest = growth(P, D, i, 60);
      const Vec3 found = model::loop_growth(c.bodies[0]);
      EXPECT_NEAR(found.x(), std::max(largest, 0.0), 1e-6 * w) << natural << " " << I;
      EXPECT_EQ(found.tail<2>(), Eigen::Vector2d::Zero());
      const auto warnings = advice::input_warnings(c);
      const bool warned = std::any_of(warnings.begin(), warnings.end(), [](const auto& warning) {
        return warning.text.find("the control loop is unstable in surge") != std::string::npos;
      });
      EXPECT_EQ(warned, largest > 1e-6) << natural << " " << I;
      unstable += warned;
    }
  EXPECT_GT(unstable, 3);
  EXPECT_LT(unstable, 9);
}

// With D alone: s⁴ + 3 s³ + 3 s² + (1 + 3 d) s + d with d = D/(m c), which is unstable by Routh's criterion
// if (8 - 3 d) (1 + 3 d) < 9 d, that is for d > 1.8.
TEST(CasePositioning, DampingAloneMayBeUnstable) {
  constexpr double c = 2 * M_PI / 60;
  for (const double d : {0.5, 1.5, 2.2, 9.}) {
    const model::Case found =
        read(floating(fmt::format("derivative: [{}, 0, 0], filter_period: 60", d * kMass * c)));
    EXPECT_EQ(model::loop_growth(found.bodies[0]).x() > 0, (8 - 3 * d) * (1 + 3 * d) < 9 * d) << d;
  }
}

TEST(CasePositioning, MassOfAFullMatrix) {
  model::Case c = read(floating("proportional: [1e5, 1e5, 1e7]"));
  model::BodyMass& m = *c.bodies[0].mass;
  const Vec3 before = model::positioned_mass(c.bodies[0]);
  m.centre.setZero();
  m.coupled = Vec6(2e6, 3e6, 0, 0, 0, 4e8).asDiagonal();
  const Vec3 found = model::positioned_mass(c.bodies[0]);
  EXPECT_NEAR(found.x(), before.x() + 2e6, 1);
  EXPECT_NEAR(found.y(), before.y() + 3e6, 1);
  EXPECT_NEAR(found.z(), m.inertia.z() + 4e8, 1e2);
}

std::string in_sea(const std::string& damping, const std::string& waves) {
  const std::string stem = testing::TempDir() + "/drift_barge";
  std::ofstream(stem + ".1") << "0 3 3 1\n6 3 3 1 0.1\n5 3 3 1 0.1\n";
  std::ofstream(stem + ".3") << "10 0 3 1e-6 0 1e-6 0\n5 0 3 1e-6 0 1e-6 0\n";
  std::ofstream(stem + ".hst") << "3 3 1000\n";
  return "hawser: 1\nenvironment: {gravity: 10, water: {density: 1000}" + waves +
         "}\nbodies: {barge: {floating: {mass: 1e6, inertia: [1e8, 1e8, 1e8], hydrodynamics: {wamit: "
         "drift_barge, wave_drift_damping: " +
         damping + "}}}}\n";
}
model::Case read_in_sea(const std::string& damping,
                        const std::string& waves = ", waves: {regular: {height: 4, period: 8}}") {
  return io::read_case_text(in_sea(damping, waves), testing::TempDir() + "/text.yaml");
}

TEST(CasePositioning, DriftDampingOfASea) {
  const model::Case c = read_in_sea("{rows: [[10, 1, 2, 3], [5, 11, 1, 0, 1, 22, 5, 0, 5, 33]]}");
  std::vector<WaveComponent> sea(2);
  sea[0].amplitude = 2;
  sea[0].omega = 2 * M_PI / 10 + 0.25 * (2 * M_PI / 5 - 2 * M_PI / 10);
  sea[1].amplitude = 3;
  sea[1].omega = 2 * M_PI / 4;  // beyond the rows
  const Mat6 B = model::wave_drift_damping(*c.bodies[0].mass->hydrodynamics, sea);
  Mat6 expected = Mat6::Zero();
  expected(0, 0) = 4 * 3.5 + 9 * 11;
  expected(1, 1) = 4 * 7 + 9 * 22;
  expected(5, 5) = 4 * 10.5 + 9 * 33;
  expected(0, 1) = expected(1, 0) = 4 * 0.25 + 9;
  expected(1, 5) = expected(5, 1) = 4 * 1.25 + 9 * 5;
  EXPECT_LT((B - expected).cwiseAbs().maxCoeff(), 1e-12 * B.maxCoeff()) << B;
}

TEST(CasePositioning, DriftDampingRefusals) {
  const auto why = [](const char* damping) { return refused([damping] { read_in_sea(damping); }); };
  const std::pair<const char*, const char*> figures[] = {
      {"{rows: [[10, 1, 2, 3, 4]]}",
       "a row has 4 numbers (period, Bxx, Byy, Bzz) or 10 (period, matrix), but row 1 has 5"},
      {"{rows: [[10, 1, 2, 3], [0, 1, 2, 3]]}", "a period is above 0 s, but row 2 has 0"},
      {"{rows: [[10, 1, 2, 3], [10, 2, 2, 3]]}", "has the period 10 s twice"},
      {"{file: nothing.txt}", "nothing.txt"},
      {"{}", "wave_drift_damping: "}};
  for (const auto& [damping, part] : figures)
    EXPECT_NE(why(damping).find(part), std::string::npos) << damping << "\n" << why(damping);
}

TEST(CasePositioning, NegativeDriftDampingIsNoted) {
  const auto noted = [](const model::Case& c) {
    return std::any_of(c.notes.begin(), c.notes.end(), [](const std::string& n) {
      return n.find("wave_drift_damping: is negative in this sea") != std::string::npos;
    });
  };
  EXPECT_FALSE(noted(read_in_sea("{rows: [[10, 1, 2, 3], [5, -1, 2, 3]]}")));
  EXPECT_TRUE(noted(read_in_sea("{rows: [[10, 1, 2, 3], [5, -11, 2, 3]]}")));
  EXPECT_FALSE(noted(read_in_sea("{rows: [[10, -1, 2, 3]]}", "")));
}

}  // namespace
}  // namespace hawser::case_positioning_test
