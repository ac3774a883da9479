// Cable element and consistent mass of beams and cables: tangents against differences, energy balance of a
// step, and closed forms.
#include <gtest/gtest.h>

#include <random>

#include "hawser/kernels/cable.hpp"
#include "hawser/kernels/line_mass.hpp"
#include "hawser/math/so3.hpp"
#include "support/cable.hpp"

namespace hawser::cable_and_mass_test {

using namespace hawser::test;

namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

struct Random {
  std::mt19937 g;
  std::uniform_real_distribution<double> u{-1, 1};
  explicit Random(unsigned seed) : g(seed) {}
  Vec3 vec() { return {u(g), u(g), u(g)}; }
};

MassEnds random_ends(Random& r) {
  MassEnds e;
  for (Vec3* p : {&e.a1, &e.a2, &e.v1, &e.v2, &e.w1, &e.w2, &e.alpha1, &e.alpha2}) *p = r.vec();
  e.q1 = exp_so3(2 * r.vec());
  e.q2 = e.q1 * exp_so3(0.3 * r.vec());
  return e;
}

}  // namespace

TEST(Cable, TangentsAreDerivatives) {
  Random r(4);
  for (double beta : {0.0, 0.1}) {
    const CableSection s{1.1, 300, beta};
    CableState e{r.vec(), Vec3::Zero(), r.vec(), r.vec()};
    e.x2 = e.x1 + 1.4 * r.vec().normalized();
    CableMatrix K, C, Kd, Cd;
    cable_tangent(s, e, K, C);
    for (int j = 0; j < 6; ++j) {
      auto at = [&](double h, bool speed) {
        CableState m = e;
        (j < 3 ? (speed ? m.v1 : m.x1) : (speed ? m.v2 : m.x2))[j % 3] += h;
        return cable_end_forces(s, m);
      };
      Kd.col(j) = (at(1e-5, false) - at(-1e-5, false)) / 2e-5;
      Cd.col(j) = (at(1e-5, true) - at(-1e-5, true)) / 2e-5;
    }
    EXPECT_LT((K - Kd).norm(), 1e-8 * Kd.norm());
    EXPECT_LT((C - Cd).norm(), 1e-8 * (1 + Cd.norm()));
  }
}

TEST(Cable, SlackCarriesNothing) {
  const CableSection s{1.0, 300, 0.1};
  CableState e{Vec3::Zero(), Vec3(0.9, 0, 0)};
  e.v2 = Vec3(50, 0, 0);  // fast closing of the slack, while the cable is not yet taut: no tension
  EXPECT_EQ(cable_stress(s, e).tension, 0);
  e.x2.x() = 1.01;
  e.v2.x() = -50;  // damping must not cause compression
  EXPECT_EQ(cable_stress(s, e).tension, 0);
}

// A slack cable that snaps taut has a strain rate before any strain: its tension begins at zero.
TEST(Cable, TheDamperCarriesNoMoreThanTheSpring) {
  const CableSection s{1.0, 300, 0.1};
  CableState e{Vec3::Zero(), Vec3(1.01, 0, 0)};
  e.v2 = Vec3(0.05, 0, 0);
  EXPECT_NEAR(cable_stress(s, e).tension, 3 + 1.5, 1e-12);
  e.v2 = Vec3(50, 0, 0);
  EXPECT_NEAR(cable_stress(s, e).tension, 6, 1e-12);
  CableForce o;
  cable_force(s, {e.x1, e.x2, e.v1, e.v2}, 0, o);
  EXPECT_NEAR(o.k(0, 0), 600, 1e-9);
  EXPECT_EQ(o.c.norm(), 0);
}

// The damping of a step is limited so that the damper force stays below the spring's tension at the strain
// rate of the previous step.
TEST(CableMean, DampingIsThatOfTheStartOfTheStep) {
  const CableSection s{1.0, 300, 0.1};
  const auto damping = [&](double length, double strain_increment, double previous_h) {
    return cable_start(s, Vec3::Zero(), Vec3(length, 0, 0), strain_increment, previous_h).beta;
  };
  EXPECT_EQ(damping(1.01, 0, 1e-3), 0.1);
  EXPECT_EQ(damping(1.01, 5e-5, 1e-3), 0.1);
  EXPECT_NEAR(damping(1.01, 0.05, 1e-3), 0.01 / 50, 1e-15);
  EXPECT_NEAR(damping(1.01, -0.05, 1e-3), 0.01 / 50, 1e-15);
  EXPECT_EQ(damping(0.99, 0.05, 1e-3), 0);
  EXPECT_EQ(damping(1.01, 0.05, 0), 0.1);  // before the first step
  const CableStart from = cable_start(s, Vec3::Zero(), Vec3(1.01, 0, 0), 0.05, 1e-3);
  const Vec3 end(1.02, 0, 0);
  const double elastic = 300 * 0.015;
  const double damper = 300 * from.beta * 0.01 / 1e-3;
  EXPECT_NEAR(cable_mean_force(s, from, {1e-3, 0}, Vec3::Zero(), end).x(), elastic + damper, 1e-9);
  const double rigid = 300 * 100 * 0.01;  // 0.1 s are more than a hundred steps
  const CableStart at_rest = cable_start(s, Vec3::Zero(), Vec3(1.01, 0, 0), 0, 1e-4);
  EXPECT_NEAR(cable_mean_force(s, at_rest, {1e-4, 0}, Vec3::Zero(), end).x(), elastic + rigid, 1e-9);
}

// Steps of a cable with random end motion, slack and taut, and random step lengths.
struct Thrown {
  CableStart from;
  CableStep step;
  Vec3 x1, x2;
};
std::vector<Thrown> thrown(const CableSection& s, double filter) {
  Random r(21);
  std::vector<Thrown> out;
  Vec3 x1 = Vec3::Zero();
  Vec3 x2 = 0.95 * s.length * Vec3::UnitX();
  double strain_increment = 0, h = 0.1;
  for (int i = 0; i < 500; ++i) {
    const double previous_h = h;
    h = 0.1 * std::exp(r.u(r.g));
    Thrown t{cable_start(s, x1, x2, strain_increment * std::min(1.0, h / previous_h), previous_h),
             {h, filter},
             {},
             {}};
    t.x1 = x1 + 0.1 * r.vec();
    // In some steps the cable is stretched very little.
    t.x2 =
        t.x1 + (i % 7 == 0 ? 1e-7 : 0.2) * r.vec() + s.length * (1 + 0.15 * r.u(r.g)) * r.vec().normalized();
    if (i % 7 == 0) t.x2 = t.x1 + (x2 - x1) * (1 + 1e-9);
    out.push_back(t);
    x1 = t.x1;
    x2 = t.x2;
    strain_increment = cable_step_result(s, t.from, t.step, x1, x2).strain_increment;
  }
  return out;
}
ResponseCurve rope() {
  return ResponseCurve(std::vector<ResponseCurve::Row>{{0.05, 15}, {0.1, 90}, {0.2, 120}}, false);
}

TEST(CableMean, ItsWorkIsTheChangeOfEnergyAndWhatDampersTake) {
  const ResponseCurve table = rope();
  int pulled = 0, taut = 0;
  for (const ResponseCurve* t : {static_cast<const ResponseCurve*>(nullptr), &table})
    for (const double beta : {0.0, 0.02})
      for (const double filter : {0.0, 0.06}) {
        const CableSection s{1.1, 300, beta, t, t ? 0.01 : 0};
        for (const Thrown& p : thrown(s, filter)) {
          const Vec3 S = cable_mean_force(s, p.from, p.step, p.x1, p.x2);
          const Vec3 chord = p.x2 - p.x1;
          const auto energy = [&](const Vec3& d) {
            return cable_stress(s, {Vec3::Zero(), d, Vec3::Zero(), Vec3::Zero()}).strain_energy;
          };
          const double work = S.dot(chord - p.from.chord);
          const double stored = energy(chord) - energy(p.from.chord);
          const CableStepResult lost = cable_step_result(s, p.from, p.step, p.x1, p.x2);
          EXPECT_GE(lost.damped, 0);
          EXPECT_GE(S.dot(chord + p.from.chord), 0);                                // no compression
          EXPECT_LT(S.cross(chord + p.from.chord).norm(), 1e-12 * (1 + S.norm()));  // no moment
          pulled += S.norm() > 0;
          taut += S.norm() > 0 && energy(chord) > 0 && energy(p.from.chord) > 0;
          EXPECT_NEAR(work, stored + lost.damped + lost.filtered, 1e-10 * (1 + std::abs(stored)));
          // The force would be compressive, so it is zero, and the energy gained comes from the filter.
          if (S.norm() == 0) {
            EXPECT_LE(stored, 0.5 * filter * 300 * s.length * std::pow(p.from.strain_increment, 2) + 1e-12);
          }
        }
      }
  EXPECT_GT(pulled, 1500);
  EXPECT_GT(taut, 500);
}

// The filter returns no more energy than it has stored, for any step lengths.
TEST(CableMean, TheFilterGivesBackNoMoreThanItHolds) {
  const CableSection s{1.1, 300, 0};
  double sum = 0, least = 0, most = 0;
  for (const Thrown& p : thrown(s, 0.06)) {
    sum += cable_step_result(s, p.from, p.step, p.x1, p.x2).filtered;
    least = std::min(least, sum);
    most = std::max(most, sum);
  }
  EXPECT_GE(least, 0);
  EXPECT_GT(most, 1);
}

TEST(CableMean, TangentIsItsDerivative) {
  const ResponseCurve table = rope();
  for (const ResponseCurve* t : {static_cast<const ResponseCurve*>(nullptr), &table})
    for (const double beta : {0.0, 0.02}) {
      const CableSection s{1.1, 300, beta, t};
      int checked = 0;
      for (const Thrown& p : thrown(s, 0.06)) {
        CableForce o;
        cable_mean_force(s, p.from, p.step, p.x1, p.x2, o);
        EXPECT_EQ(o.c, Mat3::Zero());
        const auto at = [&](const Vec3& d) { return cable_mean_force(s, p.from, p.step, p.x1, p.x2 + d); };
        EXPECT_LT((o.force - at(Vec3::Zero())).norm(), 1e-12 * (1 + o.force.norm()));
        // Excludes kinks at the onset of tension.
        const double e = ((p.x2 - p.x1).norm() - s.length) / s.length;
        constexpr double kStep = 1e-6;
        if (std::abs(e) < 3 * kStep) continue;
        Mat3 K;
        bool kink = false;
        for (int j = 0; j < 3; ++j) {
          const Vec3 a = at(kStep * Vec3::Unit(j));
          const Vec3 b = at(-kStep * Vec3::Unit(j));
          K.col(j) = (a - b) / (2 * kStep);
          kink |= (a.norm() == 0) != (b.norm() == 0);
        }
        if (kink) continue;
        ++checked;
        EXPECT_LT((o.k - K).norm(), 1e-5 * (30 + K.norm())) << "strain from " << p.from.strain << " to " << e;
      }
      EXPECT_GT(checked, 450);
    }
}

TEST(CableMean, IsTheForceAtRest) {
  const CableSection s{1.1, 300, 0.02};
  const Vec3 a(0.1, 0.2, 0.3), b(0.9, 1.0, 0.8);
  const Vec3 at_rest = cable_force(s, {a, b, Vec3::Zero(), Vec3::Zero()});
  EXPECT_GT(at_rest.norm(), 1);
  EXPECT_LT((cable_mean_force(s, cable_start(s, a, b, 0, 0), {0.1, 0.06}, a, b) - at_rest).norm(), 1e-12);
}

TEST(CableMass, IsTheForceOfUnitAccelerations) {
  const MassSection s{2.0, 3.0};
  const CableMass m = cable_mass(s);
  EXPECT_NEAR(2 * (m.diagonal + m.shared), 6, 1e-12);  // mass of the element
  for (int j = 0; j < 6; ++j) {
    Eigen::Matrix<double, 6, 1> f;
    Eigen::Matrix<double, 6, 1> expected = Eigen::Matrix<double, 6, 1>::Zero();
    const Vec3 a1 = j < 3 ? Vec3(Vec3::Unit(j)) : Vec3(Vec3::Zero());
    const Vec3 a2 = j < 3 ? Vec3(Vec3::Zero()) : Vec3(Vec3::Unit(j - 3));
    cable_mass_force(s, a1, a2, Vec3::Zero(), f);
    expected[j] = m.diagonal;
    expected[(j + 3) % 6] = m.shared;
    EXPECT_LT((f - expected).norm(), 1e-12);
  }
}

TEST(BeamMass, TangentsAreDerivatives) {
  Random r(9);
  for (int trial = 0; trial < 6; ++trial) {
    const Mat3 axes = exp_so3(r.vec()).toRotationMatrix();
    MassSection s{1.7, 3.1, Vec3(0.4, 0.2, 0.3), &axes};
    const MassEnds e = random_ends(r);
    const Vec3 load = 5 * r.vec();
    Mat12 K, C, M, D[3];
    Vec12 f, a, b;
    beam_mass_tangent(s, e, load, f, K, C, M);
    for (int kind = 0; kind < 3; ++kind)
      for (int j = 0; j < 12; ++j) {
        auto at = [&](double h, Vec12& out) {
          MassEnds m = e;
          const int node = j / 6;
          const int c = j % 3;
          const bool turn = j % 6 >= 3;
          const Vec3 d = h * Vec3::Unit(c);
          if (kind == 0 && turn) (node ? m.q2 : m.q1) = (node ? m.q2 : m.q1) * exp_so3(d);
          if (kind == 1) (turn ? (node ? m.w2 : m.w1) : (node ? m.v2 : m.v1)) += d;
          if (kind == 2) (turn ? (node ? m.alpha2 : m.alpha1) : (node ? m.a2 : m.a1)) += d;
          beam_mass_force(s, m, load, out);
        };
        at(1e-5, a);
        at(-1e-5, b);
        D[kind].col(j) = (a - b) / 2e-5;
      }
    EXPECT_LT((K - D[0]).norm(), 1e-8 * D[0].norm());
    EXPECT_LT((C - D[1]).norm(), 1e-8 * D[1].norm());
    EXPECT_LT((M - D[2]).norm(), 1e-8 * D[2].norm());
  }
}

TEST(BeamMass, KineticEnergyChangesByThePowerOfInertia) {
  // d/dt T = v . f along any motion: checks that the gyroscopic terms belong to the same energy.
  Random r(2);
  const MassSection s{0.8, 2.0, Vec3(0.5, 0.1, 0.2)};
  const MassEnds e = random_ends(r);
  Vec12 f, v;
  beam_mass_force(s, e, Vec3::Zero(), f);
  v << e.v1, e.w1, e.v2, e.w2;
  auto energy_at = [&](double h) {
    MassEnds m = e;
    m.v1 += h * e.a1;
    m.v2 += h * e.a2;
    m.w1 += h * e.alpha1;
    m.w2 += h * e.alpha2;
    m.q1 = e.q1 * exp_so3(h * e.w1);
    m.q2 = e.q2 * exp_so3(h * e.w2);
    return beam_kinetic_energy(s, m);
  };
  EXPECT_NEAR((energy_at(1e-5) - energy_at(-1e-5)) / 2e-5, f.dot(v), 1e-7 * f.norm());
}

TEST(BeamMass, UniformAccelerationOfAStraightBarWeighsItsMass) {
  const MassSection s{2.0, 3.0};
  MassEnds e;
  e.a1 = e.a2 = Vec3(1, -2, 4);
  Vec12 f;
  beam_mass_force(s, e, Vec3::Zero(), f);
  EXPECT_LT((f.segment<3>(0) + f.segment<3>(6) - 6 * e.a1).norm(), 1e-12);
  // A load of m a per length balances the inertia exactly, moments included.
  beam_mass_force(s, e, 3.0 * e.a1, f);
  EXPECT_LT(f.norm(), 1e-12);
}

}  // namespace hawser::cable_and_mass_test
