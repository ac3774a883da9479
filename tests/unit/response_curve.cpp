// Tables of tension and moment: an increasing curve through the rows, its derivative and integral; tangent
// and energy of elements with tables.
#include "hawser/kernels/response_curve.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "hawser/kernels/beam.hpp"
#include "hawser/math/so3.hpp"
#include "support/cable.hpp"

namespace hawser::response_curve_test {
namespace {

using Row = ResponseCurve::Row;
const std::vector<Row> kRope{{0.01, 50}, {0.03, 300}, {0.05, 400}};
const std::vector<Row> kPipe{{0.1, 40}, {0.3, 80}, {0.6, 90}};

TEST(ResponseCurve, GoesThroughItsRowsRising) {
  const ResponseCurve rope(kRope, false), pipe(kPipe, true);
  for (const auto& [e, f] : kRope) EXPECT_NEAR(rope.at(e).force, f, 1e-12);
  for (const auto& [c, m] : kPipe) {
    EXPECT_NEAR(pipe.at(c).force, m, 1e-12);
    EXPECT_NEAR(pipe.at(-c).force, -m, 1e-12);
  }
  EXPECT_EQ(rope.at(0).force, 0);
  EXPECT_EQ(pipe.at(0).force, 0);
  EXPECT_NEAR(pipe.initial(), 400, 1e-9);  // the same to both sides: slope of the first secant
  for (const ResponseCurve* t : {&rope, &pipe})
    for (double x = -0.9; x < 0.9; x += 0.0137) {
      const double h = 1e-6;
      const auto v = t->at(x);
      const auto a = t->at(x + h);
      const auto b = t->at(x - h);
      EXPECT_GT(v.slope, 0);
      EXPECT_NEAR(v.slope, (a.force - b.force) / (2 * h), 2e-3 * v.slope);
      EXPECT_NEAR(v.force, (a.energy - b.energy) / (2 * h), 1e-4 * (1 + std::abs(v.force)));
      EXPECT_GE(v.energy, 0);
    }
  // The curve is linear beyond the last row and, without negative rows, below the first.
  EXPECT_NEAR(rope.at(-0.2).force, -0.2 * rope.initial(), 1e-12);
  EXPECT_NEAR(rope.at(0.2).slope, rope.at(0.05).slope, 1e-9);
}

TEST(ResponseCurve, AStraightTableIsALinearLaw) {
  const ResponseCurve t(std::vector<Row>{{-0.02, -10}, {0, 0}, {0.05, 25}, {0.1, 50}}, false);
  for (double x : {-0.5, -0.01, 0.003, 0.07, 0.3}) {
    EXPECT_NEAR(t.at(x).force, 500 * x, 1e-10);
    EXPECT_NEAR(t.at(x).energy, 250 * x * x, 1e-10);
  }
}

TEST(ResponseCurve, RefusesWhatIsNoElasticLaw) {
  const auto message = [](std::vector<Row> rows, bool odd) -> std::string {
    try {
      ResponseCurve t(rows, odd);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(message({{0.1, 1}, {0.05, 2}}, false).find("row 2 does not go further"), std::string::npos);
  EXPECT_NE(message({{0.1, 1}, {0.2, 1}}, false).find("row 2 has no more force"), std::string::npos);
  EXPECT_NE(message({{0, 1}, {0.2, 2}}, false).find("row 1 has a force without strain"), std::string::npos);
  EXPECT_NE(message({{-0.1, 1}, {0.2, 2}}, false).find("row 1 does not pull back"), std::string::npos);
  EXPECT_NE(message({{0, 0}}, false).find("needs a row beyond zero"), std::string::npos);
}

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

BeamEnds moved(BeamEnds e, const Vec12& d) {
  e.x1 += d.segment<3>(0);
  e.x2 += d.segment<3>(6);
  e.q1 = e.q1 * exp_so3(d.segment<3>(3));
  e.q2 = e.q2 * exp_so3(d.segment<3>(9));
  return e;
}

// Bending in all parts of the table, with initial curvature, rotated axes and a bend stiffener.
TEST(ResponseCurve, BeamTangentAndEnergyBelongToItsForce) {
  const ResponseCurve rope(kRope, false), pipe(kPipe, true);
  std::mt19937 g(7);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto random = [&] { return Vec3(u(g), u(g), u(g)); };
  for (int i = 0; i < 12; ++i) {
    BeamSection s{1.2, rope.initial(), pipe.initial() + (i % 2 ? 30 : 0), 0, 40, 0, i % 3 ? 0.0 : 0.2};
    s.EI3 = s.EI2;
    s.tension = &rope;
    s.moment = &pipe;
    BeamReference r;
    Mat3 turn = Mat3::Identity();
    if (i > 5) {
      turn = exp_so3(random()).toRotationMatrix();
      r.axes = &turn;
      r.psi = 0.1 * random();
    }
    BeamEnds e;
    e.x1 = random();
    e.q1 = exp_so3(random());
    e.q2 = e.q1 * exp_so3(0.4 * random());
    e.x2 = e.x1 + e.q1 * (turn * Vec3(1.25, 0.1 * u(g), 0.1 * u(g)));
    e.v1 = random();
    e.v2 = random();
    e.w1 = random();
    e.w2 = random();
    Mat12 K, C, Kd;
    Vec12 f, a, b, c, d;
    beam_tangent(s, r, e, false, f, K, &C);
    const double h = 1e-5;
    for (int j = 0; j < 12; ++j) {
      beam_force(s, r, moved(e, h * Vec12::Unit(j)), a);
      beam_force(s, r, moved(e, -h * Vec12::Unit(j)), b);
      beam_force(s, r, moved(e, 2 * h * Vec12::Unit(j)), c);
      beam_force(s, r, moved(e, -2 * h * Vec12::Unit(j)), d);
      Kd.col(j) = (8 * (a - b) - (c - d)) / (12 * h);
      if (s.beta > 0) continue;
      const double slope = (beam_stress(s, r, moved(e, h * Vec12::Unit(j))).strain_energy -
                            beam_stress(s, r, moved(e, -h * Vec12::Unit(j))).strain_energy) /
                           (2 * h);
      EXPECT_NEAR(f[j], slope, 1e-6 * f.norm());
    }
    EXPECT_LT((K - Kd).norm(), 1e-6 * Kd.norm()) << i;
  }
}

// With linear tables an element has the same stresses, energy and tangent as without tables.
TEST(ResponseCurve, StraightTablesChangeNothing) {
  const ResponseCurve rope(std::vector<Row>{{0.1, 30}, {0.2, 60}}, false);
  const ResponseCurve pipe(std::vector<Row>{{0.1, 5}, {0.2, 10}}, true);
  BeamSection plain{1.2, 300, 50, 50, 40, 0, 0.1};
  BeamSection tables = plain;
  tables.tension = &rope;
  tables.moment = &pipe;
  BeamEnds e;
  e.x1 = Vec3(1, 2, 3);
  e.q1 = exp_so3(Vec3(0.2, -0.5, 0.3));
  e.q2 = e.q1 * exp_so3(Vec3(0.2, 0.5, -0.4));
  e.x2 = e.x1 + e.q1 * Vec3(1.3, 0.1, -0.2);
  e.v1 = Vec3(1, 0, 2);
  e.w2 = Vec3(0.3, 1, 0);
  Mat12 K, L, C, D;
  Vec12 f, g;
  beam_tangent(plain, {}, e, false, f, K, &C);
  beam_tangent(tables, {}, e, false, g, L, &D);
  EXPECT_LT((f - g).norm() + (C - D).norm(), 1e-11 * (f.norm() + C.norm()));
  // Damping forces depend on the rate of strain alone, so their contribution to the element moments is the
  // same.
  EXPECT_LT((K - L).norm(), 1e-11 * K.norm());
  plain.beta = tables.beta = 0;
  const BeamStress a = beam_stress(plain, {}, e);
  const BeamStress b = beam_stress(tables, {}, e);
  EXPECT_NEAR(a.strain_energy, b.strain_energy, 1e-12 * a.strain_energy);
  EXPECT_LT((a.moment1 - b.moment1).norm() + (a.moment2 - b.moment2).norm(), 1e-12 * a.moment1.norm());
  EXPECT_LT((a.curvature1 - b.curvature1).norm() + (a.curvature2 - b.curvature2).norm(),
            1e-12 * a.curvature1.norm());
}

TEST(ResponseCurve, CableTangentAndEnergyBelongToItsForce) {
  const ResponseCurve rope(kRope, false);
  for (double strain : {-0.01, 0.005, 0.02, 0.045, 0.2}) {
    const CableSection s{2, rope.initial(), 0, &rope};
    test::CableState e{Vec3(1, 1, 1), Vec3::Zero()};
    e.x2 = e.x1 + 2 * (1 + strain) * Vec3(0.6, 0, 0.8);
    test::CableMatrix K, C;
    const test::CableEndForces f = cable_tangent(s, e, K, C);
    EXPECT_NEAR(f.tail<3>().norm(), strain > 0 ? rope.at(strain).force : 0, 1e-9);
    for (int j = 0; j < 3; ++j) {
      test::CableState p = e;
      test::CableState m = e;
      p.x2[j] += 1e-6;
      m.x2[j] -= 1e-6;
      const test::CableEndForces rise = cable_end_forces(s, p) - cable_end_forces(s, m);
      EXPECT_LT((K.col(3 + j) - rise / 2e-6).norm(), 1e-5 * (1 + K.norm()));
      EXPECT_NEAR(f[3 + j], (cable_stress(s, p).strain_energy - cable_stress(s, m).strain_energy) / 2e-6,
                  1e-6 * (1 + f.norm()));
    }
  }
}

}  // namespace
}  // namespace hawser::response_curve_test
