// A free beam that moves, tumbles and vibrates in three dimensions without damping: quantities that time
// integration should conserve.
#pragma once

#include <algorithm>

#include "verification/dynamics_rig.hpp"

namespace hawser::test {

struct Tumble {
  double energy = 0;   // largest relative change
  double drift = 0;    // relative change of its mean, first to last tenth of the run
  double linear = 0;   // largest change of momentum over its size
  double angular = 0;  // the same
  double strain = 0;   // largest strain energy over total
  // Largest difference, over the largest size, between the directors' acceleration and that of w and alpha,
  // in the first and in the last tenth of the run.
  double apart[2] = {};
  long steps = 0;
};

// The line: 10 m, EI 500 N m², GJ 400 N m², EA 1e5 N, 1 kg/m. Its first free-free bending period is 2 pi L² /
// (4.730² sqrt(EI/m)) = 1.256 s. It starts straight with the velocity (0.3, -0.2, 0.4) m/s, the angular
// velocity (0.3, 0.2, 0.6) rad/s, and 3 m/s at the ends in the first bending mode. Cables have no bending
// mode and a lateral motion instead.
inline constexpr double kFirst = 4.730040744862704;
inline double first_period() { return 2 * M_PI * 100 / (kFirst * kFirst * std::sqrt(500.0)); }

inline model::Case free_line(bool beam, int elements) {
  model::LineType t = beam ? beam_type(1e5, 500, 400, 1) : cable_type(1e3, 1);
  t.rotary_inertia = Vec3(0.02, 0.01, 0.01);
  model::Case c = one_line(t, 10, elements, {}, {});
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {{-5, 0, 0}, {5, 0, 0}};
  c.statics.enabled = false;
  return c;
}

inline void throw_line(State& s, bool bend) {
  const Vec3 V(0.3, -0.2, 0.4);
  const Vec3 W = bend ? Vec3(0.3, 0.2, 0.6) : Vec3(0.6, 0.9, 2);
  const double b = kFirst;
  const double k = (std::cosh(b) - std::cos(b)) / (std::sinh(b) - std::sin(b));
  for (size_t i = 0; i < s.x.size(); ++i) {
    const double z = b * (s.x[i].x() / 10 + 0.5);
    const double shape = bend ? 1.5 * (std::cosh(z) + std::cos(z) - k * (std::sinh(z) + std::sin(z))) : 0;
    const double slope =
        bend ? 1.5 * b / 10 * (std::sinh(z) - std::sin(z) - k * (std::cosh(z) + std::cos(z))) : 0;
    s.v[i] = V + W.cross(s.x[i]) + Vec3(0, 0, shape);
    if (bend) s.w[i] = s.q[i].conjugate() * (W - Vec3(0, slope, 0));
  }
}

// `periods` first bending periods of the free beam with `per_period` steps a period; 0: automatic steps.
inline Tumble tumble(model::Case c, bool beam, int per_period, double rho, int periods,
                     double tolerance = 1e-13) {
  const double until = periods * first_period();
  c.dynamics.duration = until;
  c.dynamics.step = per_period ? first_period() / per_period : 0;
  c.dynamics.rho_infinity = rho;
  c.dynamics.tolerance = tolerance;
  Simulation s(PETSC_COMM_SELF, c);
  throw_line(s.state(), beam);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const double e0 = total(s.system().energy(d.committed_kinematics()));
  const Momentum p0 = momentum(s.system(), d.committed_kinematics());
  Tumble out;
  const long every = std::max(1, periods * per_period / 500);
  long step = 0, samples[2] = {};
  double mean[2] = {}, apart[2] = {}, size = 0;
  integrate(d, until, until, [&](const StepInfo&) {
    const Kinematics k = d.committed_kinematics();
    const Energy e = s.system().energy(k);
    out.energy = std::max(out.energy, std::abs(total(e) / e0 - 1));
    out.strain = std::max(out.strain, e.strain / e0);
    const bool late = k.time > 0.9 * until;
    if (late || k.time < 0.1 * until) {
      mean[late] += total(e) / e0;
      ++samples[late];
    }
    if (beam && (late || k.time < 0.1 * until))
      for (size_t i = 0; i < k.q.size(); ++i) {
        const Mat3 exact = director_acceleration(k.q[i], k.w[i], k.alpha[i]);
        double& most = apart[late];
        most = std::max(most, (k.directors[i] - exact).norm());
        size = std::max(size, exact.norm());
      }
    if (++step % every) return;
    const Momentum p = momentum(s.system(), k);
    out.linear = std::max(out.linear, (p.linear - p0.linear).norm() / p0.linear.norm());
    out.angular = std::max(out.angular, (p.angular - p0.angular).norm() / p0.angular.norm());
  });
  out.drift = mean[1] / static_cast<double>(samples[1]) - mean[0] / static_cast<double>(samples[0]);
  out.steps = step;
  for (int i = 0; beam && i < 2; ++i) out.apart[i] = apart[i] / size;
  return out;
}
inline Tumble tumble(bool beam, int elements, int per_period, double rho, int periods,
                     double tolerance = 1e-13) {
  return tumble(free_line(beam, elements), beam, per_period, rho, periods, tolerance);
}

inline void show(const char* what, double rho, const Tumble& t) {
  printf(
      "%s, rho = %.1f, %ld steps: relative change of energy %.1e (drift %+.1e), momentum "
      "%.1e, angular momentum %.1e; strain energy up to %.2f of all; directors apart by %.1e, %.1e\n",
      what, rho, t.steps, t.energy, t.drift, t.linear, t.angular, t.strain, t.apart[0], t.apart[1]);
}

}  // namespace hawser::test
