// A free beam thrown by a force and a moment at one end (Simo & Vu-Quoc 1988, three-dimensional case) against
// spectral elements and closed forms of momentum and centre of mass.
#include <algorithm>

#include "verification/dynamics_rig.hpp"

namespace hawser::test::dynamics_spaghetti_test {
namespace {

// (t, A, B), m: spectral elements of order 12; they differ from those of order 10 by 2e-4 m at 15 s.
constexpr double kEnds[][7] = {
    {2.5, 3.4129558857, 0.1969044721, 0.017352356, 4.0238073867, 8.4955198448, -0.7330200779},
    {5.0, 19.5627630939, 1.5213310965, -1.507690582, 11.8788293429, 6.8813530781, 1.8300159541},
    {7.5, 31.9589188672, 1.6220766516, -1.9170376032, 24.0961953169, 6.7194675073, 1.5363175527},
    {10.0, 44.4023781869, 1.6690243517, -2.0652839259, 36.4089565431, 6.3354912083, 1.6789938495},
    {12.5, 57.2343190834, 2.2725892202, -1.9673620458, 49.3256592622, 6.4760634327, 2.2124997795},
    {15.0, 69.3649166198, 2.1958945974, -2.5419686829, 61.3777235151, 6.0153230808, 1.9826952592}};
// After the load has ended; momentum and centre of mass in closed form, the rest from the same solution.
const Vec3 kMomentum(50, 0, 0), kAngular(0, -295.7030789, -553.0014685);
constexpr double kEnergy = 884.1267441;
double centre(double t) { return t < 3 ? 3 + 4 * t * t * t / 30 : 15.5 + 5 * (t - 5); }  // not in (2.5, 5)

TEST(Dynamics, FlyingSpaghetti) {
  constexpr int n = 20;
  constexpr double h = 0.005;
  model::LineType t = beam_type(1e4, 500, 500, 1);
  t.GA = 1e4;
  t.rotary_inertia = Vec3::Constant(10);
  model::Case c = one_line(t, 10, n, {}, {});
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {{6, 0, 0}, {0, 8, 0}};
  c.statics.enabled = false;
  c.dynamics.duration = 15;
  c.dynamics.step = h;
  c.dynamics.rho_infinity = 0.9;
  c.dynamics.tolerance = 1e-12;
  Simulation s(PETSC_COMM_SELF, c);
  s.system().add(
      std::make_unique<TimedLoad>(s.local(), 0, Vec3(0.1, 0, 0), Vec3(0, -0.5, -1), [](double time) {
        return time < 2.5 ? 80 * time : time < 5 ? 200 * (2 - time / 2.5) : 0.0;
      }));
  Dynamics& d = s.dynamics();
  d.start(s.state());

  double ends = 0, late = 0, com = 0, linear = 0, angular = 0, energy = 0, kept = 0;
  Vec3 momentum_at_7 = Vec3::Zero();
  size_t next = 0;
  integrate(d, 15, 0.5, [&](const StepInfo& i) {
    const Kinematics k = d.committed_kinematics();
    if (at_mark(i.time, 2.5) && next < std::size(kEnds)) {
      const double* p = kEnds[next++];
      ASSERT_NEAR(i.time, p[0], 1e-9);
      const double off = std::max((k.x.front() - Vec3(p[1], p[2], p[3])).norm(),
                                  (k.x.back() - Vec3(p[4], p[5], p[6])).norm());
      (i.time < 10.1 ? ends : late) = std::max(i.time < 10.1 ? ends : late, off);
      Vec3 mean = Vec3::Zero();  // of the cubic between nodes
      for (size_t e = 0; e + 1 < k.x.size(); ++e) {
        const Vec3 t1 = k.q[e] * Vec3::UnitX();
        const Vec3 t2 = k.q[e + 1] * Vec3::UnitX();
        mean += (0.5 * (k.x[e] + k.x[e + 1]) + 0.5 / 12 * (t1 - t2)) / n;
      }
      com = std::max(com, std::abs(mean.x() - centre(i.time)));
      com = std::max(com, (mean - Vec3(mean.x(), 4, 0)).norm());
    }
    if (i.time < 5 - 1e-9 || !at_mark(i.time, 0.5)) return;
    const Momentum p = momentum(s.system(), k);
    linear = std::max(linear, (p.linear - kMomentum).norm() / kMomentum.norm());
    // The transient of the scheme after the load's kinks decays by 0.9 a step and is gone after 400 steps.
    if (std::abs(i.time - 7) < 1e-9) momentum_at_7 = p.linear;
    if (i.time > 7) kept = std::max(kept, (p.linear - momentum_at_7).norm() / kMomentum.norm());
    angular = std::max(angular, (p.angular - kAngular).norm() / kAngular.norm());
    energy = std::max(energy, std::abs(total(s.system().energy(k)) / kEnergy - 1));
  });
  EXPECT_EQ(next, std::size(kEnds));
  printf(
      "spaghetti, %d elements, h = %g s: ends off by %.4f m to 10 s, %.4f m to 15 s; centre of mass %.1e m; "
      "relative: momentum %.1e, its change after 7 s %.1e, angular %.1e, energy %.1e\n",
      n, h, ends, late, com, linear, kept, angular, energy);
  EXPECT_LT(ends, 0.2);
  EXPECT_LT(late, 0.3);
  EXPECT_LT(com, 1e-3);
  EXPECT_LT(linear, 1e-8);  // error of second order in the step, from the kinks of the load
  EXPECT_LT(kept, 1e-11);
  EXPECT_LT(angular, 3e-4);
  EXPECT_LT(energy, 1e-3);
}

}  // namespace
}  // namespace hawser::test::dynamics_spaghetti_test
