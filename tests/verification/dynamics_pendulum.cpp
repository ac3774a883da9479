// A flexible, heavy beam hung at one end and released from the horizontal, against spectral elements.
#include <algorithm>

#include "verification/dynamics_rig.hpp"

namespace hawser::test::dynamics_pendulum_test {
namespace {

// (t, x, z of the tip, m, kinetic and elastic energy, J): spectral elements; two meshes agree within 1e-5.
constexpr double kTip[][5] = {{0.5, 9.7055243757, -1.2311874039, 105.0105263, 1.205922915},
                              {1.0, 7.598282556, -4.7649059664, 337.6463145, 2.86544188},
                              {1.5, -0.8443305177, -9.6051223441, 482.6628037, 3.173341273},
                              {2.0, -7.5056369504, -6.1922526792, 347.2920087, 1.696081033},
                              {2.5, -9.3342570155, -2.9395206745, 98.86584419, 1.376855313},
                              {3.0, -9.1396575073, -1.566852627, 16.38113247, 5.536437347}};

struct Pendulum {
  double tip = 0, kinetic = 0, total = 0;  // m, J, J: largest errors
  int steps = 0, rejected = 0;
  double shortest = 1e300, longest = 0;  // s
};

// h > 0: fixed step [s]; else automatic, -h the local error allowed [m].
Pendulum pendulum(int elements, double h, double rho) {
  model::LineType t = beam_type(1e5, 20, 20, 1);
  t.GA = 1e5;
  t.rotary_inertia = Vec3(0.02, 0.01, 0.01);
  model::Case c = one_line(t, 10, elements, anchor(Vec3::Zero()), {});
  c.environment.gravity = 9.81;
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {{0, 0, 0}, {10, 0, 0}};
  c.statics.enabled = false;
  c.dynamics.duration = 3;
  c.dynamics.rho_infinity = rho;
  (h > 0 ? c.dynamics.step : c.dynamics.error_tolerance) = std::abs(h);
  Simulation s(PETSC_COMM_SELF, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  Pendulum out;
  size_t next = 0;
  integrate(d, 3, 0.5, [&](const StepInfo& i) {
    ++out.steps;
    out.rejected += i.rejected;
    out.shortest = std::min(out.shortest, i.h);
    out.longest = std::max(out.longest, i.h);
    const Energy e = s.system().energy(d.committed_kinematics());
    out.total = std::max(out.total, std::abs(total(e)));  // total energy is zero at the start
    if (next == std::size(kTip) || std::abs(i.time - kTip[next][0]) > 1e-6) return;
    const double* p = kTip[next++];
    out.tip = std::max(out.tip, (d.committed().s.x.back() - Vec3(p[1], 0, p[2])).norm());
    out.kinetic = std::max(out.kinetic, std::abs(e.kinetic - p[3]));
  });
  EXPECT_EQ(next, std::size(kTip));
  return out;
}

TEST(Dynamics, HeavyPendulum) {
  for (const auto& [n, h] : {std::pair{20, 2e-3}, {20, 1e-3}, {40, 1e-3}}) {
    const Pendulum p = pendulum(n, h, 0.9);
    printf(
        "pendulum, %d elements, h = %g s: tip off by %.4f m, kinetic energy by %.3f J of 483, total by %.3f "
        "J\n",
        n, h, p.tip, p.kinetic, p.total);
    EXPECT_LT(p.tip, 0.05);
    EXPECT_LT(p.kinetic, 0.01 * 482.66);
    EXPECT_LT(p.total, 0.005 * 482.66);
  }
}

// Automatic steps: they are short where the tip whips at the bottom, and the error decreases with the
// tolerance.
TEST(Dynamics, HeavyPendulumWithAutomaticSteps) {
  double before = 1e300;
  for (const double tolerance : {1e-4, 1e-5, 1e-6}) {
    const Pendulum p = pendulum(40, -tolerance, 0.8);
    printf(
        "pendulum, 40 elements, local error %g m: tip off by %.4f m, total energy by %.3f J; %d steps of "
        "%.1e to "
        "%.1e s, %d rejected\n",
        tolerance, p.tip, p.total, p.steps, p.shortest, p.longest, p.rejected);
    EXPECT_LT(p.tip, 0.6 * before);
    EXPECT_GT(p.longest, 2 * p.shortest);
    EXPECT_LT(p.rejected, p.steps / 4);
    before = p.tip;
  }
  EXPECT_LT(before, 0.05);
}

}  // namespace
}  // namespace hawser::test::dynamics_pendulum_test
