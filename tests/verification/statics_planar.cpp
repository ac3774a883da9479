// Cantilevers in a plane against closed forms: roll-up by an end moment, elastica under a dead tip load,
// buckled elastica.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "hawser/solve/stability.hpp"
#include "verification/statics_newton.hpp"

namespace hawser::statics_planar_test {

using namespace hawser::test;

namespace {

struct Tip {
  Vec3 x = Vec3::Zero();
  double angle = 0;  // rad, of the rotation about z, modulo 2 pi
};

Tip tip(run::Simulation& s) {
  const Vec3 t = s.state().q.back() * Vec3::UnitX();
  return {s.state().x.back(), std::atan2(t.y(), t.x())};
}

// Largest distance of a node from its place on the circle of the moment 2 pi lam EI/L, over L.
double roll_up_error(double lam, int elements) {
  const double L = 10;
  const double EI = 1000;
  const double angle = 2 * M_PI * lam;
  const double R = L / angle;
  model::LineType t = beam_type(1e7, EI, EI);
  const model::Case c = cantilever(t, L, elements, Vec3::Zero(), Vec3(0, 0, EI / R));
  run::Simulation s(PETSC_COMM_WORLD, c);
  follow(s, 4 + static_cast<int>(24 * lam));
  EXPECT_NEAR(std::remainder(tip(s).angle - angle, 2 * M_PI), 0, 1e-9);
  double worst = 0;
  for (int i = 0; i <= elements; ++i) {
    const double a = angle * i / elements;
    const Vec3 exact = R * Vec3(std::sin(a), 1 - std::cos(a), 0);
    worst = std::max(worst, (s.state().x[static_cast<size_t>(i)] - exact).norm());
  }
  return worst / L;
}

// Tip position over L for P L²/EI = alpha; EA L²/EI = 1e9 stands for inextensible.
Tip elastica(double alpha, int elements) {
  model::LineType t = beam_type(1e9, 1, 1);
  const model::Case c = cantilever(t, 1, elements, Vec3(0, alpha, 0));
  run::Simulation s(PETSC_COMM_WORLD, c);
  follow(s, 6 + static_cast<int>(2 * alpha));
  return tip(s);
}

}  // namespace

// Closed form: a circle of radius EI/M. All nodes are compared, because the tip of a full circle closes for
// any chain of equal elements.
TEST(Statics, RollUpByEndMoment) {
  for (double lam : {0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0}) {
    const double e10 = roll_up_error(lam, 10);
    const double e20 = roll_up_error(lam, 20);
    const double e40 = roll_up_error(lam, 40);
    std::printf("roll-up lam %.2f: error/L %.2e %.2e %.2e (10, 20, 40 elements), order %.2f %.2f\n", lam, e10,
                e20, e40, order(e10, e20), order(e20, e40));
    EXPECT_LT(e20, 1e-3);
    EXPECT_GT(order(e10, e20), 3.8);
    EXPECT_GT(order(e20, e40), 3.8);
  }
}

// Bisshopp & Drucker (1945), Quart. Appl. Math. 3, by elliptic integrals with 30 digits.
TEST(Statics, ElasticaUnderDeadTipLoad) {
  struct {
    double alpha, x, y, angle;
  } const rows[] = {{0.25, 0.9958821815900243, 0.08274591535441744, 0.1242924421136373},
                    {0.5, 0.9840810375291625, 0.1621435756583696, 0.24453364713321832},
                    {1, 0.9435667637166231, 0.30172077379981355, 0.461351949711879},
                    {2, 0.8393582791748327, 0.49345748039671183, 0.7817498315565431},
                    {3, 0.7455798154358129, 0.6032534411299774, 0.9860169467113541},
                    {4, 0.671058757753154, 0.6699641812776668, 1.1212393474875764},
                    {5, 0.6123716392755701, 0.7137915236119128, 1.215368117611681},
                    {6, 0.5654111713180948, 0.7445711488895153, 1.283697285801245},
                    {7.5, 0.5104257514768928, 0.7767020004430666, 1.3559265989233307},
                    {9, 0.46817943732747275, 0.7990555274708402, 1.4054653336239529},
                    {10, 0.4450044022462487, 0.8106090248802964, 1.4302855388038576},
                    {20, 0.3161144324335249, 0.8686958982854378, 1.5329349562970411},
                    {50, 0.19999960395040237, 0.9171554473035874, 1.5679819015714367}};
  double worst = 0, worst_angle = 0;
  for (const auto& r : rows) {
    const Tip t = elastica(r.alpha, 20);
    const double error = (t.x - Vec3(r.x, r.y, 0)).norm();
    worst = std::max(worst, error);
    worst_angle = std::max(worst_angle, std::abs(t.angle - r.angle));
    EXPECT_LT(error, 1e-4) << "alpha " << r.alpha;
    EXPECT_NEAR(t.angle, r.angle, 1e-4) << "alpha " << r.alpha;
  }
  std::printf("elastica, 20 elements, 13 loads: error/L at most %.2e, angle %.2e rad\n", worst, worst_angle);
  for (const auto& r : rows) {
    if (r.alpha < 5) continue;
    double e[2];
    for (int i = 0; i < 2; ++i) e[i] = (elastica(r.alpha, 10 << i).x - Vec3(r.x, r.y, 0)).norm();
    std::printf("elastica alpha %4.1f: error/L %.2e %.2e (10, 20 elements), order %.2f\n", r.alpha, e[0],
                e[1], order(e[0], e[1]));
    EXPECT_GT(order(e[0], e[1]), 1.9) << "alpha " << r.alpha;
  }
}

// A pinned straight beam compressed to 0.741 of its length is in unstable equilibrium. Statics must detect
// this and find the buckled shape. Euler's elastica: with k = sin(alpha/2), span/L = 2E(k)/K(k) - 1, P L²/EI
// = 4 K(k)², alpha the angle at the ends; here alpha = 60 degrees, k = 1/2.
TEST(Statics, CompressedStraightBeamBuckles) {
  const double K = 1.6857503548125961, E = 1.4674622093394272;  // complete elliptic integrals, modulus 1/2
  const double span = 2 * E / K - 1;
  const double force = 4 * K * K;
  model::LineType t = beam_type(1e6, 1, 1);
  t.EI2 = 2;  // otherwise it may buckle in any plane, and one eigenvalue is zero
  model::Case c = one_line(t, 1, 40, anchor(Vec3::Zero()), anchor(Vec3(span, 0, 0)));
  c.lines[0].start = model::Start::straight;
  run::Simulation s(PETSC_COMM_WORLD, c);
  VecHandle r = s.system().create_vector();
  s.system().prepare(s.state().at_rest(), 0);
  s.system().residual(s.state().at_rest(), r.get());
  ASSERT_TRUE(s.system().norms(r.get()).small(1e-10)) << "the straight shape should balance";
  MatHandle J = s.system().create_matrix();
  const std::vector<double> zero(3 * static_cast<size_t>(s.local().blocks()), 0);
  s.system().tangent(s.state().at_rest(), {}, zero, false, J.get());
  EXPECT_GT(negative_eigenvalues(J.get()), 0);

  const StaticsReport report = s.solve_statics();
  const double P = reaction(s, 0).x();
  std::printf("buckled beam: escapes %d, negative eigenvalues %d, P L²/EI %.6f (exact %.6f, %.2e)\n",
              report.escapes, report.negative_eigenvalues, P, force, P / force - 1);
  EXPECT_GE(report.escapes, 1);
  EXPECT_EQ(report.negative_eigenvalues, 0);
  EXPECT_NEAR(P, force, 1e-3 * force);
}

// Round-off alone causes bending moments of 0.1 N m in the elements of a very stiff pile, more at large
// coordinates, although nothing bends it. The convergence criterion must allow for this. The top settles by w
// L²/(2 EA).
TEST(Statics, AStiffPileStandsStill) {
  for (const Vec3& foot : {Vec3(0, 0, -50), Vec3(310, -20, -50)})
    for (const int elements : {100, 200}) {
      model::LineType t = beam_type(1e12, 1e14, 1e14, 805);
      model::Case c = one_line(t, 50, elements, clamp(foot, Vec3::UnitZ()), {});
      c.environment.gravity = 9.80665;
      c.lines[0].start = model::Start::points;
      c.lines[0].points = {foot, foot + Vec3(0, 0, 50)};
      run::Simulation s(PETSC_COMM_WORLD, c);
      ASSERT_NO_THROW(s.solve_statics()) << elements;
      EXPECT_LT((s.state().x.back() - foot - Vec3(0, 0, 50 - 805 * 9.80665 * 50 * 50 / 2e12)).norm(), 1e-7);
    }
}

}  // namespace hawser::statics_planar_test
