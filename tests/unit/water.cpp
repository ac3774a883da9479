// Buoyancy, drag and added mass of an element against closed forms, quadratures and differences; the current.
#include <gtest/gtest.h>

#include "hawser/kernels/current.hpp"
#include "hawser/kernels/line_water.hpp"
#include "hawser/kernels/wetting.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/math/symmetric.hpp"

namespace hawser::water_test {
namespace {

constexpr double kRho = 1025, kG = 9.80665;

WaterSection section(double length, double d, double Cd = 1.2, double Cax = 0.1, double Ca = 1) {
  const double A = M_PI / 4 * d * d;
  WaterSection s;
  s.length = length;
  s.radius = d / 2;
  s.buoyancy = kRho * kG * A;
  s.displaced_mass = kRho * A;
  s.added_normal = Ca * kRho * A;
  s.drag_normal = 0.5 * kRho * Cd * d;
  s.drag_axial = 0.5 * kRho * Cax * M_PI * d;
  return s;
}

CableInWater cable(const WaterEnds& e) {
  const MassEnds& m = e.motion;
  return {e.x1, e.x2, m.v1, m.v2, m.a1, m.a2, e.water1, e.water2};
}

// Residual over (x1, x2) of a cable, (x1, theta1, x2, theta2) of a beam.
Eigen::VectorXd water_residual(bool beam, const WaterSection& s, const WaterEnds& e) {
  Vec12 on_beam;
  Vec6 on_cable;
  if (beam)
    beam_water_force(s, e, on_beam);
  else
    cable_water_force(s, cable(e), on_cable);
  return beam ? Eigen::VectorXd(on_beam) : Eigen::VectorXd(on_cable);
}

// Wetted area against quadrature of the chord of a circle, wetted volume against quadrature of the sections
// of a sphere.
TEST(Wetting, IsTheSegmentOfACircleAndTheCapOfABall) {
  double area = 0, cap = 0, area_sum = 0, cap_sum = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double h = 2.0 / n;
    const double u = -1 + (i + 0.5) * h;
    area += h * 2 * std::sqrt(1 - u * u) / M_PI;
    cap += h * 0.75 * (1 - u * u);
    area_sum += h * area;
    cap_sum += h * cap;
    if (i % 9973) continue;
    const double end = u + h / 2;
    EXPECT_NEAR(circle_wetting(end).fraction, area, 1e-7);
    EXPECT_NEAR(ball_wetting(end).fraction, cap, 1e-7);
    EXPECT_NEAR(circle_wetting(end).integral, area_sum, 2e-5);
    EXPECT_NEAR(ball_wetting(end).integral, cap_sum, 2e-5);
  }
  for (const auto law : {circle_wetting, ball_wetting}) {
    EXPECT_EQ(law(1.5).fraction, 1);
    EXPECT_EQ(law(1.5).integral, 1.5);
    EXPECT_EQ(law(-1.2).fraction, 0);
    EXPECT_NEAR(law(1 - 1e-9).integral, 1, 1e-8);
  }
}

// Draught over diameter of a floating hose of 0.12 t/m in air and 0.20 t/m displacement, that is 0.6 of the
// section (OMAE2006-92155, Table 4; solution of the circular segment).
TEST(WaterLoad, FloatingHoseSinksToItsDraught) {
  const double d = std::sqrt(200 / 1025. * 4 / M_PI);
  const double weight = 120 * kG;
  EXPECT_NEAR(d, 0.4984345337, 1e-9);
  for (const bool beam : {false, true}) {
    const WaterSection s = section(10, d);
    double low = -d;
    double high = d;
    for (int i = 0; i < 60; ++i) {
      const double z = 0.5 * (low + high);
      WaterEnds e;
      e.x1 = {0, 0, z};
      e.x2 = {10, 0, z};
      (-water_residual(beam, s, e)[2] > weight * 5 ? low : high) = z;
    }
    EXPECT_NEAR((d / 2 - low) / d, 0.5788680969, 1e-9);
  }
}

// Means over a straight piece, and their derivatives, against quadrature of circle_wetting, for level, nearly
// level and steep pieces, on both sides of the limits between formulas.
TEST(Wetting, OfAPieceIsTheMeanOfItsSections) {
  const double b = 0.7;
  const double rises[] = {0, 1e-8, -1e-6, 1e-3, 0.1, -0.17, 0.18, 0.5, -1.3, 4, 400};
  for (const double rise : rises)
    for (const double middle : {-0.69, -0.6, -0.1, 0.0, 0.35, 0.68, 1.2}) {
      const double h1 = middle - 0.5 * rise;
      const double h2 = middle + 0.5 * rise;
      double integral = 0, fraction[2] = {}, slope[3] = {};
      const int n = 400000;
      for (int i = 0; i < n; ++i) {
        const double z = (i + 0.5) / n;
        const Wetting w = circle_wetting((h1 + z * rise) / b);
        integral += b * w.integral / n;
        fraction[0] += (1 - z) * w.fraction / n;
        fraction[1] += z * w.fraction / n;
        slope[0] += (1 - z) * (1 - z) * w.slope / b / n;
        slope[1] += z * (1 - z) * w.slope / b / n;
        slope[2] += z * z * w.slope / b / n;
      }
      const PieceWetting p = piece_wetting(h1, h2, b);
      // Accuracy of the quadrature at the limits of the partly wet band.
      const double near = 1e-9 * (1 + std::abs(rise));
      const double edge = 2e-5;
      EXPECT_NEAR(p.integral, integral, near) << rise << " " << middle;
      EXPECT_NEAR(p.by_h1, fraction[0], 2e-8) << rise << " " << middle;
      EXPECT_NEAR(p.by_h2, fraction[1], 2e-8) << rise << " " << middle;
      EXPECT_NEAR(p.slope11, slope[0], edge) << rise << " " << middle;
      EXPECT_NEAR(p.slope12, slope[1], edge) << rise << " " << middle;
      EXPECT_NEAR(p.slope22, slope[2], edge) << rise << " " << middle;
    }
}

// For any thickness and position of a beam through the surface, a vertical element displaces its submerged
// volume, and its stiffness is that of its waterplane, rho g A: both by hand. A cable becomes wet over a
// height of its radius.
TEST(WaterLoad, SteepElementsDisplaceWhatIsUnderWater) {
  for (const bool beam : {false, true})
    for (const double d : {0.3, 5.0, 6.0}) {
      const WaterSection s = section(10, d);
      const double band = beam ? 0.011 : d / 2;
      double last = 0;
      for (int i = 0; i <= 3000; ++i) {
        const double middle = 9 - 0.006 * i;
        WaterEnds e;
        e.x1 = {0, 0, middle - 5};
        e.x2 = {0, 0, middle + 5};
        e.motion.q1 = e.motion.q2 = minimal_rotation(Vec3::UnitX(), Vec3::UnitZ());
        double lift = 0, stiffness = 0;  // of both ends by z of both ends
        if (beam) {
          Vec12 f;
          Mat12 K, C, M;
          beam_water_tangent(s, e, false, f, K, C, M);
          lift = -f[2] - f[8];
          stiffness = K(2, 2) + K(2, 8) + K(8, 2) + K(8, 8);
        } else {
          Vec6 f;
          Mat6 K, C, M;
          cable_water_tangent(s, cable(e), false, f, K, C, M);
          lift = -f[2] - f[5];
          stiffness = K(2, 2) + K(2, 5) + K(5, 2) + K(5, 5);
        }
        const double now = lift / (10 * s.buoyancy);
        EXPECT_GE(now, last - 1e-12);
        EXPECT_LT(now - last, 1.0001 * 0.0006);
        last = now;
        if (std::abs(std::abs(middle) - 5) < band) continue;
        EXPECT_NEAR(now, std::clamp((5 - middle) / 10, 0.0, 1.0), 1e-10);
        EXPECT_NEAR(stiffness, std::abs(middle) < 5 ? s.buoyancy : 0, 1e-8 * s.buoyancy)
            << d << " " << middle;
      }
      EXPECT_NEAR(last, 1, 1e-15);
    }
}

// The potential of an inclined cylinder of few or many beams is that of a body: depth times rho g over the
// submerged part, by quadrature.
TEST(WaterLoad, ALeaningCylinderDisplacesWhatIsUnderWater) {
  const double radius = 0.5, length = 4;
  for (const double angle : {0.0, 0.4, 1.0, 1.4}) {
    const Vec3 t(std::cos(angle), 0, std::sin(angle));
    const Vec3 middle(0, 0, 0.13);
    const Vec3 across = Vec3::UnitY().cross(t);
    double exact = 0;
    for (int i = 0; i < 1000; ++i)
      for (int j = 0; j < 1000; ++j) {
        const double along = ((i + 0.5) / 1000 - 0.5) * length;
        const double up = (2 * (j + 0.5) / 1000 - 1) * radius;
        const double z = (middle + along * t + up * across).z();
        exact += std::max(-z, 0.0) * 2 * std::sqrt(radius * radius - up * up) * (length / 1000) *
                 (2 * radius / 1000) * kRho * kG;
      }
    for (const int n : {1, 3, 40}) {
      const WaterSection s = section(length / n, 2 * radius);
      double sum = 0;
      for (int i = 0; i < n; ++i) {
        WaterEnds e;
        e.x1 = middle + (i * s.length - length / 2) * t;
        e.x2 = e.x1 + s.length * t;
        e.motion.q1 = e.motion.q2 = minimal_rotation(Vec3::UnitX(), t);
        sum += water_potential(s, e, true);
      }
      EXPECT_NEAR(sum, exact, 5e-5 * exact) << angle << " " << n;  // error of the quadrature
    }
  }
}

// Tangents of inclined elements, thin and thick relative to their length, against fourth-order differences.
// The stiffness that statics uses far from the solution has no negative eigenvalue.
TEST(WaterLoad, TangentOfALeaningElement) {
  for (const double d : {0.2, 8.0})
    for (const double angle : {0.1, 0.8, 1.5}) {
      const WaterSection s = section(4, d);
      const Vec3 t(std::cos(angle) * 0.6, std::cos(angle) * 0.8, std::sin(angle));
      Vec3 x[2] = {{0, 0, -0.8 * t.z() + 0.03}, 4.1 * t + Vec3(0, 0, -0.8 * t.z() + 0.03)};
      const Vec3 v[2] = {{0.3, -0.2, 0.5}, {0.1, 0.4, -0.3}}, a[2] = {{1, 0.2, -0.4}, {-0.3, 0.6, 0.2}};
      Water water[2];
      water[0].velocity = Vec3(0.7, 0.2, 0.1);
      water[1].velocity = Vec3(0.9, -0.1, 0.2);
      water[0].surface = 0.02;
      water[1].surface = -0.03;
      const CableInWater e{x[0], x[1], v[0], v[1], a[0], a[1], water[0], water[1]};
      Vec6 f;
      Mat6 K, C, M;
      cable_water_tangent(s, e, false, f, K, C, M);
      const double most = K.cwiseAbs().maxCoeff();
      for (int c = 0; c < 6; ++c) {
        const double h = 1e-4;
        Vec6 g[4];
        const double at[4] = {-2 * h, -h, h, 2 * h};
        for (int i = 0; i < 4; ++i) {
          const double kept = x[c / 3][c % 3];
          x[c / 3][c % 3] += at[i];
          cable_water_force(s, e, g[i]);
          x[c / 3][c % 3] = kept;
        }
        for (int r = 0; r < 6; ++r)
          EXPECT_NEAR(K(r, c), (g[0][r] - 8 * g[1][r] + 8 * g[2][r] - g[3][r]) / (12 * h), 1e-6 * most)
              << d << " " << angle << " " << r << c;
      }
      cable_water_tangent(s, e, true, f, K, C, M);
      const Eigen::Matrix<double, 6, 6> k = K;
      EXPECT_LT((k - k.transpose()).norm(), 1e-12 * k.norm());
      EXPECT_GT(eigenpairs(k).values[0], -1e-9 * most);
      EXPECT_GT(k.norm(), 0.1 * most);
    }
}

TEST(WaterLoad, ForceIsTheDerivativeOfThePotential) {
  const WaterSection s = section(4, 0.6, 0, 0, 0);
  WaterEnds e;
  e.x1 = {0, 0, -0.3};
  e.x2 = {3.9, 0.2, 0.5};
  e.water1.surface = 0.1;
  e.water2.surface = 0.2;
  e.motion.q1 = exp_so3({0, -0.3, 0.1});
  e.motion.q2 = exp_so3({0.2, -0.1, 0});
  for (const bool beam : {false, true}) {
    const Eigen::VectorXd f = water_residual(beam, s, e);
    for (int node = 0; node < 2; ++node)
      for (int c = 0; c < (beam ? 6 : 3); ++c) {
        const auto V = [&](double step) {
          WaterEnds o = e;
          const Vec3 d = step * Vec3::Unit(c % 3);
          if (c < 3)
            (node ? o.x2 : o.x1) += d;
          else
            (node ? o.motion.q2 : o.motion.q1) = (node ? e.motion.q2 : e.motion.q1) * exp_so3(d);
          return water_potential(s, o, beam);
        };
        const double h = 1e-4;
        const double slope = (V(h) - V(-h)) / (2 * h);
        EXPECT_NEAR(f[(beam ? 6 : 3) * node + c], slope, 2e-6 * s.buoyancy * 4) << beam << node << c;
      }
  }
}

// An inclined line in a uniform current: Morison's force by hand, the same for cable and beam.
TEST(WaterLoad, MorisonOfASlantingLine) {
  const WaterSection s = section(5, 0.2, 1.1, 0.05, 0.9);
  WaterEnds e;
  const Vec3 t = Vec3(3, 0, 4) / 5;
  e.x1 = {0, 0, -50};
  e.x2 = e.x1 + 5 * t;
  e.motion.q1 = e.motion.q2 = minimal_rotation(Vec3::UnitX(), t);
  e.water1.velocity = e.water2.velocity = Vec3(0.8, -0.5, 0);
  const Vec3 v(-0.1, 0.2, 0.3), a(0.4, -0.2, 0.7);
  e.motion.v1 = e.motion.v2 = v;
  e.motion.a1 = e.motion.a2 = a;
  const Vec3 u = Vec3(0.8, -0.5, 0) - v;
  const Vec3 un = u - u.dot(t) * t;
  const Vec3 an = a - a.dot(t) * t;
  const double A = M_PI / 4 * 0.04;
  const Vec3 drag = 0.5 * kRho * 1.1 * 0.2 * un.norm() * un +
                    0.5 * kRho * 0.05 * M_PI * 0.2 * std::abs(u.dot(t)) * u.dot(t) * t;
  EXPECT_LT((line_drag(s, u, t) - drag).norm(), 1e-14 * drag.norm());
  const Vec3 expected = 5 * (drag - 0.9 * kRho * A * an + kRho * kG * A * Vec3::UnitZ());
  for (const bool beam : {false, true}) {
    const Eigen::VectorXd f = water_residual(beam, s, e);
    EXPECT_LT((f.segment<3>(0) + f.segment<3>(beam ? 6 : 3) + expected).norm(), 1e-12 * expected.norm());
  }
}

// Force in accelerating water: (1 + Ca) across the line, 1 + Ca_axial along it.
TEST(WaterLoad, FroudeKrylovAndAddedMass) {
  WaterSection s = section(5, 0.2, 0, 0, 0.9);
  s.added_axial = 0.1 * s.displaced_mass;
  WaterEnds e;
  e.x1 = {0, 0, -50};
  e.x2 = {5, 0, -50};
  e.water1.acceleration = e.water2.acceleration = Vec3(2, 3, 0);
  for (const bool beam : {false, true}) {
    const Eigen::VectorXd f = water_residual(beam, s, e);
    const Vec3 sum = f.segment<3>(0) + f.segment<3>(beam ? 6 : 3);
    EXPECT_NEAR(-sum.x(), 5 * s.displaced_mass * 1.1 * 2, 1e-9);
    EXPECT_NEAR(-sum.y(), 5 * s.displaced_mass * 1.9 * 3, 1e-9);
  }
}

TEST(Current, TableAndPowerLaw) {
  Vec3 u, d;
  const CurrentProfile table({{10, Vec3(1, 0, 0)}, {30, Vec3(0, 0.5, 0)}});
  table.at(2, u, d);
  EXPECT_EQ(u, Vec3(1, 0, 0));
  EXPECT_EQ(d, Vec3(0, 0, 0));
  table.at(15, u, d);
  EXPECT_LT((u - Vec3(0.75, 0.125, 0)).norm(), 1e-15);
  EXPECT_LT((d - Vec3(-0.05, 0.025, 0)).norm(), 1e-15);
  table.at(300, u, d);
  EXPECT_EQ(u, Vec3(0, 0.5, 0));
  const CurrentProfile law(Vec3(2, 0, 0), 1. / 7, 100);
  law.at(50, u, d);
  EXPECT_NEAR(u.x(), 2 * std::pow(0.5, 1. / 7), 1e-14);
  Vec3 a, b, x;
  for (const double z : {1.0, 50.0, 99.0, 99.95}) {
    law.at(z + 1e-5, a, x);
    law.at(z - 1e-5, b, x);
    law.at(z, u, d);
    EXPECT_NEAR(d.x(), (a.x() - b.x()) / 2e-5, 1e-6 * std::abs(d.x())) << z;
  }
  law.at(120, u, d);
  EXPECT_EQ(u.norm(), 0);
  law.at(-3, u, d);
  EXPECT_EQ(u.x(), 2);
  EXPECT_THROW(CurrentProfile({{10, Vec3(1, 0, 0)}, {10, Vec3(1, 0, 0)}}), std::invalid_argument);
}

TEST(Current, FactorByTime) {
  EXPECT_EQ(TimeFactor().at(17), 1);
  const TimeFactor f({{-10, 0.5}, {30, 2}, {40, -1}});
  EXPECT_EQ(f.at(-20), 0.5);
  EXPECT_EQ(f.at(-10), 0.5);
  EXPECT_NEAR(f.at(0), 0.875, 1e-15);
  EXPECT_EQ(f.at(30), 2);
  EXPECT_NEAR(f.at(38), -0.4, 1e-15);
  EXPECT_EQ(f.at(1e9), -1);
  EXPECT_THROW(TimeFactor({{1, 1}, {1, 2}}), std::invalid_argument);
}

}  // namespace
}  // namespace hawser::water_test
