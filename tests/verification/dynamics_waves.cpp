// Waves along a line against closed forms: a plucked taut string, and an elastic bar stopped at one end.
#include <algorithm>

#include "verification/dynamics_rig.hpp"

namespace hawser::test::dynamics_waves_test {
namespace {

// m = 1 kg/m, T = 100 N, L = 10 m stretched, plucked by `height` at midspan. D'Alembert: period 2 s.
struct String {
  double period = 0;   // s, of the first mode, mean over ten
  double quarter = 0;  // m, largest error at a quarter of the span over the first period
};

String string(int elements, double h, double rho, bool beam) {
  constexpr double T = 100;
  constexpr double L = 10;
  constexpr double EA = 2e4;
  constexpr double height = 0.01;
  constexpr double stretch = 1 + T / EA;
  model::LineType t = beam ? beam_type(EA, 1e-3, 1e-3, stretch) : cable_type(EA, stretch);
  t.rotary_inertia = Vec3::Constant(1e-6);
  model::Case c = one_line(t, L / stretch, elements, anchor(Vec3::Zero()), anchor({L, 0, 0}));
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {{0, 0, 0}, {L / 2, 0, height}, {L, 0, 0}};
  c.statics.enabled = false;
  c.dynamics.duration = 21;
  c.dynamics.step = h;
  c.dynamics.rho_infinity = rho;
  Simulation s(PETSC_COMM_SELF, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  auto mode = [&] {
    double a = 0;
    for (const Vec3& x : d.committed().s.x) a += x.z() * std::sin(M_PI * x.x() / L);
    return a;
  };
  // u(L/4): h/2 until the kink passes at L/4c = 0.25 s, then decreasing to -h/2 at 0.75 s, constant until
  // 1.25 s, and back.
  auto quarter = [](double time) {
    return height * std::clamp(time < 1 ? 1 - 2 * time : 2 * time - 3, -0.5, 0.5);
  };
  String out;
  std::vector<double> crossings;
  double before = mode();
  double t0 = 0;
  integrate(d, 21, 1, [&](const StepInfo& i) {
    const double now = mode();
    if (before > 0 && now <= 0) crossings.push_back(t0 + i.h * before / (before - now));
    before = now;
    t0 = i.time;
    if (i.time <= 2)
      out.quarter = std::max(
          out.quarter, std::abs(d.committed().s.x[static_cast<size_t>(elements) / 4].z() - quarter(i.time)));
  });
  EXPECT_EQ(crossings.size(), 11u);
  out.period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  out.quarter /= height;
  return out;
}

TEST(Dynamics, TautString) {
  for (const bool beam : {false, true}) {
    const String s = string(40, 0.01, 1, beam);
    printf(
        "string of %s, 40 elements, h = 0.01 s: period %.5f s (exact 2, %+.3f %%), a quarter along off by "
        "%.1f "
        "%% of the pluck\n",
        beam ? "beams" : "cables", s.period, (s.period / 2 - 1) * 100, s.quarter * 100);
    EXPECT_NEAR(s.period, 2, 0.002 * 2);
    EXPECT_LT(s.quarter, 0.05);
  }
}

// A steel bar moves along its axis at 1 m/s when one end is stopped. The force there is rho c A v until the
// wave from the free end returns at 2 L/c; then the whole bar moves back. E = 210 GPa, A = 0.01 m², rho =
// 7850 kg/m³, L = 10 m.
TEST(Dynamics, StoppedBar) {
  constexpr double E = 210e9, A = 0.01, rho = 7850, L = 10, v = 1;
  const double c = std::sqrt(E / rho);
  const double F = rho * c * A * v;
  const double back = 2 * L / c;
  constexpr int n = 100;
  model::LineType t = beam_type(E * A, 1e6, 1e6, rho * A);
  t.rotary_inertia = Vec3::Constant(1e-3);
  model::Case bar = one_line(t, L, n, anchor(Vec3::Zero()), {});
  bar.lines[0].start = model::Start::points;
  bar.lines[0].points = {{0, 0, 0}, {L, 0, 0}};
  bar.statics.enabled = false;
  bar.dynamics.duration = 1.5 * back;
  bar.dynamics.step = back / 400;
  bar.dynamics.rho_infinity = 0.8;
  Simulation s(PETSC_COMM_SELF, bar);
  State state = s.state();
  for (size_t i = 1; i < state.v.size(); ++i) state.v[i] = Vec3(-v, 0, 0);
  Dynamics& d = s.dynamics();
  d.start(state);
  const size_t root = 3 * static_cast<size_t>(s.local().block[0]);
  double sum = 0, worst = 0, released = 0, before = 0, impulse = 0;
  int count = 0;
  double momentum_back = 0;
  integrate(d, 1.5 * back, back, [&](const StepInfo& i) {
    const double f = s.system().reactions()[root];
    if (i.time > 0.1 * back && i.time < 0.9 * back) {
      sum += f;
      ++count;
      worst = std::max(worst, std::abs(f - F));
    }
    if (released == 0 && i.time > 0.5 * back && f < 0.5 * F)
      released = i.time - i.h * (0.5 * F - f) / (before - f);
    before = f;
    if (i.time < back * (1 + 1e-9)) impulse += f * i.h;
    if (std::abs(i.time - back) < 1e-9 * back)
      momentum_back = momentum(s.system(), d.committed_kinematics()).linear.x();
  });
  const double p = rho * A * L * v;
  printf(
      "stopped bar, %d elements: force %.4f of rho c A v (ripple %.3f), until %.4f of 2L/c, impulse %.4f of "
      "2 p, "
      "momentum at 2L/c %+.4f p\n",
      n, sum / count / F, worst / F, released / back, impulse / (2 * p), momentum_back / p);
  EXPECT_NEAR(sum / count / F, 1, 0.002);
  EXPECT_LT(worst / F, 0.05);
  EXPECT_NEAR(released / back, 1, 0.02);
  EXPECT_NEAR(impulse / (2 * p), 1, 0.02);
  EXPECT_NEAR(momentum_back / p, 1, 0.03);
}

}  // namespace
}  // namespace hawser::test::dynamics_waves_test
