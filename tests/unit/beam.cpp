// Beam element: tangents against differences, force as the gradient of the energy, rigid motion, pure
// bending, and damping that only dissipates.
#include "hawser/kernels/beam.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "hawser/math/so3.hpp"

namespace hawser::beam_test {
namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

struct Set {
  BeamSection s;
  BeamReference r;
  BeamEnds e;
  std::shared_ptr<const Mat3> axes;  // of r
};

Set random_set(unsigned seed, double bend, double beta, bool turned) {
  std::mt19937 g(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  auto vec = [&] { return Vec3(u(g), u(g), u(g)); };
  Set t;
  t.s = {1.3, 2e3, 15, 40, 23, seed % 2 ? 900. : 0., beta};
  t.e.q1 = exp_so3(2 * vec());
  t.e.q2 = t.e.q1 * exp_so3(bend * vec());
  Mat3 turn = Mat3::Identity();
  if (turned) {
    turn = exp_so3(vec()).toRotationMatrix();
    t.axes = std::make_shared<const Mat3>(turn);
    t.r.axes = t.axes.get();
    t.r.psi = 0.1 * vec();
    t.r.strain = 0.01;
  }
  t.e.x1 = vec();
  t.e.x2 = t.e.x1 + t.e.q1 * (turn * (1.35 * (Vec3::UnitX() + 0.3 * bend * vec())));
  t.e.v1 = vec();
  t.e.v2 = vec();
  t.e.w1 = vec();
  t.e.w2 = vec();
  return t;
}

BeamEnds moved(BeamEnds e, const Vec12& d) {
  e.x1 += d.segment<3>(0);
  e.x2 += d.segment<3>(6);
  e.q1 = e.q1 * exp_so3(d.segment<3>(3));
  e.q2 = e.q2 * exp_so3(d.segment<3>(9));
  return e;
}
BeamEnds quickened(BeamEnds e, const Vec12& d) {
  e.v1 += d.segment<3>(0);
  e.w1 += d.segment<3>(3);
  e.v2 += d.segment<3>(6);
  e.w2 += d.segment<3>(9);
  return e;
}
Vec12 force(const Set& t, const BeamEnds& e) {
  Vec12 f;
  beam_force(t.s, t.r, e, f);
  return f;
}

}  // namespace

TEST(Beam, TangentIsTheDerivativeOfTheForce) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    const Set t = random_set(seed, seed < 12 ? 0.2 : 1.2, seed % 3 ? 0.07 : 0, seed % 4 > 1);
    Mat12 K, C = Mat12::Zero(), Kd, Cd;
    Vec12 f;
    beam_tangent(t.s, t.r, t.e, false, f, K, &C);
    EXPECT_LT((f - force(t, t.e)).norm(), 1e-13 * f.norm());
    const double h = 3e-5;
    for (int j = 0; j < 12; ++j) {
      const Vec12 d = h * Vec12::Unit(j);
      // Fourth-order differences, so that the tolerance of 1e-6 tests the tangent and not the difference
      // formula.
      Kd.col(j) = (8 * (force(t, moved(t.e, d)) - force(t, moved(t.e, -d))) -
                   (force(t, moved(t.e, 2 * d)) - force(t, moved(t.e, -2 * d)))) /
                  (12 * h);
      Cd.col(j) = (force(t, quickened(t.e, d)) - force(t, quickened(t.e, -d))) / (2 * h);
    }
    EXPECT_LT((K - Kd).norm(), 1e-8 * Kd.norm()) << "seed " << seed;
    EXPECT_LT((C - Cd).norm(), 1e-8 * (Cd.norm() + 1)) << "seed " << seed;
  }
}

TEST(Beam, UndampedTangentIsAHessian) {
  // Along material increments the skew part of the Hessian is half the moment (fields do not commute).
  const Set t = random_set(5, 0.8, 0, true);
  Mat12 K;
  Vec12 f;
  beam_tangent(t.s, t.r, t.e, false, f, K, nullptr);
  Mat12 skew = Mat12::Zero();
  skew.block<3, 3>(3, 3) = 0.5 * hat(f.segment<3>(3));
  skew.block<3, 3>(9, 9) = 0.5 * hat(f.segment<3>(9));
  EXPECT_LT((0.5 * (K - K.transpose()) - skew).norm(), 1e-12 * K.norm());
}

TEST(Beam, ForceIsTheGradientOfTheEnergy) {
  const Set t = random_set(8, 0.8, 0, true);
  const Vec12 f = force(t, t.e);
  for (int j = 0; j < 12; ++j) {
    const Vec12 d = 1e-5 * Vec12::Unit(j);
    const double g = (beam_stress(t.s, t.r, moved(t.e, d)).strain_energy -
                      beam_stress(t.s, t.r, moved(t.e, -d)).strain_energy) /
                     2e-5;
    EXPECT_NEAR(f[j], g, 1e-7 * f.norm());
  }
}

TEST(Beam, RigidMotionTurnsTheForceAndKeepsTheMoment) {
  const Set t = random_set(3, 0.6, 0, false);
  const Quat R = exp_so3(Vec3(2.1, -1.3, 0.4));
  BeamEnds e = t.e;
  e.x1 = R * e.x1 + Vec3(1, 2, 3);
  e.x2 = R * e.x2 + Vec3(1, 2, 3);
  e.q1 = R * e.q1;
  e.q2 = R * e.q2;
  const Vec12 a = force(t, t.e);
  const Vec12 b = force(t, e);
  EXPECT_LT((R * a.segment<3>(6) - b.segment<3>(6)).norm(), 1e-12 * a.norm());
  EXPECT_LT((a.segment<3>(9) - b.segment<3>(9)).norm(), 1e-12 * a.norm());
}

TEST(Beam, ACircularArcIsPureBending) {
  // L = 2, radius 5: moment EI/R, no tension to O(angle^4).
  const double L = 0.5;
  const double R = 5;
  const double phi = L / R;
  BeamSection s{L, 1e6, 3e3, 4e3, 1e3, 0, 0};
  BeamEnds e;
  e.x1 = Vec3::Zero();
  e.x2 = Vec3(R * std::sin(phi), R * (1 - std::cos(phi)), 0);
  e.q1 = Quat::Identity();
  e.q2 = exp_so3(Vec3(0, 0, phi));
  const BeamStress b = beam_stress(s, {}, e);
  EXPECT_NEAR(b.moment1.z(), s.EI3 / R, 1e-9);
  EXPECT_NEAR(b.moment2.z(), s.EI3 / R, 1e-9);
  EXPECT_NEAR(b.tension, 0, 1e6 * std::pow(phi, 4) / 1000);
}

TEST(Beam, DampingOnlyTakesEnergy) {
  const Set t = random_set(11, 0.7, 0.05, false);
  BeamSection still = t.s;
  still.beta = 0;
  Set u = t;
  u.s = still;
  const Vec12 f = force(t, t.e) - force(u, t.e);
  Vec12 v;
  v << t.e.v1, t.e.w1, t.e.v2, t.e.w2;
  EXPECT_GT(f.dot(v), 0);
  EXPECT_NEAR(f.dot(v), beam_stress(t.s, t.r, t.e).dissipation, 1e-10 * f.norm() * v.norm());
  // A rigid motion dissipates no energy.
  Set w = t;
  const Vec3 spin(0.3, -0.8, 0.5);
  w.e.v1 = spin.cross(w.e.x1);
  w.e.v2 = spin.cross(w.e.x2);
  w.e.w1 = w.e.q1.conjugate() * spin;
  w.e.w2 = w.e.q2.conjugate() * spin;
  EXPECT_LT(beam_stress(w.s, w.r, w.e).dissipation, 1e-20);
}

}  // namespace hawser::beam_test
