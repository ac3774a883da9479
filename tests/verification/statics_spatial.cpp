// Beams in space: the 45-degree bend, the Princeton beam, path independence and objectivity.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "verification/statics_newton.hpp"

using namespace hawser;
using namespace hawser::test;

namespace {

constexpr double kRadius = 100, kArc = M_PI / 4;

// Bathe & Bolourchi (1979), Int. J. Numer. Meth. Engng 14: a quarter of a half circle, stress-free, clamped
// at the origin with its tangent along y, bending towards +x; all of it turned by `turn`.
struct Bend {
  model::Case c;
  std::unique_ptr<app::Simulation> s;

  Bend(const model::LineType& type, int elements, const Vec3& tip_force,
       const Quat& turn = Quat::Identity()) {
    c = one_line(type, kRadius * kArc, elements, clamp(Vec3::Zero(), turn * Vec3::UnitY()), {});
    c.lines[0].start = model::Start::points;
    for (int i = 0; i <= elements; ++i) {
      const double a = kArc * i / elements;
      c.lines[0].points.push_back(turn * (kRadius * Vec3(1 - std::cos(a), std::sin(a), 0)));
    }
    c.lines[0].point_loads.push_back({kRadius * kArc, turn * tip_force, Vec3::Zero(), 1, 0});
    s = std::make_unique<app::Simulation>(PETSC_COMM_WORLD, c);
    for (int i = 0; i <= elements; ++i) {
      const double a = kArc * i / elements;
      Mat3 axes;  // along the arc, towards its centre, z
      axes << std::sin(a), std::cos(a), 0, std::cos(a), -std::sin(a), 0, 0, 0, -1;
      s->state().q[static_cast<size_t>(i)] = turn * Quat(axes);
    }
    for (StructureTerm::Beam& b : s->structure().beams()) {
      const size_t i = static_cast<size_t>(b.at.first), j = static_cast<size_t>(b.at.second);
      BeamEnds e;
      e.x1 = s->state().x[i], e.x2 = s->state().x[j], e.q1 = s->state().q[i], e.q2 = s->state().q[j];
      b.reference = beam_reference(b.section, e, Mat3::Identity());
    }
  }
  Vec3 tip() const { return s->state().x.back(); }
};

// E = 1e7, a unit square, no Poisson effect: I = 1/12, G = E/2.
model::LineType bend_type(double J, double shear_factor) {
  const double E = 1e7;
  model::LineType t = beam_type(E, E / 12, J * E / 2);
  t.GA = shear_factor * E / 2;
  return t;
}

double bend_error(int elements, double P, double J, double shear_factor, const Vec3& exact) {
  Bend b(bend_type(J, shear_factor), elements, Vec3(0, 0, P));
  follow(*b.s, 10);
  return (b.tip() - exact).norm() / kRadius;
}

}  // namespace

// Reissner-Simo beam by shooting with DOP853 to 1e-12. The answer depends on the torsion constant: J = 1/6 or
// Saint-Venant's 0.1406 of the unit square, and a little on the shear stiffness.
TEST(Statics, FortyFiveDegreeBend) {
  struct {
    double J, shear, P;
    Vec3 tip;
  } const rows[] = {
      {1. / 6, 1, 300, {22.244780945367665, 58.779122489682806, 40.19189167015043}},
      {1. / 6, 1, 600, {15.684800534038718, 47.1504385736291, 53.47485879182459}},
      {1. / 6, 1, 1000, {10.98668164533804, 38.24157463395843, 60.21360284163936}},
      {1. / 6, 5. / 6, 600, {15.684689478979566, 47.150096240342116, 53.475477998224520}},
      {0.1405770, 5. / 6, 600, {15.557676149247344, 46.89158621923914, 53.607986406195394}},
  };
  for (const auto& r : rows) {
    double e[4];
    for (int i = 0; i < 4; ++i) e[i] = bend_error(4 << i, r.P, r.J, r.shear, r.tip);
    std::printf(
        "45-degree bend J %.4f GA/GA0 %.3f P %4.0f: error/R %.2e %.2e %.2e (8, 16, 32), order %.2f %.2f\n",
        r.J, r.shear, r.P, e[1], e[2], e[3], order(e[0], e[1]), order(e[1], e[2]));
    EXPECT_LT(e[1], 5e-3);
    EXPECT_LT(e[3], 1e-3);
    EXPECT_GT(order(e[0], e[1]), 1.9);
    EXPECT_GT(order(e[1], e[2]), 1.9);
  }
}

// Dowell & Traybar (1975), geometry 12.377 x 3.2024 mm, E = 71.7 GPa, nu = 0.31, L = 0.508 m; a weight P
// turned by theta from the stiff direction. Reissner-Simo beam by shooting to 1e-12: displacements of the tip
// (axial, chordwise, flapwise, m) and its twist.
TEST(Statics, PrincetonBeam) {
  struct {
    double P, theta;
    Vec3 u;
    double twist;
  } const rows[] = {
      {4.448, 0, {-3.391446301038e-05, -0.005359544660223, 0}, 0},
      {4.448, 15, {-0.000543778328286, -0.005210161673398, 0.02080108831531}, 0.2227212734483},
      {4.448, 30, {-0.001916792433756, -0.004751074791796, 0.03994940131083}, 0.382231229125},
      {4.448, 45, {-0.003746888674775, -0.00396516332666, 0.05605519287968}, 0.4359596350078},
      {4.448, 60, {-0.005527063010463, -0.002862206704572, 0.06812912236492}, 0.3730339756421},
      {4.448, 75, {-0.00680011852262, -0.001502994631613, 0.07557149697116}, 0.2135174198687},
      {4.448, 90, {-0.007259945575805, 0, 0.07808186768048}, 0},
      {8.896, 0, {-0.0001355802946174, -0.01071541276415, 0}, 0},
      {8.896, 15, {-0.002240836013395, -0.01062577118629, 0.04212521862131}, 0.9058173691757},
      {8.896, 30, {-0.007660816382476, -0.0101472407633, 0.07945607607937}, 1.511451328703},
      {8.896, 45, {-0.01438932029512, -0.008888857593776, 0.1090415676614}, 1.665025470058},
      {8.896, 60, {-0.02047318405176, -0.006654361326419, 0.1299235124282}, 1.380855392397},
      {8.896, 75, {-0.02458389656982, -0.003568890610469, 0.1422144166732}, 0.773935963223},
      {8.896, 90, {-0.02602422899667, 0, 0.1462599844282}, 0},
      {13.345, 0, {-0.0003048110001769, -0.0160651448079, 0}, 0},
      {13.345, 15, {-0.005298375171243, -0.01650289203532, 0.0644963094709}, 2.093707250025},
      {13.345, 30, {-0.01716341883653, -0.01677798761696, 0.1179022634291}, 3.329194649709},
      {13.345, 45, {-0.03036111445698, -0.0153422575769, 0.1565878233239}, 3.48469136601},
      {13.345, 60, {-0.04120638393305, -0.01171641543817, 0.1819211863616}, 2.77660181047},
      {13.345, 75, {-0.04807460916317, -0.00632843828184, 0.1961247073411}, 1.518695620878},
      {13.345, 90, {-0.05040567973917, 0, 0.2006929113721}, 0},
  };
  const double L = 0.508;
  model::LineType t = beam_type(2841908.71416, 0, 3.1033382708544615);
  t.EI2 = 2.428734443353508, t.EI3 = 36.27936354403289, t.GA = 903914.9854198474;
  double worst = 0, worst_twist = 0;
  for (const auto& r : rows) {
    const double a = r.theta * M_PI / 180;
    double e[3];
    for (int i = 0; i < 3; ++i) {
      if (i != 1 && r.theta != 45) continue;
      const model::Case c = cantilever(t, L, 10 << i, r.P * Vec3(0, -std::cos(a), std::sin(a)));
      app::Simulation s(PETSC_COMM_WORLD, c);
      follow(s, 8);
      e[i] = (s.state().x.back() - Vec3(L, 0, 0) - r.u).norm() / L;
      if (i != 1) continue;
      const Mat3 R = s.state().q.back().toRotationMatrix();
      const double twist = std::atan2(R(2, 1), R(1, 1)) * 180 / M_PI;  // of the chordwise axis
      worst = std::max(worst, e[i]);
      worst_twist = std::max(worst_twist, std::abs(twist - r.twist));
      EXPECT_LT(e[i], 1e-3) << r.P << " N at " << r.theta;
      EXPECT_NEAR(twist, r.twist, 1e-3 * 3.5) << r.P << " N at " << r.theta;
    }
    if (r.theta != 45) continue;
    std::printf(
        "Princeton beam %6.3f N at 45: error/L %.2e %.2e %.2e (10, 20, 40 elements), order %.2f %.2f\n", r.P,
        e[0], e[1], e[2], order(e[0], e[1]), order(e[1], e[2]));
    EXPECT_GT(order(e[0], e[2]) / 2, 1.9);
  }
  std::printf("Princeton beam, 20 elements, 21 loads: error/L at most %.2e, twist %.2e degrees\n", worst,
              worst_twist);
}

namespace {

// L = 10 along x, EI2 about y, EI3 about z, shear flexible.
model::LineType unequal_type() {
  model::LineType t = beam_type(1e6, 0, 500);
  t.EI2 = 1000, t.EI3 = 4000, t.GA = 5e5;
  return t;
}

// The tip after the loads `first` and then, on top of them, `second` have risen.
Vec3 loaded_tip(const Vec3& first, const Vec3& second, int elements, Vec3* root_moment = nullptr) {
  const model::Case a = cantilever(unequal_type(), 10, elements, first);
  app::Simulation sa(PETSC_COMM_WORLD, a);
  follow(sa, 20);
  model::Case b = cantilever(unequal_type(), 10, elements, second);
  b.lines[0].point_loads.push_back({10, first, Vec3::Zero(), 0, 0});
  app::Simulation sb(PETSC_COMM_WORLD, b);
  sb.state() = sa.state();
  follow(sb, 20);
  if (root_moment) *root_moment = reaction(sb, 0, 1);
  return sb.state().x.back();
}

}  // namespace

// Fy then Fz, Fz then Fy, both together: one equilibrium. Reissner-Simo beam by shooting to 1e-12; the root
// moment is that of the load.
TEST(Statics, FinalStateDoesNotDependOnThePath) {
  const Vec3 Fy(0, 30, 0), Fz(0, 0, 50);
  const Vec3 exact(5.887813974723862, 2.3848868789212005, 6.857480578827238);
  const Vec3 exact_moment(-86.48007341875685, -294.3906987361934, 176.63441924171596);
  Vec3 moment;
  const Vec3 yz = loaded_tip(Fy, Fz, 40), zy = loaded_tip(Fz, Fy, 40, &moment),
             both = loaded_tip(0.5 * (Fy + Fz), 0.5 * (Fy + Fz), 40);
  const double spread = std::max({(yz - zy).norm(), (yz - both).norm(), (zy - both).norm()}) / 10;
  double e[2];
  for (int i = 0; i < 2; ++i) e[i] = (loaded_tip(Fy, Fz, 20 << i) - exact).norm() / 10;
  std::printf("paths: spread/L %.2e; error/L %.2e %.2e (20, 40 elements), order %.2f; root moment %.2e\n",
              spread, e[0], e[1], order(e[0], e[1]), (moment + exact_moment).norm() / exact_moment.norm());
  EXPECT_LT(spread, 1e-8);
  EXPECT_LT(e[1], 1e-3);
  EXPECT_GT(order(e[0], e[1]), 1.9);
  EXPECT_LT((moment + exact_moment).norm(), 1e-3 * exact_moment.norm());
}

// Crisfield & Jelenic (1999), Proc. R. Soc. A 455: strains must not see a rigid rotation.
TEST(Statics, TurnedBendGivesTheTurnedTip) {
  const Vec3 P(0, 0, 600);
  Bend straight(bend_type(1. / 6, 1), 8, P);
  follow(*straight.s, 10);
  double worst = 0;
  for (const Vec3& turn : {Vec3(0.7, -1.9, 1.1), Vec3(-2.2, 0.4, 2.1), Vec3(0, 0, 3.1)}) {
    const Quat q = exp_so3(turn);
    Bend turned(bend_type(1. / 6, 1), 8, P, q);
    follow(*turned.s, 10);
    worst = std::max(worst, (turned.tip() - q * straight.tip()).norm() / kRadius);
  }
  std::printf("turned bend: difference/R %.2e\n", worst);
  EXPECT_LT(worst, 1e-8);
}

TEST(Statics, UnloadedBendTurnedTenTimesStoresNoEnergy) {
  Bend b(bend_type(1. / 6, 1), 8, Vec3::Zero());
  State& state = b.s->state();
  const Vec3 tip0 = b.tip();
  const int steps = 240;
  const Quat step = exp_so3(Vec3(0, 20 * M_PI / steps, 0));
  double energy = 0;
  for (int k = 0; k < steps; ++k) {
    state.q[0] = (step * state.q[0]).normalized();
    newton(b.s->system(), state);
    energy = std::max(energy, b.s->system().energy(state.view(0)).strain);
  }
  // Against the energy that the load of 600 N stores, some 1.6e4 J.
  std::printf("unloaded bend after ten turns: largest strain energy %.2e J, tip moved by %.2e R\n", energy,
              (b.tip() - tip0).norm() / kRadius);
  EXPECT_LT(energy, 1e-9);
  EXPECT_LT((b.tip() - tip0).norm(), 1e-8 * kRadius);
}

TEST(Statics, LoadedBendTurnedOnceComesBack) {
  const Vec3 P(0, 0, 600);
  const model::LineType t = bend_type(1. / 6, 1);
  Bend first(t, 8, P);
  follow(*first.s, 10);
  State state = first.s->state();
  const int steps = 120;
  double worst = 0;
  for (int k = 1; k <= steps; ++k) {
    const Quat turn = exp_so3(Vec3(0, 2 * M_PI * k / steps, 0)),
               before = exp_so3(Vec3(0, 2 * M_PI * (k - 1) / steps, 0));
    Bend b(t, 8, turn * P);
    state.q[0] = (turn * before.conjugate() * state.q[0]).normalized();
    newton(b.s->system(), state);
    worst = std::max(worst, (state.x.back() - turn * first.tip()).norm() / kRadius);
  }
  std::printf("loaded bend turned once: on the way off by at most %.2e R, back within %.2e R\n", worst,
              (state.x.back() - first.tip()).norm() / kRadius);
  EXPECT_LT(worst, 1e-8);
}
