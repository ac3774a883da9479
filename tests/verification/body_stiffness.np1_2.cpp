// Stiffness matrix of a body's mooring: three published moorings, and differences of forces at an offset.
#include <fmt/format.h>

#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/run/held_bodies.hpp"
#include "verification/platform_rig.hpp"

namespace hawser::test::body_stiffness_test {
namespace {

using run::HeldBodies;
using run::Simulation;

struct Mooring {
  const char* name;
  double depth, anchor, fairlead, below;  // m: of the bed, radii, fairleads under the water
  double length, EA, mass, diameter;      // m, N, kg/m, m
  double first;                           // deg, of the first line; the others 120 deg on
  double K[4];                            // N/m: 11, 33; N m/rad: 55, 66
  double K15;                             // N/rad
  double tension;                         // N, at the fairlead
};

// The references are exact elastic catenaries, their stiffness by fourth-order differences. Data of
// OC3-Hywind and OC4-DeepCwind as published (Jonkman 2010, without the yaw spring of the crowfoot; Robertson
// et al. 2014), and the chains of the VolturnUS-S (Allen et al. 2020); 1025 kg/m³, 9.80665 m/s², a rigid bed
// without friction.
constexpr Mooring kMoorings[] = {{"OC3",
                                  320,
                                  853.87,
                                  5.2,
                                  70,
                                  902.2,
                                  384.243e6,
                                  77.7066,
                                  0.09,
                                  0,
                                  {41181.2, 11941.51, 3.107853e8, 1.156669e7},
                                  -2815434,
                                  911089},
                                 {"OC4",
                                  200,
                                  837.6,
                                  40.868,
                                  14,
                                  835.35,
                                  753.6e6,
                                  113.35,
                                  0.0766,
                                  180,
                                  {70836.05, 19140.47, 8.724075e7, 1.169702e8},
                                  -107232,
                                  1105373},
                                 {"VolturnUS",
                                  200,
                                  837.6,
                                  58,
                                  14,
                                  850,
                                  3.27e9,
                                  685,
                                  0.333,
                                  180,
                                  {71891.38, 60742.61, 2.585912e8, 2.522924e8},
                                  1144725,
                                  2435560}};

// The origin of the body is at x, y, z of `at`; its centre of mass is elsewhere.
model::Case moored(const Mooring& m, const Vec3& at, double turn_deg, int elements) {
  std::string lines;
  for (int i = 0; i < 3; ++i) {
    const double angle = (m.first + 120 * i) * M_PI / 180;
    const double here = angle + turn_deg * M_PI / 180;
    lines += fmt::format(
        "  line{}: {{sections: [{{type: chain, length: {}, elements: {}}}], end_a: {{anchor: [{:.17g}, "
        "{:.17g}, {}]}}, "
        "end_b: {{body: platform, at: [{:.17g}, {:.17g}, {}]}}}}\n",
        i, m.length, elements, at.x() + m.anchor * std::cos(here), at.y() + m.anchor * std::sin(here),
        -m.depth, m.fairlead * std::cos(angle), m.fairlead * std::sin(angle), -m.below);
  }
  const std::string text = fmt::format(
      R"(hawser: 1
environment:
  water: {{depth: {0}, density: 1025}}
  seabed: {{depth: {0}, normal_stiffness: {{per_length: 100 kN/m2}}, smoothing: 1 mm, friction: 0}}
line_types:
  chain: {{outer_diameter: {1}, mass_per_length: {2}, EA: {3}, bending: false}}
bodies:
  platform:
    position: [{4}, {5}, {6}]
    rotation_deg: [0, 0, {7}]
    floating: {{mass: 1e7, centre_of_mass: [3, -2, -8], inertia: [1e10, 1e10, 1e10]}}
lines:
{8}contact: {{between_lines: false}}
)",
      m.depth, m.diameter, m.mass, m.EA, at.x(), at.y(), at.z(), turn_deg, lines);
  return io::read_case_text(text, testing::TempDir() + "moored.yaml");
}

// About the origin of the body.
BodyStiffness about_origin(HeldBodies& held) {
  const Quat q = held.pose(0).rotation;
  return about_point(held.stiffness(0), q * Vec3(-3, 2, 8), q.toRotationMatrix());
}

TEST(BodyStiffness, OfPublishedMoorings) {
  for (const Mooring& m : kMoorings) {
    Simulation s(PETSC_COMM_WORLD, moored(m, Vec3::Zero(), 0, 500));
    run::hold_body(s, 0);
    s.solve_statics();
    HeldBodies held(s);
    const BodyStiffness at = about_origin(held);
    const int which[] = {0, 2, 4, 5};
    double off = 0;
    for (int k = 0; k < 4; ++k) off = std::max(off, std::abs(at.K(which[k], which[k]) / m.K[k] - 1));
    off = std::max(off, std::abs(at.K(0, 4) / m.K15 - 1));
    for (const double t : held.tensions()) EXPECT_NEAR(t, m.tension, 2e-3 * m.tension);
    printf("stiffness of %s: off by %.2e of the reference\n", m.name, off);
    EXPECT_LT(off, 0.01);
    for (const auto& [i, j] : {std::pair(1, 1), {3, 3}})
      EXPECT_NEAR(at.K(i, j) / at.K(i - (i == 1 ? 1 : -1), j - (j == 1 ? 1 : -1)), 1, 1e-6);
    EXPECT_NEAR(at.K(1, 3), -at.K(0, 4), 1e-6 * std::abs(at.K(0, 4)));
    EXPECT_NEAR(at.K(4, 0), at.K(0, 4), 1e-6 * std::abs(at.K(0, 4)));
  }
}

// The mooring rotated by 90 deg and moved has the same matrix in the rotated axes.
TEST(BodyStiffness, TurnsWithTheMooring) {
  const auto of = [](const Vec3& at, double turn) {
    Simulation s(PETSC_COMM_WORLD, moored(kMoorings[1], at, turn, 60));
    run::hold_body(s, 0);
    s.solve_statics();
    HeldBodies held(s);
    return about_origin(held);
  };
  const BodyStiffness a = of(Vec3::Zero(), 0);
  const BodyStiffness b = of(Vec3(1000, -500, 0), 90);
  Mat6 R = Mat6::Zero();
  R.topLeftCorner<3, 3>() = R.bottomRightCorner<3, 3>() = exp_so3(Vec3(0, 0, M_PI / 2)).toRotationMatrix();
  EXPECT_LT((R * a.K * R.transpose() - b.K).cwiseAbs().maxCoeff(), 1e-6 * a.K.cwiseAbs().maxCoeff());
}

// A spring to a second, held body adds its stiffness along the spring and none across it.
TEST(BodyStiffness, OfALinkToAnotherBody) {
  const std::string text = R"(hawser: 1
bodies:
  a: {position: [0, 0, 0], floating: {mass: 1000, inertia: [1000, 1000, 1000]}}
  b: {position: [10, 0, 0], floating: {mass: 1000, inertia: [1000, 1000, 1000]}}
links:
  spring: {end_a: {body: a, at: [0, 0, 0]}, end_b: {body: b, at: [0, 0, 0]}, stiffness: 1.0e5}
)";
  const model::Case c = io::read_case_text(text, testing::TempDir() + "linked.yaml");
  Simulation s(PETSC_COMM_WORLD, c);
  run::hold_body(s, 0);
  run::hold_body(s, 1);
  HeldBodies held(s);
  for (const int body : {0, 1}) {
    const BodyStiffness at = held.stiffness(body);
    EXPECT_NEAR(at.K(0, 0), 1e5, 1e-3);
    EXPECT_NEAR(at.K(1, 1), 0, 1e-3);
  }
}

// At an offset with rotations the matrix is not symmetric; its columns are differences of forces, and of
// moments about the moved point.
TEST(BodyStiffness, IsTheDerivativeOfForcesAtAnOffset) {
  Simulation s(PETSC_COMM_WORLD, moored(kMoorings[2], Vec3::Zero(), 0, 40));
  run::hold_body(s, 0);
  s.solve_statics();
  HeldBodies held(s);
  RigidPose there = held.pose(0);
  there.position += Vec3(12, -5, 1.5);
  there.rotation = exp_so3(Vec3(0.05, -0.03, 0.2)) * there.rotation;
  held.put(0, there);
  const BodyStiffness at = about_origin(held);
  EXPECT_GT((at.K - at.K.transpose()).cwiseAbs().maxCoeff(), 1e5);
  for (int k = 0; k < 6; ++k) {
    const double e = k < 3 ? 0.01 : 2e-4;
    Vec6 f[2];
    for (const int side : {0, 1}) {
      const double d = side ? e : -e;
      RigidPose moved = there;
      if (k < 3)
        moved.position += d * Vec3::Unit(k);
      else
        moved.rotation = exp_so3(d * Vec3::Unit(k - 3)) * there.rotation;
      held.put(0, moved);
      f[side] = about_origin(held).f;
    }
    const Vec6 found = (f[1] - f[0]) / (2 * e);
    for (const int half : {0, 3}) {
      const double size = at.K.block<3, 3>(half, k < 3 ? 0 : 3).cwiseAbs().maxCoeff();
      EXPECT_LT((at.K.col(k) - found).segment<3>(half).norm(), 2e-4 * size) << k << " " << half;
    }
  }
}

}  // namespace
}  // namespace hawser::test::body_stiffness_test
