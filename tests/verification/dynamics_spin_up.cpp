// A beam whose root is rotated about z with increasing, then constant speed (Simo & Vu-Quoc 1986), against
// spectral elements and the closed form of the steady stretch.
#include <algorithm>

#include "verification/dynamics_rig.hpp"

namespace hawser::test::dynamics_spin_up_test {
namespace {

// psi(t) = 6/15 [t²/2 + (15/2pi)² (cos(2 pi t/15) - 1)], from 15 s on 6 t - 45.
RigidPose root(double t) {
  const double k = 2 * M_PI / 15;
  double psi = 6 * t - 45;
  double rate = 6;
  double second = 0;
  if (t < 15) {
    psi = 0.4 * (t * t / 2 + (std::cos(k * t) - 1) / (k * k));
    rate = 0.4 * (t - std::sin(k * t) / k);
    second = 0.4 * (1 - std::cos(k * t));
  }
  RigidPose p;
  p.rotation = exp_so3(psi * Vec3::UnitZ());
  p.angular_velocity = rate * Vec3::UnitZ();
  p.angular_acceleration = second * Vec3::UnitZ();
  return p;
}

// Tip displacement (t, u1, u2) in axes that rotate with the root: spectral elements of order 10 and 12 with
// explicit Runge-Kutta agree within 1e-9.
constexpr double kTip[][3] = {
    {1, -2.4363385987768993e-05, -0.020543531979102428}, {2, -0.0006059014734027812, -0.10238063223220756},
    {3, -0.0027282885409007918, -0.21726735876225245},   {4, -0.00676600672285943, -0.34227864747799863},
    {5, -0.01265463623053975, -0.46847618344062797},     {6, -0.016971249533106914, -0.5435964003182525},
    {7, -0.018618255398800798, -0.5713118064455704},     {8, -0.01662991956666282, -0.542841535115004},
    {9, -0.011745304578628435, -0.46027111570289936},    {10, -0.0070723362866456085, -0.3628145156591378},
    {11, -0.003298305319994199, -0.25735103050069297},   {12, -0.0008039872391076841, -0.15090069710586906},
    {13, 0.00023335912356081678, -0.06921548480569006},  {14, 0.0004900604820079479, -0.020291337732294412},
    {15, 0.0005139896816714895, 0.001303626236256683}};
// Steady stretch of a rotating bar, closed form: tan(k L)/k - L, k² = rhoA Omega² / EA.
constexpr double kSteady = 0.0005143174550426011;

struct Spin {
  double u2 = 0, u1 = 0;  // m, largest error
  double steady = 0;      // m, mean u1 from 15 s on
  int rejected = 0;       // steps
};

Spin spin_up(int elements, double h, double rho) {
  model::LineType t = beam_type(2.8e7, 1.4e4, 1.4e4, 1.2);
  t.GA = 1e7;
  t.rotary_inertia = Vec3(1.2e-3, 6e-4, 6e-4);
  model::Case c = one_line(t, 10, elements, clamp(Vec3::Zero(), Vec3::UnitX()), {});
  c.lines[0].start = model::Start::straight;
  c.statics.enabled = false;
  c.dynamics.step = h;
  c.dynamics.rho_infinity = rho;
  c.dynamics.duration = 20;
  Simulation s(PETSC_COMM_SELF, c);
  std::vector<TiedNode> supports = s.system().tied_nodes().nodes();
  supports.at(0).body = 0;
  s.system().tie(supports, [](int, double time) { return root(time); });
  Dynamics& d = s.dynamics();
  d.start(s.state());
  Spin out;
  size_t next = 0;
  long count = 0;
  integrate(d, 20, 0.5, [&](const StepInfo& i) {
    const Vec3 u = root(i.time).rotation.conjugate() * d.committed().s.x.back() - Vec3(10, 0, 0);
    const Quat& q = d.committed().s.q.front();  // the prescribed motion is exact
    EXPECT_LT(log_so3(q.conjugate() * root(i.time).rotation).norm(), 1e-13);
    EXPECT_LT((d.committed().s.w.front() - root(i.time).angular_velocity).norm(), 1e-12);
    // Without contact the steps are the given ones.
    EXPECT_NEAR(i.h, h, 1e-9 * h);
    out.rejected += i.rejected;
    if (i.time > 15 - 1e-9) {
      out.steady += u.x();
      ++count;
    }
    if (next < std::size(kTip) && std::abs(i.time - kTip[next][0]) < 1e-6) {
      out.u1 = std::max(out.u1, std::abs(u.x() - kTip[next][1]));
      out.u2 = std::max(out.u2, std::abs(u.y() - kTip[next][2]));
      ++next;
    }
  });
  EXPECT_EQ(next, std::size(kTip));
  out.steady /= static_cast<double>(count);
  return out;
}

TEST(Dynamics, SpinUp) {
  for (const double h : {0.02, 0.01, 0.005}) {
    const Spin s = spin_up(20, h, 0.8);
    printf(
        "spin-up, 20 elements, h = %.3f s: u2 off by %.2f %% of 0.571 m, u1 by %.2e m, steady u1 %+.2f %%\n",
        h, s.u2 / 0.571 * 100, s.u1, (s.steady / kSteady - 1) * 100);
    EXPECT_EQ(s.rejected, 0);
    EXPECT_LT(s.u2, 0.01 * 0.571);
    EXPECT_LT(s.u1, 0.01 * 0.571);
    EXPECT_NEAR(s.steady / kSteady, 1, 0.01);
  }
}

}  // namespace
}  // namespace hawser::test::dynamics_spin_up_test
