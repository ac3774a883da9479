// Full matrices of stiffness and damping of a body in a case: reading, periods, warnings.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/longest_step.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::case_matrices_test {
namespace {

model::Case read(const std::string& matrices) {
  return io::read_case_text("hawser: 1\nbodies: {buoy: {floating: {mass: 1000, inertia: [500, 600, 700], " +
                                matrices + "}}}\ndynamics: {duration: 10}\n",
                            testing::TempDir() + "/text.yaml");
}

std::string rows(const char* name, const Mat6& m) {
  std::string out;
  for (int i = 0; i < 6; ++i)
    out += fmt::format("{}[{}, {}, {}, {}, {}, {}]", i > 0 ? ", " : "", m(i, 0), m(i, 1), m(i, 2), m(i, 3),
                       m(i, 4), m(i, 5));
  return fmt::format("{}: [{}]", name, out);
}

std::string warnings(const std::string& matrices) {
  std::string out;
  for (const auto& w : advice::input_warnings(read(matrices))) out += w.key + ": " + w.text + "\n";
  return out;
}

Mat6 numbered() {
  Mat6 m;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) m(i, j) = 100 + 10 * std::min(i, j) + std::max(i, j) + (i == j ? 1000 : 0);
  return m;
}

TEST(CaseMatrices, ReadsRows) {
  const model::Case c =
      read(rows("stiffness_matrix", numbered()) + ", " + rows("damping_matrix", 2 * numbered()));
  EXPECT_EQ(c.bodies[0].mass->stiffness_matrix, numbered());
  EXPECT_EQ(c.bodies[0].mass->damping_matrix, 2 * numbered());
  EXPECT_EQ(c.bodies[0].mass->spring_stiffness(), Vec3(1100, 1111, 1122));
  EXPECT_TRUE(read("weight: false").bodies[0].mass->stiffness_matrix.isZero(0));
}

// T = 2 pi sqrt(m/k) of a diagonal matrix about the centre of mass; the shortest determines the step.
TEST(CaseMatrices, Periods) {
  Mat6 K = Mat6::Zero();
  const Vec6 mass = (Vec6() << 1000, 1000, 1000, 500, 600, 700).finished();
  const Vec6 period = (Vec6() << 40, 20, 10, 8, 5, 0).finished();
  for (int i = 0; i < 5; ++i) K(i, i) = mass[i] * std::pow(2 * M_PI / period[i], 2);
  const model::Case c = read(rows("stiffness_matrix", K));
  const std::string s = model::summary(c);
  EXPECT_NE(s.find("held by springs"), std::string::npos) << s;
  EXPECT_NE(
      s.find("periods on its stiffness matrix alone: yaw none, surge 40 s, sway 20 s, heave 10 s, roll 8 s, "
             "pitch 5 s"),
      std::string::npos)
      << s;
  const model::LongestStep step = model::longest_step(c);
  EXPECT_NEAR(step.length * step.divisor, 5, 1e-9);
  EXPECT_NE(step.subject.find("body buoy on its stiffness matrix"), std::string::npos) << step.subject;
}

// A damping that adds energy for some velocities, and a stiffness that pushes the body away.
TEST(CaseMatrices, Warnings) {
  Mat6 B = 1e3 * Mat6::Identity();
  B(0, 1) = B(1, 0) = 0.9e3;
  EXPECT_EQ(warnings(rows("damping_matrix", B)).find("adds energy"), std::string::npos);
  B(0, 1) = B(1, 0) = 1.1e3;
  EXPECT_NE(
      warnings(rows("damping_matrix", B)).find("buoy.floating.damping_matrix: adds energy to the motion"),
      std::string::npos)
      << warnings(rows("damping_matrix", B));
  Mat6 K = 1e3 * Mat6::Identity();
  EXPECT_EQ(warnings(rows("stiffness_matrix", K)).find("pushes"), std::string::npos);
  K(0, 5) = K(5, 0) = 1.1e4;
  EXPECT_NE(
      warnings(rows("stiffness_matrix", K)).find("buoy.floating.stiffness_matrix: pushes the body away"),
      std::string::npos)
      << warnings(rows("stiffness_matrix", K));
}

}  // namespace
}  // namespace hawser::case_matrices_test
